// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of the flow through joints. flow.csv: one row every [output] history_every_s. Every frame_every_s:
// joint_water.csv, pressures along all joints, and joint_uplift.csv, one row for each joint with guideline laws. All
// contain the end of the run, even if water at rest was not recorded after the last frame.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bridge/results/result_file.hpp"
#include "fluid/joints/flow_in_joints.hpp"

namespace blockweir::joints {

class FlowTables {
 public:
  /// Writes to `folder`. Throws std::runtime_error if files cannot be written, here and later.
  FlowTables(const scene::Scene& scene, std::filesystem::path folder);
  /// Writes the run's end: the flow that was recorded last must still exist.
  ~FlowTables();
  FlowTables(const FlowTables&) = delete;
  FlowTables& operator=(const FlowTables&) = delete;

  void record(double time_s, const FlowInJoints& flow);
  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);

  /// The last recorded flow, if it has no frame yet and has not advanced since; otherwise null.
  [[nodiscard]] const FlowInJoints* without_frame() const;
  [[nodiscard]] double last_time_s() const { return last_time_s_; }

 private:
  [[nodiscard]] std::string header() const;
  [[nodiscard]] std::string row(double time_s, const FlowInJoints& flow) const;
  /// Rows for joint_water.csv and joint_uplift.csv at one time.
  [[nodiscard]] std::string pressures(double time_s, const FlowInJoints& flow) const;
  [[nodiscard]] std::string uplifts(double time_s, const FlowInJoints& flow) const;
  void add_frame(const std::string& pressures, const std::string& uplifts);

  const scene::Scene& scene_;
  std::filesystem::path folder_;
  std::optional<results::ResultFile> rows_;
  const FlowInJoints* last_ = nullptr;  ///< last record since the start or restart
  std::string last_row_;                ///< of the last record, written or not
  double last_time_s_ = 0;
  bool has_row_ = false;
  bool has_frame_ = false;
  std::string kept_pressures_;  ///< of a last record without a frame at the restart
  std::string kept_uplifts_;
  std::optional<results::ResultFile> along_;
  std::optional<results::ResultFile> uplifts_;
  double next_row_s_ = 0;
  double next_frame_s_ = 0;
};

}  // namespace blockweir::joints
