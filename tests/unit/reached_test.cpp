// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_process
// How far a run came that has no summary.
#include "bridge/process/reached.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace blockweir::process::reached_test {
namespace {

std::string told_of(const std::string& history) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "reached";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "history.csv") << history;
  const nlohmann::json found = reached(folder);
  std::filesystem::remove_all(folder);
  return found.is_null() ? "" : found["text"];
}

TEST(Reached, IsTheLastWholeRow) {
  const std::string head = "time_s,upstream_level_m,downstream_level_m\n";
  EXPECT_EQ(told_of(head + "0,2,nan\n0.5,2.05,nan\n0.6,2.0"), "it came to 0.5 s, at a level of 2.05 m");
  EXPECT_EQ(told_of(head + "0.25,nan,nan\n"), "it came to 0.25 s");
  EXPECT_EQ(told_of(head), "");
  EXPECT_EQ(told_of(""), "");
}

}  // namespace
}  // namespace blockweir::process::reached_test
