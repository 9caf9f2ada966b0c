// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_study
// The picture of kind = "critical" shows how the outcome follows from the value, not in which order it was found.
#include "bridge/study/critical_figure.hpp"

#include <gmock/gmock.h>

#include "bridge/picture/draw.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::study::critical_figure_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using CriticalFigure = test::OwnFolder;

Outcome run(double value, const char* outcome, const nlohmann::json& factor = nullptr, const char* key = "k") {
  return {{"settings", {setting(key, value)}}, {"outcome", outcome}, {"mode", nullptr}, {"factor", factor}};
}

TEST_F(CriticalFigure, HasTheFactorOverTheValueAndItsTarget) {
  const std::string figure =
      critical_figure({.key = "k", .from = 10, .to = 40, .outcome = "factor", .target = 1.5},
                      {run(10, "fails", 0.5), run(40, "stands", 2), run(25, "stands", 1.25)}, 30);
  EXPECT_THAT(figure, AllOf(HasSubstr("$runs << EOD\n10 0.5\n25 1.25\n40 2\nEOD"), HasSubstr("'factor of safety'"),
                            HasSubstr("'target: 1.5'"), HasSubstr("'found: 30'"), HasSubstr("set xlabel 'k'")));
  EXPECT_NO_THROW(picture::draw({{folder / "a.svg", 800, 600, figure}}));
}

TEST_F(CriticalFigure, HasWordsAtItsAxisAndNoNegativeCohesion) {
  const std::string figure = critical_figure(
      {.key = "joints.bed.cohesion_pa", .target = 1.5},
      {run(0, "fails", 0.5, "joints.bed.cohesion_pa"), run(3e5, "stands", 2, "joints.bed.cohesion_pa")}, 8e4);
  EXPECT_THAT(figure, AllOf(HasSubstr("set xlabel 'joints bed: cohesion (Pa)'"), HasSubstr("set xrange [0:309000]"),
                            HasSubstr("set rmargin 6")));
}

TEST_F(CriticalFigure, HasTheOutcomeOverTheValueWhereThereIsNoFactor) {
  for (const auto& target : {std::optional<double>(), std::optional(1.5)}) {
    const std::string figure = critical_figure({.key = "k", .from = 10, .to = 40, .target = target},
                                               {run(10, "fails"), run(40, "stands"), run(25, "fails")}, 30);
    EXPECT_THAT(figure, AllOf(HasSubstr("$runs << EOD\n10 0\n25 0\n40 1\nEOD"),
                              HasSubstr("set ytics ('fails' 0, 'stands' 1)"), Not(HasSubstr("target"))));
    EXPECT_NO_THROW(picture::draw({{folder / "a.svg", 800, 600, figure}}));
  }
}

}  // namespace
}  // namespace blockweir::study::critical_figure_test
