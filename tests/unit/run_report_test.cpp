// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_process
// What a run tells a person, by its summary.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bridge/process/run.hpp"

namespace blockweir::process::run_report_test {
namespace {

using testing::HasSubstr;

/// A fall is long, and often stopped by hand.
TEST(RunReport, AStoppedRunTellsWhatHadFailedBefore) {
  RunResult result{.exit_code = 130, .folder = "nowhere"};
  result.summary = {{"outcome", "stopped"},
                    {"stopped", "stopped on request"},
                    {"wall_time_s", 1},
                    {"failure",
                     {{"text", "block \"dam\" fails by sliding on joint \"base\""},
                      {"level_m", 8.5},
                      {"head_m", 8.5},
                      {"time_s", 3}}},
                    {"warnings", {"no open water reaches it"}}};
  EXPECT_THAT(report(result), testing::AllOf(HasSubstr("STOPPED on request"),
                                             HasSubstr("FAILED  before that: block \"dam\" fails by sliding"),
                                             HasSubstr("at a level of 8.5 m, 8.5 m above the joint that failed"),
                                             HasSubstr("WARNING no open water reaches it")));
}

TEST(RunReport, ALevelUnderTheJointThatFailedIsBelowIt) {
  RunResult result{.exit_code = 0, .folder = "it's so"};
  result.summary = {{"outcome", "fails"},
                    {"wall_time_s", 1},
                    {"skips", {"one"}},
                    {"failure", {{"text", "block fails"}, {"level_m", 2}, {"head_m", -8}, {"time_s", 3}}}};
  EXPECT_THAT(report(result), testing::AllOf(HasSubstr("at a level of 2 m, 8 m below the joint that failed"),
                                             HasSubstr(R"("blockweir profile 'it'\''s so'" lists them)")));
}

/// The level is the head over the joint that opens, not over the one that bears.
TEST(RunReport, AHeadIsOverTheJointThatOpensWhereAnotherBears) {
  RunResult result{.exit_code = 0, .folder = "f"};
  result.summary = {{"outcome", "fails"},
                    {"wall_time_s", 1},
                    {"failure",
                     {{"text", "block fails by overturning on joint \"toe\"; joint \"heel\" opens"},
                      {"joint", "heel"},
                      {"turns_on", "toe"},
                      {"level_m", 2.9},
                      {"head_m", 2.65},
                      {"time_s", 3}}}};
  EXPECT_THAT(report(result), HasSubstr("at a level of 2.9 m, 2.65 m above the joint that opens, after 3 s"));
}

/// As of `report SCENE --out FILE` where nothing else can be written: nobody could open what the lines name.
TEST(RunReport, AFolderThatIsRemovedAfterwardsIsNotNamed) {
  RunResult result{.exit_code = 1, .folder = "temporary", .kept = false, .advice = "\"blockweir resume temporary\""};
  result.summary = {{"outcome", "stopped"}, {"stopped", "the disk is full"}, {"wall_time_s", 1}, {"skips", {"one"}}};
  EXPECT_THAT(report(result), testing::AllOf(HasSubstr("STOPPED the disk is full\n"), HasSubstr("time    1 s"),
                                             testing::Not(HasSubstr("temporary"))));
  result.kept = true;
  EXPECT_THAT(report(result), HasSubstr("results temporary"));
}

TEST(RunReport, SaysWhatWasDoneToTheGroundsRecord) {
  RunResult result{.exit_code = 0, .folder = "f"};
  result.summary = {{"outcome", "stopped"}, {"wall_time_s", 1}, {"base_motion", {{"text", "baseline linear; x"}}}};
  EXPECT_THAT(report(result), HasSubstr("GROUND  baseline linear; x\n"));
}

}  // namespace
}  // namespace blockweir::process::run_report_test
