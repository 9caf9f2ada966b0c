// SPDX-License-Identifier: GPL-3.0-or-later
// Water that answers accelerations, for ParaView: reservoir.pvd, its quadratic triangles with the pressure at their
// nodes, each [output] frame_every_s.
#pragma once

#include "bridge/scene/hydrostatics.hpp"
#include "bridge/vtk/collection.hpp"
#include "fluid/reservoir/answering_water.hpp"

namespace blockweir::reservoir {

class ReservoirOutput {
 public:
  /// Files go to `folder`. Throws std::runtime_error when they cannot be written, here and later.
  ReservoirOutput(const scene::Scene& scene, const std::filesystem::path& folder);

  /// Without the stretches in which waves are damped.
  void record(double time_s, const std::vector<AnsweringWater>& waters);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(files_, next_s_, frame_);
  }

 private:
  struct Picture {
    vtk::Grid grid;
    vtk::Array& pressure = grid.point_data("pressure_pa", 1);
    vtk::Array& added = grid.point_data("added_pressure_pa", 1);
  };
  void add(const AnsweringWater& water, Picture& picture) const;

  const scene::Scene& scene_;
  vtk::Collection files_;
  double next_s_ = 0;
  long frame_ = 0;
};

}  // namespace blockweir::reservoir
