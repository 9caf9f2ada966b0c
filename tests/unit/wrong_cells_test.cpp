// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_study
// Cells of a map that are not as expected have a mark, which the legend explains.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bridge/study/map_figure.hpp"

namespace blockweir::study::wrong_cells_test {
namespace {

TEST(WrongCells, HaveAMarkThatTheLegendExplains) {
  auto cells = nlohmann::json::array();
  cells.push_back({{"shown", "sliding"}, {"verdict", "right"}});
  EXPECT_EQ(legend(cells), "  s sliding\n");
  cells.push_back({{"shown", "stands"}, {"verdict", "wrong"}});
  EXPECT_EQ(legend(cells), "  . stands  s sliding  ! not as expected\n");
}

}  // namespace
}  // namespace blockweir::study::wrong_cells_test
