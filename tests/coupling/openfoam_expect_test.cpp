// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Figures of the water that interFoam's plugin has recorded.
#include "tests/openfoam.hpp"

namespace blockweir::test::openfoam_expect_test {
namespace {

class ExpectWater : public OpenFoam {
 protected:
  [[nodiscard]] int run_expecting(const std::string& block) const {
    const std::string expect = "expect_water=[{quantity=\"force_x_n_per_m\",of=\"" + block + "\",value=5e5}]";
    return run(cases + "hydrostatic-wall", "o",
               cells(10) + set("analysis.duration_s=0.02") + set("block.rider.name=a, b") + set(expect));
  }
};

TEST_F(ExpectWater, FindsBlocksWhateverTheyAreCalled) {
  EXPECT_EQ(run_expecting("a, b"), 0) << text("out");
  EXPECT_EQ(got("o", "force_x_n_per_m of a, b"), 0);
  EXPECT_THAT(text("o/openfoam/water.csv"), testing::HasSubstr(",\"a, b.force_x_n_per_m\","));
}

}  // namespace
}  // namespace blockweir::test::openfoam_expect_test
