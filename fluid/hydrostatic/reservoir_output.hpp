// SPDX-License-Identifier: GPL-3.0-or-later
// Still water for ParaView: reservoir.pvd, triangles with nodal pressures, and the flow through joints.
#pragma once

#include "bridge/vtk/collection.hpp"
#include "fluid/hydrostatic/hydrostatic_model.hpp"
#include "fluid/joints/flow_output.hpp"

namespace blockweir::hydrostatic {

/// Throws std::invalid_argument if VTK files are requested and no folder is given.
void require_folder_of_pictures(const scene::Scene& scene, const std::filesystem::path& folder);

/// The model, which also writes its pools every [output] frame_every_s if requested, and its flow in joints.
class RecordedModel final : public schedule::FluidSide {
 public:
  /// Writes to `folder`. Throws std::runtime_error if files cannot be written, here and later.
  RecordedModel(const scene::Scene& scene, const std::filesystem::path& folder);

  void advance(const wire::Motion& motion, double to_s, wire::Load& load) override;
  void record(double time_s) override;
  [[nodiscard]] std::string state() const override;
  void restore(const std::string& state) override;

  [[nodiscard]] schedule::FluidReport report() const override;

 private:
  void write(double time_s);

  HydrostaticModel model_;
  bool draws_;
  std::optional<joints::FlowOutput> flow_;
  vtk::Collection files_;
  double frame_every_s_;
  double next_s_ = 0;
  int elements_per_depth_;
  std::string last_file_;
  long written_update_ = -1;
  long meshes_ = 0;
  long repeats_ = 0;  ///< VTK files that reuse the previous mesh
  double meshing_s_ = 0;
};

}  // namespace blockweir::hydrostatic
