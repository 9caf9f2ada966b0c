// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Every case, with its variants and studies, meets its figures: maps at their corners, sides and middles, those with
// OpenFOAM in a short and coarse version. `blockweir validate` runs all at full length.
#include "tests/cases.hpp"
#include "tests/openfoam.hpp"

namespace blockweir::test::cases_test {
namespace {

class Cases : public Processes, public testing::WithParamInterface<std::string> {};

TEST_P(Cases, MeetsItsFigures) {
  EXPECT_EQ(shell(programs + "/blockweir validate --short " + cases + GetParam()), 0) << text("out");
  EXPECT_THAT(text("out"), testing::HasSubstr("all within tolerance"));
}

class OpenFoamCases : public OpenFoam, public testing::WithParamInterface<std::string> {};

TEST_P(OpenFoamCases, MeetsItsFiguresInShort) {
  int versions = 0;
  for (const Short& version : short_versions()) {
    if (version.of != GetParam()) continue;
    const std::string out = "o" + std::to_string(versions++);
    EXPECT_EQ(run(cases + version.of, out, version.options()), 0) << text("out");
    const auto summary = nlohmann::json::parse(text(out + "/summary.json"), nullptr, false);
    ASSERT_TRUE(summary.contains("checks")) << text("out");
    EXPECT_FALSE(summary["checks"].empty());
    for (const auto& check : summary["checks"]) EXPECT_TRUE(check["passed"].get<bool>()) << check.dump();
  }
  EXPECT_GT(versions, 0) << "give the case a short version in this file";
}

INSTANTIATE_TEST_SUITE_P(Of, Cases, testing::ValuesIn(all_cases(false)), name_of);
INSTANTIATE_TEST_SUITE_P(Of, OpenFoamCases, testing::ValuesIn(all_cases(true)), name_of);

}  // namespace
}  // namespace blockweir::test::cases_test
