// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json fmt::fmt
// Words of a command line that no command takes: the answer names what was meant, or what there is.
#include "tests/processes.hpp"

namespace blockweir::test::wrong_options_test {
namespace {

using testing::HasSubstr;

TEST_F(Processes, WrongOptionsNameTheNearestOneAndHowAKeyIsSet) {
  const std::string blockweir = programs + "/blockweir ";
  const std::string scene = cases + "monolith-slides";
  EXPECT_EQ(shell(blockweir + "run " + scene + " --step 3"), 2);
  EXPECT_THAT(text("out"), HasSubstr("run has no option \"--step\", did you mean \"--set\"?"));
  EXPECT_THAT(text("out"), HasSubstr("--set SECTION.KEY=VALUE sets a key of the scene"));
  EXPECT_EQ(shell(blockweir + "compare a b --zzzzzz=1"), 2);
  EXPECT_THAT(text("out"), HasSubstr("compare has no option \"--zzzzzz\"; blockweir compare --help lists them"));
  EXPECT_EQ(shell(blockweir + "check " + scene + " another"), 2);
  EXPECT_THAT(text("out"), HasSubstr("check does not take \"another\""));
}

TEST_F(Processes, NamesThatASceneDoesNotHaveAreAnsweredWithThoseThatItHas) {
  const std::string blockweir = programs + "/blockweir ";
  EXPECT_EQ(shell(blockweir + "run " + cases + "breach --variant nope"), 2);
  EXPECT_THAT(text("out"), HasSubstr("leave --variant out"));
  EXPECT_EQ(shell(blockweir + "run " + cases + "cracked-dam-upper --variant nope"), 2);
  EXPECT_THAT(text("out"), HasSubstr("name one of these, or leave --variant out"));
  for (const char* command : {"run ", "level ", "safety ", "modes ", "report "}) {
    EXPECT_EQ(shell(blockweir + command + cases + "cracked-dam-upper --variant ''"), 2) << command;
    EXPECT_THAT(text("out"), HasSubstr("--variant: found no name; expected that of a [[variant]]")) << command;
  }
  std::ofstream(folder / "s.toml")
      << text(cases + "monolith-slides/scene.toml")
      << "\n[[study]]\nname = 'friction'\nkind = 'map'\nx_key = "
         "'joint.friction_angle_deg'\nx_values = [25, 30]\ny_key = 'water.upstream_level_m'\ny_values = [5, 6]\n";
  EXPECT_EQ(shell(blockweir + "study s.toml --name x"), 2);
  EXPECT_THAT(text("out"), HasSubstr("no study \"x\"; expected one of friction; name one of these"));
}

TEST_F(Processes, KeysThatCannotBeWrittenLeaveNothing) {
  const std::string keys = programs + "/blockweir keys ";
  std::ofstream(folder / "afile") << "mine\n";
  EXPECT_EQ(shell(keys + "''"), 2);
  EXPECT_THAT(text("out"), HasSubstr("FOLDER: found no name"));
  EXPECT_EQ(shell(keys + "afile"), 2);
  EXPECT_THAT(text("out"), HasSubstr("cannot make the folder afile/solid: "));
  EXPECT_EQ(shell(on_a_full_disk(0, keys + "k")), 2);
  EXPECT_FALSE(fs::exists(folder / "solid") || fs::exists(folder / "k/solid"));
  EXPECT_EQ(shell(keys + "k"), 0) << text("out");
}

/// A slip of the hand must not cost a scene.
TEST_F(Processes, AFileThatIsNoneOfItsKindIsNotWritten) {
  std::ofstream(folder / "w.toml") << "title = 'mine'\n";
  const std::string scene = cases + "monolith-slides ";
  for (const std::string& command :
       {"report " + scene + "--out", "cut " + scene + "--out", "level " + scene + "--json",
        "safety " + scene + "--json", "modes " + scene + "--json", "reliability " + scene + "--json",
        "validate " + scene + "--json", "compare " + scene + "--json",
        "compare " + scene + "--fluids reservoir,hydrostatic --json"}) {
    EXPECT_EQ(shell(programs + "/blockweir " + command + " w.toml"), 2) << command << text("out");
    EXPECT_THAT(text("out"), HasSubstr("w.toml: expected a name that ends in .")) << command;
    EXPECT_EQ(text("w.toml"), "title = 'mine'\n") << command;
  }
  EXPECT_FALSE(fs::exists(folder / "runs"));
}

}  // namespace
}  // namespace blockweir::test::wrong_options_test
