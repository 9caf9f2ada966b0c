// SPDX-License-Identifier: GPL-3.0-or-later
// Two runs whose results must not differ by a bit.
#pragma once

#include "tests/processes.hpp"

namespace blockweir::test {

class SameResults : public Processes {
 protected:
  /// `except`: what the counts of one run need not share with the other's, by the beginning of its name.
  void expect_same(const std::string& a, const std::string& b, const std::string& except = "none") const {
    for (const char* file : {"/history.csv", "/frames.jsonl", "/blocks.pvd", "/reservoir.pvd", "/flow.csv",
                             "/joint_water.csv", "/joint_uplift.csv"}) {
      EXPECT_EQ(text(a + file), text(b + file)) << file;
    }
    EXPECT_EQ(lasting(a, except), lasting(b, except));
    for (const auto& entry : fs::directory_iterator(folder / a / "frames")) {
      const std::string name = "/frames/" + entry.path().filename().string();
      EXPECT_EQ(text(a + name), text(b + name)) << name;
    }
  }
  /// The summary but for what a clock says.
  [[nodiscard]] std::string lasting(const std::string& run, const std::string& except = "none") const {
    auto summary = nlohmann::json::parse(text(run + "/summary.json"));
    for (const char* timed : {"profile_s", "wall_time_s", "peak_memory_mb", "skips"}) summary.erase(timed);
    const nlohmann::json counts = summary["counts"];
    for (const auto& [name, count] : counts.items()) {
      if (name.starts_with(except)) summary["counts"].erase(name);
    }
    return summary.dump(1);
  }
};

}  // namespace blockweir::test
