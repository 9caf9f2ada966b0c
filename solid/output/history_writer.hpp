// SPDX-License-Identifier: GPL-3.0-or-later
// history.csv: one row for each stored time, one named column with unit for each quantity.
#pragma once

#include <map>
#include <utility>

#include "bridge/results/result_file.hpp"
#include "solid/watch/frame.hpp"

namespace blockweir::solid::output {

/// Columns of joints have their names; unnamed joints, if few, are named as in reports ("wall on rock").
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
  std::map<std::pair<int, int>, std::size_t> unnamed_joints_;  ///< by pair of blocks: index of the columns
  bool shaken_ = false;
};

}  // namespace blockweir::solid::output
