// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_process fluid_hydrostatic
// What it costs to know where the time goes: how often a run looks at the clock, at the price that a look has here.
// (Runs with the looks less runs without them say little: a busy host adds percents to either.)
#include <fcntl.h>

#include <array>

#include "bridge/process/sides.hpp"
#include "bridge/results/stopwatch.hpp"
#include "tests/processes.hpp"

namespace blockweir::test::profile_cost_test {
namespace {

double seconds_of_processor() {
  timespec t = {};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Half of what a watch takes that starts, stops and adds to its sum [s].
double price_of_a_look() {
  constexpr int watches = 100'000;
  double sum_s = 0;
  const double start_s = seconds_of_processor();
  for (int i = 0; i < watches; ++i) const Stopwatch watch(sum_s);
  return (seconds_of_processor() - start_s) / (2 * watches);
}

class ProfileCost : public Processes {
 protected:
  ~ProfileCost() override { Stopwatch::all_stopped = false; }

  /// Of this process [s].
  double time_of_a_run(const std::string& scene) {
    fs::remove_all(folder / "o");
    const double start_s = seconds_of_processor();
    process::run_process({.scene = cases + scene,
                          .folder = folder / "o",
                          .overrides = {"analysis.duration_s=4"},
                          .progress_fd = silence_,
                          .make_fluid = hydrostatic::make});
    return seconds_of_processor() - start_s;
  }

  double looks_of_a_run(const std::string& scene) {
    Stopwatch::all_stopped = true;
    Stopwatch::looks_not_taken = 0;
    time_of_a_run(scene);
    Stopwatch::all_stopped = false;
    return static_cast<double>(Stopwatch::looks_not_taken);
  }

  int silence_ = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
};

TEST_F(ProfileCost, IsUnderAFiftiethOfARun) {
  for (const std::string scene : {"cracked-dam-upper", "monolith-overturns"}) {
    const double looks = looks_of_a_run(scene);
    EXPECT_GT(looks, 1000) << scene;
    std::array<double, 9> shares = {};  // price and run by turns: what slows the one for a while slows the other
    for (double& share : shares) share = looks * price_of_a_look() / time_of_a_run(scene);
    std::sort(shares.begin(), shares.end());
    const double median = shares[shares.size() / 2];
    std::printf("%s: %.0f looks at the clock take %.2f %% of a run (%.2f to %.2f)\n", scene.c_str(), looks,
                100 * median, 100 * shares.front(), 100 * shares.back());
    EXPECT_LT(median, 0.02) << scene;
  }
}

}  // namespace
}  // namespace blockweir::test::profile_cost_test
