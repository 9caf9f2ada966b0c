// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Runs with interFoam that were stopped or killed go on, and end as one that was not, to within its solver's tolerance.
#include <random>

#include "tests/cases.hpp"
#include "tests/openfoam.hpp"

namespace blockweir::test::openfoam_resume_test {
namespace {

class ResumeOpenFoam : public OpenFoam {
 protected:
  /// Fails by a slip of 1 cm, for which 1 s is long enough.
  static std::string scene(const std::string& more) {
    return cases + "cracked-dam-upper" + cells(10) + set("water.upstream_level_m={table=[[0,21.9],[1,22.4]]}") +
           set("analysis.duration_s=1") + set("analysis.failure_displacement_m=0.01") +
           set("analysis.stop_at_failure=true") + more;
  }
  [[nodiscard]] pid_t launch(const std::string& out, const std::string& more) const {
    return start(programs + "/blockweir run " + scene(more) + " --quiet --out " + out, "log");
  }
  void expect_same_end(const std::string& out) {
    ASSERT_EQ(shell(programs + "/blockweir resume " + out + " --quiet"), 0) << text("out");
    const auto head = [&](const std::string& run) {
      return nlohmann::json::parse(text(run + "/summary.json"))["failure"]["head_m"].get<double>();
    };
    EXPECT_NEAR(head(out), head("whole"), 1e-6);
    for (const double y : {7.5, 18.5}) {
      const Force a = water_force("whole", {4, y}, 9);
      const Force b = water_force(out, {4, y}, 9);
      EXPECT_LT((b.force - a.force).norm() / a.force.norm(), 1e-3) << y;
      EXPECT_NEAR(b.moment / a.moment, 1, 1e-3) << y;
    }
    const auto rows = [&](const std::string& file) {
      const std::string all = text(file);
      return std::count(all.begin(), all.end(), '\n');
    };
    EXPECT_EQ(rows("whole/openfoam/water.csv"), rows(out + "/openfoam/water.csv"));
  }
};

TEST_F(ResumeOpenFoam, AStoppedRunEndsAsAWholeOne) {
  ASSERT_EQ(end_of(launch("whole", ""), 60), 0) << text("log");
  const pid_t run = launch("stopped", "");
  ASSERT_TRUE(under_way("stopped"));
  kill(run, SIGINT);
  ASSERT_EQ(end_of(run, 20), 130) << text("log");
  EXPECT_THAT(text("log"), testing::HasSubstr("\"blockweir resume stopped\" continues the run"));
  expect_same_end("stopped");
}

/// Largest difference of pressures in the last stored frame, over the largest of them.
double pressure_difference(const std::string& whole, const std::string& parts) {
  const auto last = [](const std::string& frames) {
    return nlohmann::json::parse(frames.substr(frames.rfind('\n', frames.size() - 2) + 1))["panels"];
  };
  const auto a = last(whole);
  const auto b = last(parts);
  if (a.size() != b.size()) return INFINITY;
  double largest = 0;
  double difference = 0;
  for (std::size_t panel = 0; panel < a.size(); ++panel) {
    for (const std::size_t end : {4U, 5U}) {
      const double p = a[panel][end].get<double>();
      largest = std::max(largest, std::abs(p));
      difference = std::max(difference, std::abs(p - b[panel][end].get<double>()));
    }
  }
  return largest > 0 ? difference / largest : 0;
}

/// With BLOCKWEIR_RESUMES=10 every case in its short version so many times; in CI the tests beside this one do.
TEST_F(ResumeOpenFoam, CasesGoOnFromRandomWindows) {
  const char* asked = std::getenv("BLOCKWEIR_RESUMES");
  if (asked == nullptr) GTEST_SKIP() << "a campaign: BLOCKWEIR_RESUMES=10 makes ten of each case";
  constexpr unsigned seed = 20260104;
  std::mt19937 random(seed);
  for (const Short& version : short_versions()) {
    const std::string line =
        programs + "/blockweir run " + cases + version.of + " --quiet" + version.options() + " --out ";
    ASSERT_EQ(end_of(start(line + "whole", "log"), 600), 0) << version.of << text("log");
    const long rows = rows_of("whole");
    for (int trial = 0; trial < std::atoi(asked) && rows > 1; ++trial) {
      const long row = 1 + static_cast<long>(random() % static_cast<unsigned long>(rows - 1));
      const pid_t run = start(line + "parts", "log");
      int status = -1;
      while (rows_of("parts") < row && status < 0) status = end_of(run, 0.001);
      if (status < 0) kill(run, SIGINT), status = end_of(run, 60);
      if (status == 130 && text("log").find("continues the run") == std::string::npos) {
        std::printf("%s %s: stopped before the first step, to which nothing goes on\n", version.of.c_str(),
                    version.variant.c_str());
      } else if (status == 130) {
        const long stopped = rows_of("parts");
        ASSERT_EQ(end_of(start(programs + "/blockweir resume parts --quiet", "log"), 600), 0) << text("log");
        const double off = pressure_difference(text("whole/frames.jsonl"), text("parts/frames.jsonl"));
        std::printf("%s %s: seed %u, stopped after row %ld of %ld, pressures differ by %.2g of the largest\n",
                    version.of.c_str(), version.variant.c_str(), seed, stopped, rows, off);
        std::fflush(stdout);
        EXPECT_LT(off, version.of == "breach" ? 1e-2 : 1e-4);  // its block slides through the water
      } else {
        EXPECT_EQ(status, 0) << version.of << text("log");
      }
      fs::remove_all(folder / "parts");
    }
    fs::remove_all(folder / "whole");
  }
}

TEST_F(ResumeOpenFoam, TwoKilledRanksGoOnFromTheLastCheckpoint) {
  const std::string more = set("fluid.processes=2") + set("output.checkpoint_every_s=0.02");
  ASSERT_EQ(end_of(launch("whole", more), 60), 0) << text("log");
  const pid_t run = launch("ranks-killed", more);
  ASSERT_TRUE(under_way("ranks-killed"));
  EXPECT_EQ(shell("pkill -KILL -f '[i]nterFoam.*ranks-killed'"), 0);
  EXPECT_EQ(end_of(run, 30), 1) << text("log");
  expect_same_end("ranks-killed");
}

}  // namespace
}  // namespace blockweir::test::openfoam_resume_test
