// SPDX-License-Identifier: GPL-3.0-or-later
// A structure and how its reservoir is filled, as the text of a scene.
#pragma once

#include <utility>

#include "tests/independent/structure.hpp"

namespace blockweir::independent {

struct Filling {
  std::string kind = "dynamic";
  std::string integrator = "shi";
  std::string formulation = "augmented-lagrangian";
  std::string rigid = "named";  ///< which blocks do not strain
  double step_s = 0.01;
  double duration_s = 0;
  std::vector<std::pair<double, double>> levels{};  ///< time, level of the reservoir
  double youngs_modulus_pa = 30e9;
};

std::string scene_text(const Structure& structure, const Filling& filling);

}  // namespace blockweir::independent
