// SPDX-License-Identifier: GPL-3.0-or-later
// history.csv: one row a stored time, one named column a quantity with its unit.
#pragma once

#include <map>
#include <utility>

#include "bridge/results/result_file.hpp"
#include "solid/watch/frame.hpp"

namespace blockweir::solid::output {

/// Joints have columns by their names; those without one are called as reports do ("wall on rock"), where few.
class HistoryWriter {
 public:
  HistoryWriter(const std::filesystem::path& folder, const scene::Scene& scene, results::Begin begin);
  void write(const Frame& frame);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(file_);
  }

 private:
  results::ResultFile file_;
  std::size_t named_joints_ = 0;
  std::map<std::pair<int, int>, std::size_t> unnamed_joints_;  ///< by their blocks; the place among all joints' columns
  bool shaken_ = false;
};

}  // namespace blockweir::solid::output
