// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_results nlohmann_json::nlohmann_json
// Standard output, or a file of results, that takes nothing: one error, and a status that is not 0.
#include "bridge/results/result_file.hpp"
#include "tests/coupling/masonry_wall.hpp"
#include "tests/processes.hpp"

namespace blockweir::test::full_output_test {
namespace {

using testing::HasSubstr;

class FullOutput : public Processes {
 protected:
  /// Exit status of a command whose standard output is a full disk; what it says of that is in the file "out".
  [[nodiscard]] int full(const std::string& words) const {
    return shell("sh -c '" + programs + "/blockweir " + words + " >/dev/full'");
  }
};

TEST_F(FullOutput, IsAnErrorOfEachCommand) {
  const std::string scene = cases + "monolith-slides";
  for (const std::string& command :
       {std::string("--help"), std::string("--version"), std::string("run --help"), "check " + scene,
        "run " + scene + " --out r --set analysis.duration_s=0.1 --set expect=[] --set variant=[]",
        "level " + scene + " --out l", "cut " + scene + " --out cut.png", std::string("man")}) {
    EXPECT_EQ(full(command), 1) << command << "\n" << text("out");
    const std::string said = text("out");
    const auto at = said.find("blockweir: ");
    ASSERT_NE(at, std::string::npos) << command << ": " << said;
    EXPECT_EQ(said.find("blockweir: ", at + 1), std::string::npos) << "more than one error: " << said;
    EXPECT_THAT(said.substr(at), HasSubstr("standard output cannot be written")) << command;
  }
}

/// Which file (of a run the one that comes first), why, and what to do; a run whose disk has room again goes on.
TEST_F(FullOutput, RunResumeAndReportSayWhatADiskDidNotTakeAndWhatToDo) {
  const auto on_full_disk = [&](long half_kilobytes, const std::string& words, const std::string& file) {
    EXPECT_EQ(shell(on_a_full_disk(half_kilobytes, programs + "/blockweir " + words) + " 2>&1 | cat"), 0);
    EXPECT_THAT(text("out"), testing::AllOf(HasSubstr("cannot write " + file),
                                            HasSubstr(": is the disk full, or the folder not writable?"),
                                            HasSubstr("; make room, or choose another folder")))
        << words;
  };
  const std::string run = "run " + cases + "monolith-slides --quiet --set output.checkpoint_every_s=0.01 --out ";
  on_full_disk(0, run + "none", "none/.lock");
  on_full_disk(0, "safety " + cases + "monolith-slides --out s", "s/.lock");
  on_full_disk(40, run + "r", "r/");
  on_full_disk(10, "resume r --quiet", "r/");
  ASSERT_EQ(shell(programs + "/blockweir resume r --quiet"), 0) << text("out");
  on_full_disk(100, "report r --out page.html", "page.html");
  EXPECT_FALSE(fs::exists(folder / "page.html"));
  EXPECT_FALSE(fs::exists(folder / "page.html.new"));
}

/// The first load case's own answer has the name of all, until all are written.
TEST_F(FullOutput, SafetyLeavesAllAnswersOrNone) {
  const std::string safety = programs + "/blockweir safety " + cases + "monolith-slides --out s";
  ASSERT_EQ(shell(safety), 0) << text("out");
  const auto half_kilobytes = static_cast<long>(fs::file_size(folder / "s/safety.json") / 512);
  EXPECT_EQ(shell(on_a_full_disk(half_kilobytes, safety) + " 2>&1 | cat"), 0);
  EXPECT_THAT(text("out"), HasSubstr("cannot write s/safety.json"));
  EXPECT_THAT(text("out"), HasSubstr("LOAD CASE"));
  EXPECT_FALSE(fs::exists(folder / "s/safety.json"));
}

/// Without a summary the terminal says how far it came.
TEST_F(FullOutput, ARunThatCannotWriteItsSummarySaysHowFarItCame) {
  std::ofstream(folder / "s.toml") << "analysis = { duration_s = 1 }\nwater = { upstream_level_m = 2 }\n"
                                   << "joint = { friction_angle_deg = 30 }\n"
                                   << masonry_wall;
  const std::string run = programs + "/blockweir run s.toml --quiet --out r; echo status \\$?";
  EXPECT_EQ(shell("sh -c \"trap '' XFSZ; ulimit -f 2; " + run + "\" 2>&1 | cat"), 0);
  EXPECT_THAT(text("out"),
              testing::AllOf(HasSubstr("\n        it came to 0 s, at a level of 2 m\n"), HasSubstr("status 1")));
}

/// The solid writes a summary, and the launcher adds to it: what is said of it is so, whatever room there is.
TEST_F(FullOutput, ASummaryThatLiesThereIsNotSaidToBeMissing) {
  std::string scene = "analysis = { duration_s = 1 }\nwater = { upstream_level_m = 2 }\n";
  scene += "joint = { friction_angle_deg = 30 }\n";
  scene += masonry_wall;
  bool completed = true;
  for (int longer = 0; longer <= 140; longer += 20) {  // the room is between the sizes of the two for some
    const std::string name = "name = \"wall";
    std::string longer_name = scene;
    longer_name.insert(scene.find(name) + name.size(), std::string(longer, 'l'));
    std::ofstream(folder / "s.toml") << longer_name;
    fs::remove_all(folder / "r");
    EXPECT_EQ(shell(on_a_full_disk(5, programs + "/blockweir run s.toml --quiet --out r") + " 2>&1 | cat"), 0);
    const bool is_there = fs::exists(folder / "r/summary.json");
    const std::string said = text("out");
    EXPECT_FALSE(is_there && said.find("summary.json could not be written, either") != std::string::npos) << said;
    completed = completed && said.find("could not be completed, either: it is as the solid left it") == said.npos;
  }
  EXPECT_FALSE(completed) << "no run had a summary of the solid alone";
}

TEST_F(FullOutput, AStatusOfItsOwnStays) {
  EXPECT_EQ(full("check no-such-scene.toml"), 2);
}

TEST_F(FullOutput, AReaderThatHasGoneIsNoError) {
  for (const std::string& command : {std::string("--help"), "check " + cases + "monolith-slides", std::string("man")}) {
    // The pause lets the reader go first.
    const std::string piped = "{ sleep 0.3; " + programs + "/blockweir " + command + "; echo $? >status; } | true";
    EXPECT_EQ(shell("sh -c '" + piped + "'"), 0);
    EXPECT_EQ(text("out"), "") << command;
    EXPECT_EQ(text("status"), "141\n") << command;
  }
}

/// As root one could remove it, or put a file in its place.
TEST_F(FullOutput, ADeviceIsWrittenAndStaysWhatItIs) {
  fs::create_symlink("/dev/full", folder / "full");
  fs::create_symlink("/dev/null", folder / "null");
  for (const auto& write : {&results::write_file, &results::replace_file}) {
    try {
      write(folder / "full", "text");
      FAIL() << "a full disk took it";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("full: is the disk full"));
    }
    EXPECT_TRUE(fs::is_symlink(folder / "full"));
    write(folder / "null", "text");
    EXPECT_TRUE(fs::is_symlink(folder / "null"));
  }
}

}  // namespace
}  // namespace blockweir::test::full_output_test
