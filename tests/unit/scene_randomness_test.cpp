// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// [[random]], [[correlation]] and [reliability]: what is read, and what is refused.
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_randomness_test {
namespace {

using namespace blockweir::scene;
using testing::AllOf;
using testing::HasSubstr;

class Randomness : public sample::SceneFolder {
 protected:
  [[nodiscard]] std::filesystem::path with(const std::string& tables) const {
    return write("s.toml", sample::text + tables);
  }
  /// What is wrong with one variable of these keys.
  [[nodiscard]] std::string wrong(const std::string& keys) const {
    return error(with("[[random]]\nkey = 'joint.friction_angle_deg'\n" + keys));
  }
};

const std::string normal =
    "[[random]]\nname = 'a'\nkey = 'joint.friction_angle_deg'\ndistribution = 'normal'\nmean = "
    "30\ndeviation = 2\n";

std::string of(const std::string& name) {
  return "[[random]]\nname = '" + name +
         "'\nkey = 'joint.cohesion_pa'\ndistribution = 'lognormal'\nmean = 30\ndeviation = 2\n";
}

TEST_F(Randomness, IsReadWithItsCorrelationsAndWhatIsAskedFor) {
  const ReadScene scene =
      read(with(normal + of("b") +
                "least = 1\n[[random]]\nname = 'w'\nset = "
                "['block.top.vertices_m=[[0,2],[{w},2],[3,4],[0,4]]']\ndistribution = 'table'\ntable = "
                "[[2, 0], [2.5, 0.4], [3, 1]]\n[[correlation]]\nbetween = ['a', 'b']\ncoefficient = -0.3\n"
                "[reliability]\nby = 'statics'\nlevel_m = 2\nsampling = 'quasi-random'\nmethods = ['none']\n"));
  ASSERT_THAT(scene.randomness.variables, testing::SizeIs(3));
  EXPECT_EQ(scene.randomness.variables[0].distribution.deviation, 2);
  EXPECT_EQ(scene.randomness.variables[1].distribution.least, 1);
  EXPECT_EQ(scene.randomness.variables[2].distribution.table[1], std::pair(2.5, 0.4));
  EXPECT_EQ(scene.randomness.correlations[0].coefficient, -0.3);
  EXPECT_EQ(scene.randomness.reliability.by, CapacityBy::statics);
  EXPECT_TRUE(scene.randomness.reliability.methods.empty());
}

TEST_F(Randomness, ADistributionHasAWidth) {
  const std::string number = "a distribution without width is a number";
  EXPECT_THAT(wrong("distribution = 'normal'\nmean = 30\ndeviation = 0\n"),
              AllOf(HasSubstr("s.toml:"), HasSubstr("deviation in [[random]]"), HasSubstr(" is 0; expected"),
                    HasSubstr(number), HasSubstr("widen the distribution, or set the key itself")));
  EXPECT_THAT(wrong("distribution = 'uniform'\nfrom = 30\nto = 30\n"),
              AllOf(HasSubstr("goes from 30 to 30"), HasSubstr(number)));
  EXPECT_THAT(wrong("distribution = 'fitted'\nvalues = [3, 3, 3, 3, 3]\n"), HasSubstr(number));
  EXPECT_THAT(wrong("distribution = 'normal'\nmean = 30\ndeviation = -1\n"), HasSubstr("deviation"));
  EXPECT_THAT(wrong("distribution = 'normal'\nmean = 30\ndeviation = 1\nleast = 3\nmost = 3\n"),
              HasSubstr("expected least below most"));
  EXPECT_THAT(wrong("distribution = 'triangular'\nfrom = 1\nto = 2\npeak = 3\n"),
              HasSubstr("expected a value from 1 to 2"));
}

TEST_F(Randomness, ATableOfProbabilitiesRisesFromNoneToAll) {
  for (const char* table :
       {"[[1, 0], [2, 0.5]]", "[[1, 0.1], [2, 1]]", "[[2, 0], [1, 1]]", "[[1, 0], [2, 0.5], [3, 0.4], [4, 1]]"}) {
    EXPECT_THAT(wrong(std::string("distribution = 'table'\ntable = ") + table + "\n"), HasSubstr("is no distribution"))
        << table;
  }
}

TEST_F(Randomness, AVariableKnowsWhereItsValueGoes) {
  EXPECT_THAT(error(with("[[random]]\nname = 'a'\ndistribution = 'uniform'\nfrom = 1\nto = 2\n")),
              HasSubstr("has neither key and set"));
  EXPECT_THAT(error(with("[[random]]\nname = 'a'\nset = ['title=b']\ndistribution = 'uniform'\nfrom = 1\nto = 2\n")),
              HasSubstr("no setting of [[random]] \"a\" holds {a}"));
  EXPECT_THAT(wrong("distribution = 'normal'\nmean = 30\ndeviation = 1\nto = 3\n"),
              AllOf(HasSubstr("whose distribution is \"normal\""), HasSubstr("leave to out")));
  EXPECT_THAT(wrong("distribution = 'gumbel'\n"), HasSubstr("distribution"));
  EXPECT_THAT(error(with(normal + normal)), HasSubstr("a second [[random]] is called \"a\""));
}

TEST_F(Randomness, CorrelationsAreOfOneAndNotAgainstEachOther) {
  const auto pair = [](const char* one, const char* other, const char* coefficient) {
    return std::string("[[correlation]]\nbetween = ['") + one + "', '" + other + "']\ncoefficient = " + coefficient +
           "\n";
  };
  const std::string three = normal + of("b") + of("c");
  EXPECT_THAT(error(with(three + pair("a", "b", "0.9") + pair("b", "c", "0.9") + pair("a", "c", "-0.9"))),
              AllOf(HasSubstr("the correlations contradict each other: their matrix has the eigenvalue -0.8"),
                    HasSubstr("take coefficients nearer to 0")));
  EXPECT_THAT(error(with(three + pair("a", "b", "1.2"))), HasSubstr("a number between -1 and 1"));
  EXPECT_THAT(error(with(three + pair("a", "d", "0.2"))), HasSubstr("no [[random]] is called \"d\""));
  EXPECT_THAT(error(with(three + pair("a", "a", "0.2"))), HasSubstr("a correlation of \"a\" with itself"));
  EXPECT_THAT(error(with(three + pair("a", "b", "0.2") + pair("b", "a", "0.2"))), HasSubstr("a second correlation of"));
}

TEST_F(Randomness, TheLevelIsLookedForAndNotDrawn) {
  const std::string width = "distribution = 'uniform'\nfrom = 1\nto = 2\n";
  const auto keyed = [&](const char* key) {
    return error(with(std::string("[[random]]\nkey = '") + key + "'\n" + width));
  };
  EXPECT_THAT(
      keyed("water.upstream_level_m"),
      AllOf(HasSubstr("[[random]] \"water.upstream_level_m\" sets water.upstream_level_m; expected numbers that"),
            HasSubstr("the one stated has no effect; leave it out: the fragility curve")));
  EXPECT_THAT(keyed("water.upstream_level_m.from"), HasSubstr("that level is looked for"));
  EXPECT_THAT(error(with("[[random]]\nname = 'w'\nset = ['water.upstream_level_m={w}']\n" + width)),
              HasSubstr("[[random]] \"w\" sets water.upstream_level_m"));
}

TEST_F(Randomness, OfCorrelatedVariablesSobolIsNotAskedForByDefault) {
  const std::string two = normal + of("b");
  EXPECT_THAT(read(with(two)).randomness.reliability.methods, testing::ElementsAre("form", "sobol"));
  EXPECT_THAT(
      read(with(two + "[[correlation]]\nbetween = ['a', 'b']\ncoefficient = 0.2\n")).randomness.reliability.methods,
      testing::ElementsAre("form"));
}

TEST_F(Randomness, WhatIsAskedForIsKnown) {
  EXPECT_THAT(error(with("[reliability]\nsamples = 100\n")), HasSubstr("[reliability] and no [[random]]"));
  EXPECT_THAT(error(with(normal + "[reliability]\nmethods = ['fourm']\n")), HasSubstr("did you mean \"form\"?"));
  EXPECT_THAT(error(with(normal + "[reliability]\nby = 'runs'\nmethods = ['form']\n")), HasSubstr("samples alone"));
  EXPECT_THAT(error(with(normal + "[reliability]\nsamples = 3\n")), HasSubstr("samples"));
}

}  // namespace
}  // namespace blockweir::scene_randomness_test
