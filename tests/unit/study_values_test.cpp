// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_study
// Numbers of a study are those that a user would type.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "bridge/study/open_study.hpp"
#include "tests/own_folder.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::study::study_values_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(StudyValues, ATableHasNoDigitsThatOnlyRoundingLeaves) {
  const std::vector<Outcome> runs{{{"settings", {"a=22"}},
                                   {"outcome", "fails"},
                                   {"level_m", 13.399999999999999},
                                   {"level_is_bound", false},
                                   {"time_s", 3.3000000000000003},
                                   {"simulated_s", 4}}};
  EXPECT_EQ(outcome_table({"a"}, runs),
            "run,a,outcome,mode,joint,level_m,level_uncertainty_m,level_is_bound,head_m,time_s,sliding_factor,factor,"
            "simulated_s,wall_time_s,trouble\n1,22,fails,,,13.4,,false,,3.3,,,4,,\n");
}

/// A run fails where the key's value is above 0.18.
class FailsAbove : public engine::Engine {
 public:
  bool perform(const engine::Work& work, const engine::OnAnswer& on_answer) override {
    for (std::size_t i = 0; i < work.items.size(); ++i) {
      const double value = std::stod(work.items[i]["settings"][0].get<std::string>().substr(key.size() + 1));
      on_answer(i, {{"outcome", value > 0.18 ? "fails" : "stands"}, {"mode", nullptr}, {"factor", nullptr}});
    }
    return true;
  }
  static constexpr std::string_view key = "joint.friction_angle_deg";
};

class Bisection : public test::OwnFolder {};

TEST_F(Bisection, TheMiddleOfABracketIsAValueThatAUserWouldType) {
  std::ofstream(folder / "scene.toml") << scene::sample::text;
  FailsAbove engine;
  OutcomeRuns runs({.name = "s", .scene = folder / "scene.toml", .set = {}, .overrides = {}, .kept = folder / "kept"},
                   engine);
  const scene::CriticalValue friction{.key = std::string(FailsAbove::key), .from = 0.1, .to = 0.2, .width = 0.3};
  const Finding found = critical_task({.name = "s", .line = 1, .question = friction}, 1).find(runs);
  EXPECT_EQ(found.runs.back()["settings"], json::array({"joint.friction_angle_deg=0.15"}));
  EXPECT_EQ(found.answer["bracket"].dump(), "[0.15,0.2]");
  EXPECT_EQ(found.answer["value"].dump(), "0.175");
}

}  // namespace
}  // namespace blockweir::study::study_values_test
