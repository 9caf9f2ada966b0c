// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/step_workspace.hpp"

namespace blockweir::solid {

StepWorkspace::StepWorkspace(const Model& of_model, State& of_state)
    : model(of_model),
      state(of_state),
      trial(model, state),
      formulation(make_formulation(model.scene.contact.formulation, model.laws, model.contact_settings())) {
  if (model.scene.contact.formulation == scene::ContactFormulation::lagrange_multiplier) {
    substitute = make_augmented_lagrangian(model.laws, formulation->settings());
  }
}

}  // namespace blockweir::solid
