// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// What is said of lines that are no TOML.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "bridge/scene/read/syntax_remedy.hpp"
#include "tests/samples.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene::syntax_remedy_test {
namespace {

using sample::expect_error;
using sample::with;

TEST(SyntaxRemedy, FitsTheSlip) {
  const std::string any = "correct the line; texts stand in quotes, lists in [ ], sections on lines of their own";
  const std::vector<std::pair<std::string, std::string>> lines = {
      {"step_s = 0,01", "write 0.01 with a decimal point"},
      {"fixed = yes", "write true"},
      {"fixed = True  # rock", "write true"},
      {"fixed = on", "write true"},
      {"fixed = off", "write false"},
      {"fixed = No", "write false"},
      {"level_m = 29 m", "write 29 alone: the unit is in the key's name"},
      {"friction_angle_deg = 3.5e1\u00b0", "write 3.5e1 alone: the unit is in the key's name"},
      {"density = 1e400", "write a smaller number"},
      {"uplift = \u201cdrained\u201d", "write straight quotes (\"), not those of a word processor"},
      {"uplift = \"drained  # as \"usual\" here", "a quote is missing: a text begins and ends with one, on one line"},
      {"[analysis]\rstep_s = 1\r", "save the file with line ends of Unix (LF) or Windows (CRLF)"},
      {"step_s = 0.01.2", any},
      {"step_s = 1_", any},
      {"step_s = 0.01\r", any},
      {"step_s", any},
      {"", any},
  };
  for (const auto& [line, remedy] : lines) {
    EXPECT_EQ(remedy_of_syntax(line), remedy) << line;
  }
}

TEST(SyntaxRemedy, StandsInTheErrorOfAScene) {
  expect_error(with("step_s = 0.01", "step_s = 10 ms"), 5, {"a syntax error", "write 10 alone"});
}

}  // namespace
}  // namespace blockweir::scene::syntax_remedy_test
