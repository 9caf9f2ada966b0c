// SPDX-License-Identifier: GPL-3.0-or-later
// history.csv: one row a stored time, one named column a quantity with its unit.
#pragma once

#include "bridge/results/result_file.hpp"
#include "solid/watch/frame.hpp"

namespace blockweir::solid::output {

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
  int joints_ = 0;
  bool shaken_ = false;
};

}  // namespace blockweir::solid::output
