// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// A figure that the scene does not have what it speaks of is an error of the scene: each row of both tables.
#include <fmt/format.h>

#include <map>

#include "bridge/scene/quantity_table.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_answers_test {
using namespace blockweir::scene;
using sample::errors;
using sample::expect_error;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace {

/// The sample with a bolt and an arch, and one expectation.
std::string expecting(const std::string& lines) {
  return sample::text.substr(0, sample::text.find("[[expect]]")) +
         "[[bolt]]\nname = \"bar\"\nfrom_block = \"base\"\nfrom_m = [0, 1]\nto_m = [-3, 0]\nstiffness_n_per_m2 = 1e9\n"
         "[[arch]]\nname = \"ring\"\nmaterial = \"concrete\"\nmean_radius_m = 5\nthickness_m = 1\nvoussoirs = 9\n"
         "centre_m = [30, 0]\n[[expect]]\n" +
         lines;
}

/// What `of` names in this scene, by subject.
const std::map<Subject, std::string> subject_names = {
    {Subject::none, ""},       {Subject::block, "top"}, {Subject::block_if_any, ""}, {Subject::block_only, "top"},
    {Subject::joint, "crack"}, {Subject::bolt, "bar"},  {Subject::arch, "ring"}};

std::string word_of(const std::string& quantity) {
  return quantity == "invariants" ? "hold" : quantity == "stability" ? "stable" : "stands";
}

std::string entry(const QuantityEntry& answer, const std::string& subject) {
  return fmt::format("quantity = \"{}\"\n{}of = \"{}\"\n{}", answer.name,
                     answer.word ? "word = \"" + word_of(answer.name) + "\"\n" : "value = 1\n", subject,
                     answer.at_point ? "at_m = [0, 4]\n" : "");
}

/// Whether what has this name is such a subject.
bool suits(Subject subject, const std::string& name) {
  switch (subject) {
    case Subject::block:
      return name == "top" || name == "crack";
    case Subject::block_if_any:
      return name.empty() || name == "top" || name == "crack";
    case Subject::none:
      return name.empty();
    default:
      return name == subject_names.at(subject);
  }
}

TEST(SceneAnswers, AWordIsOneThatItsQuantityMayBe) {
  for (const auto& [quantity, meant] :
       {std::pair{"mode", "sliding"}, {"stability", "stable"}, {"invariants", "hold"}}) {
    const std::string wrong = std::string(meant) + "s";
    EXPECT_THAT(
        errors(expecting(fmt::format("quantity = '{}'\nword = '{}'\n", quantity, wrong))),
        Contains(AllOf(HasSubstr(fmt::format("is \"{}\", which {} never is; expected one of ", wrong, quantity)),
                       HasSubstr(fmt::format("did you mean \"{}\"?", meant)))));
  }
}

TEST(SceneAnswers, EachQuantityIsOfWhatItsRowSays) {
  for (const QuantityEntry& answer : quantities()) {
    if (answer.needs == Need::column) continue;
    for (const char* subject : {"", "top", "crack", "bar", "ring"}) {
      if (answer.at_point && subject != std::string("top")) continue;  // the point is looked for in a block
      const auto found = errors(expecting(entry(answer, subject)));
      if (suits(answer.of, subject)) {
        EXPECT_THAT(found, IsEmpty()) << answer.name << " of " << subject;
      } else {
        EXPECT_THAT(found, Contains(AllOf(
                               testing::StartsWith("s.toml:"),
                               HasSubstr(answer.of == Subject::none ? "of in [[expect]] has no effect" : answer.name))))
            << answer.name << " of " << subject;
      }
    }
  }
}

/// What a formula's joint has to state.
std::vector<std::string> law_of(const QuantityEntry& answer) {
  if (answer.name != std::string("cracked-through")) return {};
  return {"joints.crack.uplift=\"cracked\""};
}

TEST(SceneAnswers, EachFormulaIsOfWhatItsRowSays) {
  for (const QuantityEntry& answer : formulas()) {
    for (const char* subject : {"", "top", "crack", "bar", "ring"}) {
      if (answer.at_point && subject != std::string("top")) continue;
      const auto found = errors(expecting(fmt::format("quantity = \"{}\"\nformula = \"{}\"\nof = \"{}\"\n{}",
                                                      answer.word       ? "mode"
                                                      : answer.at_point ? "point_stress_xx_pa"
                                                                        : "largest_penetration_m",
                                                      answer.name, subject, answer.at_point ? "at_m = [0, 4]\n" : "")),
                                law_of(answer));
      if (answer.needs == Need::column) {
        EXPECT_THAT(found, Contains(HasSubstr("needs [fluid.column]")));
      } else if (suits(answer.of, subject) || (answer.of == Subject::none && subject == std::string())) {
        EXPECT_THAT(found, IsEmpty()) << answer.name << " of " << subject;
      } else {
        EXPECT_THAT(found, Not(IsEmpty())) << answer.name << " of " << subject;
      }
    }
  }
}

TEST(SceneAnswers, AFormulaOfOneBlockLeavesOutNeitherLiftsNorTailwater) {
  for (const QuantityEntry& answer : formulas()) {
    if (!answer.one_block) continue;
    const std::string scene =
        expecting(fmt::format("quantity = \"failure_head_m\"\nformula = \"{}\"\nof = \"crack\"\n", answer.name));
    EXPECT_THAT(errors(scene, law_of(answer)), IsEmpty());
    if (!law_of(answer).empty()) continue;
    expect_error(sample::with("between = [\"base\", \"top\"]", "between = [\"ground\", \"base\"]", scene), 67,
                 {fmt::format("formula {} in [[expect]] leaves out block \"top\", which stands on block \"base\"",
                              answer.name)});
    const auto under = [&](const char* level) {
      return errors(scene, {std::string("water.downstream_level_m=") + level});
    };
    EXPECT_THAT(under("{table=[[0, 1], [1, 2.5], [2, 1]]}"),
                Contains(HasSubstr("leaves out the tailwater, which presses block \"top\" above 2 m")));
    EXPECT_THAT(under("1.9"), IsEmpty());
  }
}

TEST(SceneAnswers, AFigureThatNeedsAPartAndHasNoneNamesThoseThereAre) {
  expect_error(expecting("quantity = \"displacement_m\"\nvalue = 1\nof = \"\"\n"), 68,
               {"quantity displacement_m in [[expect]] has no of",
                "expected of = a block, or a joint for the upper of its blocks", "name one of ring-left, ring1"});
  expect_error(expecting("quantity = \"joint_force_n_per_m\"\nvalue = 1\n"), 66, {"has no of", "name one of crack"});
  expect_error(expecting("quantity = \"joint_force_n_per_m\"\nvalue = 1\nof = \"top\"\n"), 68,
               {"quantity joint_force_n_per_m in [[expect]] is of \"top\"; expected of = a joint"});
}

TEST(SceneAnswers, AFigureThatNeedsWaterOrAFaceInASceneWithout) {
  const std::string scene = expecting("quantity = \"water_force_x_n_per_m\"\nvalue = 1\nof = \"top\"\n");
  EXPECT_THAT(errors(scene, {"fluid.model=none"}),
              Contains(HasSubstr("quantity water_force_x_n_per_m in [[expect]] needs [water]")));
  EXPECT_THAT(errors(expecting("quantity = \"wave_speed_m_per_s\"\nvalue = 1\nof = \"top\"\n"), {"face_pressure=[]"}),
              Contains(HasSubstr("needs a [[face_pressure]]")));
  EXPECT_THAT(errors(sample::with("upstream_level_m = {", "downstream_level_m = {",
                                  expecting("quantity = \"largest_penetration_m\"\nformula = \"hydrostatic-force\"\n"
                                            "of = \"top\"\n"))),
              Contains(HasSubstr("formula hydrostatic-force in [[expect]] needs upstream_level_m in [water]")));
}

TEST(SceneAnswers, PointsWordsAndNumbersFitTheirQuantity) {
  expect_error(expecting("quantity = \"point_stress_xx_pa\"\nvalue = 1\nof = \"top\"\n"), 66, {"needs at_m"});
  expect_error(expecting("quantity = \"displacement_m\"\nvalue = 1\nof = \"top\"\nat_m = [0, 4]\n"), 69,
               {"at_m in [[expect]] has no effect: displacement_m is none at a point"});
  expect_error(expecting("quantity = \"mode\"\nvalue = 1\n"), 67,
               {"value in [[expect]] does not fit mode, which is a word"});
  expect_error(expecting("quantity = \"displacement_m\"\nword = \"sliding\"\nof = \"top\"\n"), 67,
               {"word in [[expect]] does not fit displacement_m, which is a number"});
  expect_error(expecting("quantity = \"displacement_m\"\nformula = \"slide-or-topple\"\nof = \"crack\"\n"), 67,
               {"formula in [[expect]] does not fit displacement_m"});
}

TEST(SceneAnswers, StudiesAreHeldToTheSame) {
  const std::string order =
      "[[order]]\nname = \"o\"\nkey = \"analysis.step_s\"\nvalues = [1, 2, 3]\norder = 1\nvalue = 1\n";
  EXPECT_THAT(errors(sample::text + order + "quantity = \"displacement_m\"\n"),
              Contains(HasSubstr("quantity displacement_m in [[order]] \"o\" has no of")));
  const std::string limit = "[[limit]]\nname = \"l\"\nkey = \"joint.friction_angle_deg\"\nfrom = 20\nto = 40\n";
  EXPECT_THAT(errors(sample::text + limit + "formula = \"arch-thickness\"\n"),
              Contains(HasSubstr("formula arch-thickness in [[limit]] \"l\" has no of")));
  EXPECT_THAT(errors(sample::text + limit + "value = 30\nof = \"top\"\n"),
              Contains(HasSubstr("of in [[limit]] \"l\" has no effect")));
  const std::string map =
      "[[map]]\nname = \"m\"\nx_key = \"joint.friction_angle_deg\"\nx_values = [20]\ny_key = \"analysis.step_s\"\n"
      "y_values = [0.01]\n";
  EXPECT_THAT(errors(sample::text + map + "formula = \"slide-or-topple\"\n"),
              Contains(HasSubstr("formula slide-or-topple in [[map]] \"m\" has no of")));
}

}  // namespace
}  // namespace blockweir::scene_answers_test
