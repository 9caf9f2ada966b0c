// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// --set: what it reaches, what it says when wrong, and the text and digest of the scene as it is run.
#include <gtest/gtest.h>

#include <regex>

#include "bridge/scene/read/digest.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_override_test {
using namespace blockweir::scene;
using sample::errors;
using sample::text;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

namespace {

Scene scene_with(const std::vector<std::string>& overrides) {
  return read_text(text, "s.toml", overrides).scene;
}

void expect_refusal(const std::string& argument, const std::vector<std::string>& words) {
  const auto found = errors(text, {argument});
  ASSERT_THAT(found, SizeIs(1)) << argument;
  EXPECT_THAT(found[0], testing::StartsWith("--set " + argument + ": error: "));
  for (const std::string& word : words) EXPECT_THAT(found[0], HasSubstr(word));
}

TEST(SceneOverride, ReachesSectionsAndMakesThoseThatAreAbsent) {
  const Scene scene = scene_with({"analysis.step_s=0.001", "contact.initial_penalty_n_per_m2=5e6", "title=\"other\"",
                                  "material.concrete.poissons_ratio=0.3", "coupling.timeout_s=3"});
  EXPECT_EQ(scene.analysis.step_s, 0.001);
  EXPECT_EQ(scene.contact.initial_penalty_n_per_m2, 5e6);
  EXPECT_EQ(scene.title, "other");
  EXPECT_EQ(scene.materials[0].poissons_ratio, 0.3);
  EXPECT_EQ(scene.coupling.timeout_s, 3);
}

/// As people write them in a scene.
TEST(SceneOverride, MayHaveBlanksAroundItsSign) {
  for (const char* sign : {"=", " = ", " =", "=  ", "\t=\t"}) {
    const std::string number = std::string("analysis.step_s") + sign + "0.001";
    const std::string word = std::string("joints.crack.uplift") + sign + "full ";
    const Scene scene = scene_with({number, word});
    EXPECT_EQ(scene.analysis.step_s, 0.001) << number;
    EXPECT_EQ(scene.joints[0].law.uplift, Uplift::full) << word;
  }
}

TEST(SceneOverride, ReachesListsByNameAndByIndex) {
  const Scene scene =
      scene_with({"block.base.rigid=true", "block.1.initial_spin_deg_per_s=4", "joints.crack.cohesion_pa=0",
                  "water.upstream_level_m={ from = 1, rate_per_s = 1 }", "support.0.point_m=[1, 1]"});
  EXPECT_TRUE(scene.blocks[1].rigid);
  EXPECT_EQ(scene.blocks[1].initial_spin_deg_per_s, 4);
  EXPECT_EQ(scene.joints[0].law.cohesion_pa, 0);
  EXPECT_EQ(scene.water.upstream_level_m->at(2), 3);
  EXPECT_EQ(scene.supports[0].point_m, Point(1, 1));
}

TEST(SceneOverride, ReachesNamesWithDots) {
  const std::string dotted = std::regex_replace(text, std::regex("\"crack\""), "\"lift 1.5\"") +
                             "[material.\"C 20.25\"]\nyoungs_modulus_pa = 3e10\npoissons_ratio = 0.2\n"
                             "density_kg_per_m3 = 2400\n[[variant]]\nname = \"v\"\nset = [\"joints.lift "
                             "1.5.friction_angle_deg=20\"]\n";
  const Scene scene =
      read_text(dotted, "s.toml", {"joints.lift 1.5.cohesion_pa=2e5", "material.C 20.25.density_kg_per_m3=2300"}).scene;
  EXPECT_EQ(scene.joints[0].law.cohesion_pa, 2e5);
  EXPECT_EQ(scene.materials[0].density_kg_per_m3 + scene.materials[1].density_kg_per_m3, 2500 + 2300);
  EXPECT_THAT(errors(dotted, {"joints.lift 1.6.cohesion_pa=2e5"}),
              testing::Contains(HasSubstr("no [[joints]] is \"lift 1\"")));
}

TEST(SceneOverride, TakesABareWordAsAText) {
  EXPECT_EQ(scene_with({"analysis.integrator=generalized-alpha"}).analysis.integrator, Integrator::generalized_alpha);
  EXPECT_EQ(scene_with({"joint.uplift=full"}).default_joint.uplift, Uplift::full);
  EXPECT_EQ(scene_with({"note=a = \"b\" # c"}).note, "a = \"b\" # c");
}

TEST(SceneOverride, TheLastOneCounts) {
  EXPECT_EQ(scene_with({"analysis.step_s=0.1", "analysis.step_s=0.2"}).analysis.step_s, 0.2);
}

TEST(SceneOverride, AWrongOneIsAnErrorOfTheArgument) {
  expect_refusal("analysis.stp_s=0.1", {"unknown key \"stp_s\" in [analysis]", "did you mean \"step_s\"?"});
  expect_refusal("analysis.step_ms=1", {"expected step_s, in s"});
  expect_refusal("analysis.step_s=-1", {"step_s in [analysis] is -1; expected a number above 0"});
  expect_refusal("analysis.step_s=fast", {"step_s in [analysis] is 'fast'"});
  expect_refusal("analysis.step_s=", {"step_s in [analysis] is ''"});
  expect_refusal("analysis.step_s=1\nx=1", {"U+000A in the text of step_s"});
  expect_refusal("may_overtop=true", {"unknown key \"may_overtop\"", "belongs elsewhere: write water.may_overtop"});
  expect_refusal("analysis.may_overtop=true", {"in [analysis]", "belongs elsewhere: write water.may_overtop"});
  expect_refusal("mesh_size_m=1", {"belongs elsewhere: write block.NAME.mesh_size_m"});
  expect_refusal("analyssi.step_s=1", {"unknown section \"analyssi\"", "did you mean \"analysis\"?"});
  expect_refusal("analysis.step_s.x=1", {"\"step_s\" has no keys"});
  expect_refusal("block.tpo.fixed=true", {"no [[block]] is \"tpo\"", "did you mean \"top\"?"});
  expect_refusal("block.3.fixed=true",
                 {"no [[block]] is \"3\"; expected an index below 3 or one of ground, base, top"});
  expect_refusal("block.-1.fixed=true", {"no [[block]] is \"-1\""});
  expect_refusal("block.99999999999999999999.fixed=true", {"no [[block]] is"});
  expect_refusal("block.fixed=true", {"\"block\" has no keys"});
  expect_refusal("block.top.material=concret", {"names no material: \"concret\"", "did you mean \"concrete\"?"});
  expect_refusal("block.top.vertices_m=[[0, 2], [3, 4], [3, 2], [0, 4]]", {"block \"top\" crosses itself at (1.5, 3)"});
  expect_refusal("water.upstream_level_m=9", {"upstream_level_m reaches 9 m"});
  expect_refusal("analysis.step_s", {"this gives no value", "section.key=value"});
  expect_refusal("=1", {"this names no key"});
  expect_refusal("analysis..step_s=1", {"this names no key"});
  expect_refusal("", {"this names no key"});
}

TEST(SceneOverride, TheTextIsTheFilesOwnWithoutOverrides) {
  const Scene scene = scene_with({});
  EXPECT_EQ(scene.text, text);
  EXPECT_EQ(scene.digest, digest(text));
}

/// All but file, text, digest and lines, which tell where a scene came from.
Scene stripped(Scene scene) {
  scene.file.clear();
  scene.text.clear();
  scene.digest.clear();
  for (Block& block : scene.blocks) block.line = 0;
  return scene;
}

TEST(SceneOverride, TheMergedTextReadsBackToTheSameScene) {
  const std::vector<std::string> overrides{"block.top.initial_velocity_m_per_s=[0.1, 3.3333333333333335e-7]",
                                           "analysis.gravity_m_per_s2=9.8066500000000003",
                                           "contact.initial_penalty_n_per_m2=5e300", "note=a\\b \"c\" 'd'\t\u00e9",
                                           "water.upstream_level_m={ steps = [[0, 0.1], [0.30000000000000004, 1]] }"};
  const Scene merged = scene_with(overrides);
  const Scene again = read_text(merged.text, "merged.toml").scene;
  EXPECT_TRUE(stripped(again) == stripped(merged)) << merged.text;
  EXPECT_EQ(again.digest, merged.digest);
  EXPECT_FALSE(stripped(merged) == stripped(scene_with({})));
  EXPECT_NE(merged.digest, scene_with({}).digest);
}

TEST(SceneDigest, IsFnv1a) {
  // Published test vectors of the 64-bit FNV-1a hash.
  EXPECT_EQ(digest(""), "cbf29ce484222325");
  EXPECT_EQ(digest("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(digest("foobar"), "85944171f73967e8");
}

}  // namespace
}  // namespace blockweir::scene_override_test
