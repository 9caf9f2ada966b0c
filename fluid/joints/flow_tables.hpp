// SPDX-License-Identifier: GPL-3.0-or-later
// What flows through joints, as tables: flow.csv, a row each [output] history_every_s and one of the end; each
// frame_every_s joint_water.csv, pressures along all joints, and joint_uplift.csv, a row a joint beside guideline laws.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bridge/results/result_file.hpp"
#include "fluid/joints/flow_in_joints.hpp"

namespace blockweir::joints {

class FlowTables {
 public:
  /// Files go to `folder`. Throws std::runtime_error when they cannot be written, here and later.
  FlowTables(const scene::Scene& scene, std::filesystem::path folder);
  /// Writes the row of the run's end.
  ~FlowTables();
  FlowTables(const FlowTables&) = delete;
  FlowTables& operator=(const FlowTables&) = delete;

  void record(double time_s, const FlowInJoints& flow);
  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);

 private:
  [[nodiscard]] std::string header() const;
  [[nodiscard]] std::string row(double time_s, const FlowInJoints& flow) const;
  void add_pressures(double time_s, const FlowInJoints& flow);
  void add_uplifts(double time_s, const FlowInJoints& flow);

  const scene::Scene& scene_;
  std::filesystem::path folder_;
  std::optional<results::ResultFile> rows_;
  std::string last_row_;  ///< not yet written
  std::optional<results::ResultFile> along_;
  std::optional<results::ResultFile> uplifts_;
  double next_row_s_ = 0;
  double next_frame_s_ = 0;
};

}  // namespace blockweir::joints
