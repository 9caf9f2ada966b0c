// SPDX-License-Identifier: GPL-3.0-or-later
// A report, or safety with load cases, asks several times in turn: Ctrl-C ends it wherever it is.
#include "tests/processes.hpp"

namespace blockweir::test::answer_stop_test {
namespace {

using AnswerStop = Processes;

TEST_F(AnswerStop, CtrlCEndsAReportAtAnyMoment) {
  const pid_t run = start(programs + "/blockweir run " + cases + "cracked-dam-upper --out o", "log");
  ASSERT_EQ(end_of(run, 20), 0) << text("log");
  for (int moment = 0; moment < 40; ++moment) {
    SCOPED_TRACE(moment);
    const pid_t report = start(programs + "/blockweir report o --out page.html", "log");
    std::this_thread::sleep_for(std::chrono::milliseconds(5 * moment));
    const bool done = fs::exists(folder / "page.html");
    kill(report, SIGINT);
    const int status = end_of(report, 20);
    if (done) break;
    EXPECT_EQ(status, 130) << text("log");
  }
  EXPECT_FALSE(orphan());
}

TEST_F(AnswerStop, SafetyTellsTheLoadCasesThatItHasAnswered) {
  std::ofstream(folder / "s.toml")
      << "[analysis]\nduration_s = 1\n[material.brick]\nyoungs_modulus_pa = 1e10\npoissons_ratio = 0.2\n"
         "density_kg_per_m3 = 2200\n[joint]\nfriction_angle_deg = 30\n[[block]]\nname = 'ground'\nmaterial = 'brick'\n"
         "vertices_m = [[-30, -2], [60, -2], [60, 0], [-30, 0]]\nfixed = true\n[[wall]]\nname = 'b'\nmaterial = "
         "'brick'\n"
         "rows = 2\ncolumns = 2\nbrick_length_m = 1\nbrick_height_m = 0.5\n[water]\nupstream_level_m = 0.9\n"
         "[[load_case]]\nname = 'high'\nset = ['wall.b.rows=30', 'water.upstream_level_m=10']\n";
  const pid_t safety = start(programs + "/blockweir safety s.toml --out s", "log");
  for (int wait = 0; wait < 4000 && !fs::exists(folder / "s/high/limit.log"); ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  kill(safety, SIGINT);
  EXPECT_EQ(end_of(safety, 20), 130);
  EXPECT_THAT(text("log"), testing::AllOf(testing::HasSubstr("\nscene as written"),
                                          testing::HasSubstr("stopped before the next load case was answered"),
                                          testing::Not(testing::HasSubstr("\nhigh"))));
}

}  // namespace
}  // namespace blockweir::test::answer_stop_test
