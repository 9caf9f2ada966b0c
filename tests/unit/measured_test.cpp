// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture
// Measured points for a plot: tables as spreadsheets write them, and slips, each with file and line.
#include "bridge/picture/measured.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <stdexcept>

#include "tests/own_folder.hpp"

namespace blockweir::picture::measured_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Measured : public test::OwnFolder {
 protected:
  [[nodiscard]] std::filesystem::path table(const std::string& text) const {
    std::ofstream(folder / "m.csv") << text;
    return folder / "m.csv";
  }
  [[nodiscard]] std::string refusal(const std::string& text) const {
    try {
      read_measured(table(text));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "read";
  }
};

TEST_F(Measured, TablesAsSpreadsheetsWriteThemAreRead) {
  const History read = read_measured(table("\xEF\xBB\xBFtime_s,\"a, b.x_m\"\r\n 0 ,+1e-3\r\n\"2\",-4\r\n\r\n"));
  EXPECT_THAT(read.column("time_s"), ElementsAre(0, 2));
  EXPECT_THAT(read.column("a, b.x_m"), ElementsAre(1e-3, -4));
}

TEST_F(Measured, SlipsAreToldWithFileAndLineAndWhatIsExpected) {
  const std::string heading = "time_s,a.x_m\n";
  const std::vector<std::array<std::string, 2>> slips = {
      {heading + "0,1\n10,abc\n", "m.csv:3: found \"abc\" in the column \"a.x_m\"; expected a finite number"},
      {heading + "10,\n", "m.csv:2: found \"\" in the column \"a.x_m\"; expected a finite number"},
      {heading + "30,-\n", "m.csv:2: found \"-\" in the column"},
      {heading + "nan,1\n", "m.csv:2: found \"nan\" in the column \"time_s\""},
      {heading + "0,1e400\n", "m.csv:2: found \"1e400\""},
      {heading + "10\n", "m.csv:2: found 1 cell in a row; expected 2 as in the heading, with commas between"},
      {heading + "10,0,0004\n", "m.csv:2: found 3 cells in a row; expected 2 as in the heading"},
      {heading + "10;0.0004\n", "m.csv:2: found 1 cell in a row"},
      {heading, "m.csv:1: found a heading without rows; expected a row for each time that was measured"},
      {"time_s\n0\n", "m.csv:1: found one column, \"time_s\"; expected time_s and columns as in history.csv"},
      {"time_s,a,a\n0,1,2\n", "m.csv:1: found two columns \"a\"; expected one"},
  };
  for (const auto& [text, told] : slips) EXPECT_THAT(refusal(text), HasSubstr(told)) << text;
}

}  // namespace
}  // namespace blockweir::picture::measured_test
