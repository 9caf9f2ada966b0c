// SPDX-License-Identifier: GPL-3.0-or-later
// Two runs whose results must not differ by a bit.
#pragma once

#include "tests/processes.hpp"

namespace blockweir::test {

class SameResults : public Processes {
 protected:
  void expect_same(const std::string& a, const std::string& b) const {
    for (const char* file : {"/history.csv", "/frames.jsonl", "/blocks.pvd", "/reservoir.pvd"}) {
      EXPECT_EQ(text(a + file), text(b + file)) << file;
    }
    EXPECT_EQ(lasting(a), lasting(b));
    for (const auto& entry : fs::directory_iterator(folder / a / "frames")) {
      const std::string name = "/frames/" + entry.path().filename().string();
      EXPECT_EQ(text(a + name), text(b + name)) << name;
    }
  }
  /// The summary but for what a clock says.
  [[nodiscard]] std::string lasting(const std::string& run) const {
    auto summary = nlohmann::json::parse(text(run + "/summary.json"));
    for (const char* timed : {"profile_s", "wall_time_s", "peak_memory_mb", "skips"}) summary.erase(timed);
    return summary.dump(1);
  }
};

}  // namespace blockweir::test
