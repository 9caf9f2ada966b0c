// SPDX-License-Identifier: GPL-3.0-or-later
// Output of the flow through joints: tables, and flow.pvd, the joints as lines, every [output] frame_every_s and at the
// end.
#pragma once

#include "bridge/vtk/collection.hpp"
#include "fluid/joints/flow_tables.hpp"

namespace blockweir::joints {

class FlowOutput {
 public:
  /// Writes to `folder`. Throws std::runtime_error if files cannot be written, here and later.
  FlowOutput(const scene::Scene& scene, const std::filesystem::path& folder);
  /// Adds the frame of the run's end: the flow that was recorded last must still exist.
  ~FlowOutput();
  FlowOutput(const FlowOutput&) = delete;
  FlowOutput& operator=(const FlowOutput&) = delete;

  void record(double time_s, const FlowInJoints& flow);
  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);

 private:
  void add_frame(double time_s, const FlowInJoints& flow);

  const scene::Scene& scene_;
  FlowTables tables_;
  vtk::Collection frames_;
  double next_frame_s_ = 0;
  long frame_ = 0;
};

}  // namespace blockweir::joints
