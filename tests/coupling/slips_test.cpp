// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json fmt::fmt
// What people get wrong first: check finds it, and answers say what they lack.
#include <fstream>

#include "tests/coupling/answers.hpp"
#include "tests/coupling/masonry_wall.hpp"

namespace blockweir::test::slips_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Slips : public Answers {};

const std::string drained = R"(analysis = { duration_s = 1 }
water = { upstream_level_m = 3 }
joint = { friction_angle_deg = 30, uplift = "drained", drain_m = 0.5, drain_efficiency = 0.5 }
)" + std::string(masonry_wall) +
                            R"([[joints]]
name = "base"
between = ["rock", "wall"]
drain_efficiency = 0.6
)";

TEST_F(Slips, ALoadCaseThatMissesAJointIsWarnedOf) {
  write("s.toml", drained + "[[load_case]]\nname = 'blocked'\nset = ['joint.drain_efficiency=0']\n");
  const std::string missed = "sets joint.drain_efficiency=0, which does not reach joints.base";
  ASSERT_EQ(ask("check s.toml"), 0) << text("out");
  EXPECT_THAT(text("out"), AllOf(HasSubstr(missed), HasSubstr("add \"joints.base.drain_efficiency=0\" to set")));
  ASSERT_EQ(ask("safety s.toml --out o"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr(missed));
  write("s.toml", drained +
                      "[[load_case]]\nname = 'blocked'\nset = ['joint.drain_efficiency=0', "
                      "'joints.base.drain_efficiency=0']\n");
  ASSERT_EQ(ask("check s.toml"), 0) << text("out");
  EXPECT_THAT(text("out"), testing::Not(HasSubstr("does not reach")));
}

TEST_F(Slips, ARandomKeyOfWhatIsNotThereIsFoundByCheck) {
  write("s.toml", drained +
                      "[[random]]\nkey = 'joints.bsae.drain_efficiency'\ndistribution = 'uniform'\n"
                      "from = 0.2\nto = 0.8\n");
  EXPECT_EQ(ask("check s.toml"), 2);
  EXPECT_THAT(text("out"), AllOf(HasSubstr("[[random]]"), HasSubstr("did you mean \"base\"?")));
}

TEST_F(Slips, WhatNoStrengthHoldsIsGivenWithWhatActsOnIt) {
  write("s.toml", drained + "[[line_load]]\nblock = 'wall'\nfrom_m = [0, 5]\nto_m = [1, 5]\nforce_x_n_per_m2 = 9e5\n");
  static_cast<void>(ask("safety s.toml --out o --json a.json"));
  const json found = answer("a.json")["load_cases"][0];
  ASSERT_TRUE(found.contains("loads_on_joints")) << text("out");
  ASSERT_EQ(found["loads_on_joints"].size(), 1U) << found.dump();
  double down = 0;
  for (const json& sum : found["loads_on_joints"][0]["sums"]) {
    if (sum["name"] == "weight") down = sum["y_n_per_m"];
  }
  EXPECT_NEAR(down / (-2300 * 9.81 * 8.75), 1, 1e-9);
  EXPECT_THAT(text("out"), AllOf(HasSubstr("no forces in joints"), HasSubstr("water in joints")));
}

}  // namespace
}  // namespace blockweir::test::slips_test
