// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Runs that were stopped or killed go on, and end with the bits of one that was not.
#include <random>

#include "tests/cases.hpp"
#include "tests/same_results.hpp"

namespace blockweir::test::resume_test {
namespace {

using testing::HasSubstr;

class Resume : public SameResults {
 protected:
  [[nodiscard]] static std::string command(const std::string& scene, const std::string& out,
                                           const std::string& more = "") {
    return programs + "/blockweir run " + cases + scene + " --quiet --out " + out + more;
  }
  /// A run that is let be, and one that gets a signal once it is under way and is resumed.
  void expect_same_bits(const std::string& scene, const std::string& more = "") {
    SCOPED_TRACE(scene + more);
    ASSERT_EQ(shell(command(scene, "whole", more)), 0) << text("out");
    const pid_t run = start(command(scene, "parts", more), "log");
    ASSERT_TRUE(under_way("parts"));
    kill(run, SIGINT);
    ASSERT_EQ(end_of(run, 20), 130) << text("log");
    EXPECT_THAT(
        text("log"),
        HasSubstr("STOPPED on request; the results so far stand; \"blockweir resume parts\" continues the run"));
    EXPECT_LT(text("parts/history.csv").size(), text("whole/history.csv").size());
    ASSERT_EQ(shell(programs + "/blockweir resume parts --quiet"), 0) << text("out");
    expect_same();
    fs::remove_all(folder / "whole");
  }
  /// Stops a run once it has so many rows; false where it has ended before.
  [[nodiscard]] bool stopped_at(const std::string& line, long row) {
    const pid_t run = start(line, "log");
    int status = -1;
    while (rows_of("parts") < row && status < 0) status = end_of(run, 0.001);
    if (status < 0) {
      kill(run, SIGINT);
      status = end_of(run, 60);
    }
    EXPECT_THAT(status, testing::AnyOf(0, 130)) << text("log");
    if (status != 130) return false;
    if (text("log").find("continues the run") == std::string::npos) {
      // The signal met a launcher whose run was complete, before its report or after it, and ended it as any program.
      EXPECT_THAT(text("log"), testing::AnyOf("", HasSubstr("\nresults parts ")));
      EXPECT_THAT(text("parts/summary.json"), testing::Not(HasSubstr("\"stopped\"")));
      return false;
    }
    return true;
  }
  /// Still water that was stopped before both sides were in touch remembers nothing: it starts anew, and so do its
  /// counts.
  [[nodiscard]] bool has_checkpoint(const std::string& side) const {
    const fs::directory_iterator all(folder / "parts/checkpoint");
    return std::any_of(begin(all), end(all),
                       [&](const auto& file) { return file.path().filename().string().starts_with(side); });
  }
  void expect_same(const std::string& except = "none") {
    SameResults::expect_same("whole", "parts", except);
    fs::remove_all(folder / "parts");
  }
};

TEST_F(Resume, AStoppedRunEndsWithTheBitsOfAWholeOne) {
  const std::string to_failure = " --set analysis.duration_s=4";
  expect_same_bits("cracked-dam-upper", to_failure + " --set output.reservoir=true");
  expect_same_bits("cracked-dam-lower", to_failure + " --set analysis.integrator=generalized-alpha");
  expect_same_bits("brick-rows", to_failure);
  expect_same_bits("heap");
  expect_same_bits("bar-wave", " --set analysis.step_s=1e-5");
  expect_same_bits("toppling-slope");
  expect_same_bits("cracked-dam-flow");
  expect_same_bits("cracked-dam-flow", " --set joint_flow.kind=transient --set joint_flow.bulk_modulus_pa=2.2e9");
  expect_same_bits("cracked-dam-flow", " --set fluid.model=reservoir --set analysis.duration_s=5");
}

/// With BLOCKWEIR_RESUMES=10 every case without OpenFOAM so many times, else two of them once.
std::vector<std::string> cases_to_resume() {
  if (std::getenv("BLOCKWEIR_RESUMES") != nullptr) return all_cases(false);
  return {"cracked-dam-lower", "water-column"};
}

class ResumeCases : public Resume, public testing::WithParamInterface<std::string> {};

TEST_P(ResumeCases, GoOnFromRandomWindows) {
  const char* asked = std::getenv("BLOCKWEIR_RESUMES");
  const int times = asked != nullptr ? std::atoi(asked) : 1;
  constexpr unsigned seed = 20260103;
  std::mt19937 random(seed);
  ASSERT_EQ(shell(command(GetParam(), "whole")), 0) << text("out");
  const long rows = rows_of("whole");
  std::string stops;
  int resumed = 0;
  for (int tries = 0; rows > 1 && resumed < times && tries < 40 * times; ++tries) {
    const long row = 1 + static_cast<long>(random() % static_cast<unsigned long>(rows - 1));
    if (stopped_at(command(GetParam(), "parts"), row)) {
      stops += " " + std::to_string(rows_of("parts"));
      const bool anew = !has_checkpoint("hydrostatic");
      ASSERT_EQ(shell(programs + "/blockweir resume parts --quiet"), 0) << text("out") << text("log");
      expect_same(anew ? "fluid_" : "none");
      ++resumed;
    }
    fs::remove_all(folder / "parts");
    ASSERT_FALSE(HasFailure());
  }
  std::printf("seed %u: %d runs of %s stopped after rows%s of %ld, resumed, bit-equal\n", seed, resumed,
              GetParam().c_str(), stops.c_str(), rows);
}

INSTANTIATE_TEST_SUITE_P(Of, ResumeCases, testing::ValuesIn(cases_to_resume()), name_of);

TEST_F(Resume, FramesThatWereLostAreToldAndListedNoMore) {
  ASSERT_TRUE(stopped_at(command("cracked-dam-upper", "parts"), 30));
  fs::remove_all(folder / "parts/frames");
  ASSERT_EQ(shell(programs + "/blockweir resume parts --quiet"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("WARNING frames/ lacks "));
  EXPECT_THAT(text("out"), HasSubstr(" files that the run had written, of times from 0 to "));
  EXPECT_THAT(text("out"), HasSubstr(": frames/blocks_000000.vtu to frames/water_"));
  const std::string list = text("parts/blocks.pvd");
  std::size_t listed = 0;
  for (std::size_t at = 0; (at = list.find("file=\"", at)) != std::string::npos; ++listed) {
    at += 6;
    EXPECT_TRUE(fs::exists(folder / "parts" / list.substr(at, list.find('"', at) - at)));
  }
  EXPECT_GT(listed, 0U);
}

TEST_F(Resume, OnEverySchedule) {
  const std::string to_failure = " --set analysis.duration_s=4";
  for (const std::string schedule : {"parallel", "improved"}) {
    expect_same_bits("cracked-dam-upper", to_failure + " --set coupling.schedule=" + schedule);
  }
  expect_same_bits("cracked-dam-upper",
                   to_failure + " --set coupling.longest_window_s=0.08 --set analysis.step_s=0.005");
}

TEST_F(Resume, AKilledRunGoesOnFromItsLastCheckpointWhenceverItWasKilled) {
  const std::string often = " --set output.checkpoint_every_s=0.002";
  ASSERT_EQ(shell(command("cracked-dam-upper", "whole", often)), 0) << text("out");
  EXPECT_FALSE(fs::exists(folder / "whole/checkpoint"));
  for (int moment = 0; moment < 6; ++moment) {
    const pid_t run = start(command("cracked-dam-upper", "killed", often), "log");
    ASSERT_TRUE(under_way("killed", 5 + 12 * moment));
    const std::string name = moment % 2 == 0 ? "solid" : "hydrostatic";
    EXPECT_TRUE(signal_child(run, name, "KILL"));
    EXPECT_EQ(end_of(run, 15), 1) << text("log");
    EXPECT_THAT(text("log"), HasSubstr("\"blockweir resume killed\" continues the run"));
    ASSERT_EQ(shell(programs + "/blockweir resume killed --quiet"), 0) << text("out");
    EXPECT_EQ(text("whole/history.csv"), text("killed/history.csv")) << moment;
    fs::remove_all(folder / "killed");
  }
}

TEST_F(Resume, AFluidThatRemembersNothingIsTakenUpWhereItDied) {
  const pid_t run = start(command("cracked-dam-upper", "left", " --set output.checkpoint_every_s=0"), "log");
  ASSERT_TRUE(under_way("left"));
  EXPECT_TRUE(signal_child(run, "hydrostatic", "KILL"));
  EXPECT_EQ(end_of(run, 15), 1) << text("log");
  EXPECT_EQ(shell(programs + "/blockweir resume left --quiet"), 0) << text("out");
  ASSERT_EQ(shell(command("cracked-dam-upper", "whole", " --set output.checkpoint_every_s=0")), 0);
  EXPECT_EQ(text("whole/history.csv"), text("left/history.csv"));
}

TEST_F(Resume, AFluidThatRemembersIsNotBegunAnewByHand) {
  const std::string line = cases + "water-column --resume 7 --endpoint ipc://" + (folder / "line").string();
  const pid_t column = start(programs + "/blockweir-column " + line + " --out o", "fluid");
  const pid_t solid = start(programs + "/blockweir-solid " + line + " --out o", "solid");
  EXPECT_EQ(end_of(column, 10), 1);
  EXPECT_EQ(end_of(solid, 10), 1);
  EXPECT_THAT(text("fluid"), HasSubstr("no such checkpoint"));
}

TEST_F(Resume, AsksForTheFolderOfARunWithACheckpoint) {
  EXPECT_EQ(shell(programs + "/blockweir resume nowhere"), 2);
  EXPECT_THAT(text("out"), HasSubstr("nowhere: found no scene.toml and solid.log of a run"));
  ASSERT_EQ(shell(command("incline", "o")), 0) << text("out");
  EXPECT_EQ(shell(programs + "/blockweir resume o"), 2);
  EXPECT_THAT(text("out"), HasSubstr("o: found a run that is complete"));
  std::filesystem::remove(folder / "o/summary.json");
  EXPECT_EQ(shell(programs + "/blockweir resume o"), 2);
  EXPECT_THAT(text("out"), HasSubstr("o: no checkpoint that all its processes have"));
}

/// A piston that pushes three times its weight of water without the guard: the exchange makes energy.
TEST_F(Resume, IsNotAdvisedWhereTheRunWouldEndSoAgain) {
  EXPECT_EQ(shell(command("piston-column", "o",
                          " --set coupling.added_mass_guard=false --set coupling.added_mass_limit=10"
                          " --set analysis.integrator=shi --set output.checkpoint_every_s=0.0001")),
            1);
  ASSERT_TRUE(fs::exists(folder / "o/checkpoint")) << text("out");
  EXPECT_THAT(text("out"), testing::Not(HasSubstr("continues the run")));
  fs::remove_all(folder / "o/checkpoint");
  EXPECT_EQ(shell(programs + "/blockweir resume o"), 2);
  EXPECT_THAT(text("out"), HasSubstr("resuming would end in the same way: change the scene"));
}

TEST_F(Resume, RefusesWhatHasChangedSince) {
  const pid_t run = start(command("cracked-dam-upper", "o"), "log");
  ASSERT_TRUE(under_way("o"));
  kill(run, SIGINT);
  ASSERT_EQ(end_of(run, 20), 130) << text("log");
  const std::string scene = text("o/scene.toml");
  std::ofstream(folder / "o/scene.toml") << scene << "\n# changed\n";
  EXPECT_EQ(shell(programs + "/blockweir resume o --quiet"), 1);
  EXPECT_THAT(text("out"),
              testing::ContainsRegex("the scene was changed since: it has digest [0-9a-f]+ now, expected"));
  EXPECT_THAT(text("out"), HasSubstr("put scene.toml of the run back as it was, or begin a new run"));
  EXPECT_THAT(text("out"), testing::Not(HasSubstr("delete it")));
  std::ofstream(folder / "o/scene.toml") << scene;
  const std::string history = text("o/history.csv");
  std::ofstream(folder / "o/history.csv") << history.substr(0, history.size() / 2);
  EXPECT_EQ(shell(programs + "/blockweir resume o --quiet"), 1);
  EXPECT_THAT(text("out"), HasSubstr("history.csv is shorter than it was at the checkpoint"));
  std::ofstream(folder / "o/history.csv") << history;
  EXPECT_EQ(shell(programs + "/blockweir resume o --quiet"), 0) << text("out");
}

}  // namespace
}  // namespace blockweir::test::resume_test
