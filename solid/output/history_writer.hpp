// SPDX-License-Identifier: GPL-3.0-or-later
// history.csv: one row a stored time, one named column a quantity with its unit.
#pragma once

#include "solid/output/frame.hpp"
#include "solid/output/result_file.hpp"

namespace blockweir::solid::output {

class HistoryWriter {
 public:
  HistoryWriter(const std::filesystem::path& folder, const scene::Scene& scene);
  void write(const Frame& frame);

 private:
  ResultFile file_;
  int joints_ = 0;
};

}  // namespace blockweir::solid::output
