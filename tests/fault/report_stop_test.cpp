// SPDX-License-Identifier: GPL-3.0-or-later
// A report asks several programs in turn: Ctrl-C ends it whichever it is at.
#include "tests/processes.hpp"

namespace blockweir::test::report_stop_test {
namespace {

using ReportStop = Processes;

TEST_F(ReportStop, CtrlCEndsAReportAtAnyMoment) {
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

}  // namespace
}  // namespace blockweir::test::report_stop_test
