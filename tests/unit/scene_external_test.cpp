// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// [fluid] model = "external": what the reader takes and refuses.
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene::scene_external_test {
namespace {

using namespace sample;
using testing::HasSubstr;

const std::string hydrostatic = "model = \"hydrostatic\"";
const std::string level = "upstream_level_m = { table = [[0, 1], [2, 3]] }";

/// The sample's [fluid] with these keys.
Scene fluid(const std::string& keys) {
  return read_text(with(hydrostatic, keys), "s.toml").scene;
}

TEST(SceneExternal, HasACommandThatIsAListOfWords) {
  const Scene scene =
      fluid("model = \"external\"\nexternal = { command = [\"python3\", \"my water.py\"], remembers = false }");
  EXPECT_EQ(scene.fluid, FluidModel::external);
  EXPECT_EQ(scene.external.command, (std::vector<std::string>{"python3", "my water.py"}));
  EXPECT_FALSE(scene.external.remembers);
  EXPECT_EQ(scene.coupling.open_timeout_s, scene.coupling.timeout_s);
}

TEST(SceneExternal, WithoutACommandLeavesTimeToStartItByHand) {
  const Scene scene = fluid("model = \"external\"");
  EXPECT_TRUE(scene.external.command.empty());
  EXPECT_TRUE(scene.external.remembers);
  EXPECT_EQ(scene.coupling.open_timeout_s, 600);
}

TEST(SceneExternal, NeedsNoWaterAndNoLevel) {
  std::string dry = with(hydrostatic, "model = \"external\"");
  dry = with(std::string("[water]\n") + level, "", dry);
  const Scene scene = read_text(dry, "s.toml").scene;
  EXPECT_EQ(scene.fluid, FluidModel::external);
  EXPECT_FALSE(scene.water.upstream_level_m);
}

TEST(SceneExternal, WordsThatAreNoneAreRefused) {
  const auto refused = [](const std::string& command, const std::vector<std::string>& words) {
    expect_error(with(hydrostatic, "model = \"external\"\nexternal = { command = " + command + " }"), 48, words);
  };
  refused("\"python3 water.py\"", {"command", "a list of texts"});
  refused("[\"\", \"x\"]", {"command begins with an empty word"});
  refused("[1, 2]", {"command", "a list of texts"});
}

TEST(SceneExternal, ACommandBesideAnotherModelIsRefused) {
  expect_error(with(hydrostatic, hydrostatic + "\nexternal = { command = [\"x\"] }"), 48,
               {"[fluid.external] beside another model"});
}

TEST(SceneExternal, SeveralFluidsAreRefusedWithAReason) {
  expect_error(with("[fluid]\n" + hydrostatic, "[[fluid]]\n" + hydrostatic + "\n[[fluid]]\nmodel = \"external\""), 46,
               {"[[fluid]], a list of 2 fluids; each window has one partner, who answers for all water", "one [fluid]",
                "let one program compute all of the water"});
}

TEST(SceneExternal, FlowInJointsIsRefused) {
  const auto found = errors(with("cohesion_pa = 1e5", "cohesion_pa = 1e5\nuplift = \"flow\"\naperture_m = 1e-3",
                                 with(hydrostatic, "model = \"external\"")));
  EXPECT_THAT(found, testing::Contains(HasSubstr("uplift = \"flow\" with model = \"external\"")));
}

TEST(SceneExternal, UpliftThatNobodyComputesIsWarnedOf) {
  const ReadScene read = read_text(
      with("cohesion_pa = 1e5", "cohesion_pa = 1e5\nuplift = \"full\"", with(hydrostatic, "model = \"external\"")),
      "s.toml");
  std::string all;
  for (const auto& warning : read.warnings) all += warning.text() + "\n";
  EXPECT_THAT(all, HasSubstr("uplift of joint \"crack\" has no effect in a run with model = \"external\""));
}

}  // namespace
}  // namespace blockweir::scene::scene_external_test
