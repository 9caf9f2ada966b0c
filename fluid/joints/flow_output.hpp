// SPDX-License-Identifier: GPL-3.0-or-later
// What flows through joints, for people and ParaView: flow.csv, a row each [output] history_every_s; and each
// frame_every_s joint_water.csv, pressures along all joints, and flow.pvd, the joints as lines.
#pragma once

#include <optional>
#include <string>

#include "bridge/results/result_file.hpp"
#include "bridge/vtk/collection.hpp"
#include "fluid/joints/flow_in_joints.hpp"

namespace blockweir::joints {

class FlowOutput {
 public:
  /// Files go to `folder`. Throws std::runtime_error when they cannot be written, here and later.
  FlowOutput(const scene::Scene& scene, std::filesystem::path folder);

  void record(double time_s, const FlowInJoints& flow);
  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);

 private:
  [[nodiscard]] std::string header() const;
  void add_row(double time_s, const FlowInJoints& flow);
  void add_pressures(double time_s, const FlowInJoints& flow);
  void add_frame(double time_s, const FlowInJoints& flow);

  const scene::Scene& scene_;
  std::filesystem::path folder_;
  std::optional<results::ResultFile> rows_;
  std::optional<results::ResultFile> along_;
  vtk::Collection frames_;
  double next_row_s_ = 0;
  double next_frame_s_ = 0;
  long frame_ = 0;
};

}  // namespace blockweir::joints
