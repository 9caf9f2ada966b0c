// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// How time and memory grow with the number of blocks: brick walls that stand, dams of bricks whose water rises, rock
// slopes that stand or slide; steps on one thread and on two, by turns. Each row is a process of its own, so that its
// peak of memory is its own. Arguments: numbers of blocks (100 1000 10000 100000) and kinds of scene (all).
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "solid/block/parallel.hpp"
#include "solid/step/solid.hpp"
#include "tests/large_scenes.hpp"

namespace {

using namespace blockweir;

struct Kind {
  const char* name;
  std::function<scene::Scene(int)> scene;
};

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double peak_mb() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return static_cast<double>(use.ru_maxrss) / 1024;
}

/// Nothing sleeps: every step is computed.
void row(const Kind& kind, int blocks, int steps) {
  scene::Scene scene = kind.scene(blocks);
  scene.analysis.sleep = false;
  const double dt = scene.analysis.step_s;
  std::unique_ptr<solid::Solid> solid;
  const double build_s = seconds([&] { solid = std::make_unique<solid::Solid>(scene); });
  const double settle_s = seconds([&] { solid->settle({}); });
  const long settling = solid->counts().iterations;
  const auto step = [&](int n) { return seconds([&] { solid->advance(n * dt, (n + 1) * dt, {}); }); };
  solid::set_threads(1);
  const double first_s = step(0);  // sets up what the others go on with
  const solid::Counts begun = solid->counts();
  double one_s = 0;
  double two_s = 0;
  for (int n = 1; n <= 2 * steps; ++n) {
    const bool two = n % 2 == 0;
    solid::set_threads(two ? 2 : 1);
    (two ? two_s : one_s) += step(n) / steps;
  }
  const auto a_step = [steps](long after, long before) { return static_cast<double>(after - before) / (2 * steps); };
  const auto count = solid->blocks().size();
  fmt::print(
      "{:<16} {:>7} {:>9} {:>9.2f} {:>9.2f} {:>6} {:>10.2f} {:>11.2f} {:>9.2f} {:>8.2f} {:>8.1f} {:>8.1f} {:>10.2f} "
      "{:>9.0f} {:>8.1f} {:>10.1e}\n",
      kind.name, count, solid->contacts().size(), build_s, settle_s, settling, 1e3 * first_s, 1e3 * one_s, 1e3 * two_s,
      one_s / two_s, a_step(solid->counts().iterations, begun.iterations),
      a_step(solid->counts().factorizations, begun.factorizations), 1e6 * one_s / static_cast<double>(count), peak_mb(),
      1024 * peak_mb() / static_cast<double>(count), solid->largest_displacement_m());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const auto deformable = [](scene::Scene scene) {
    scene.analysis.rigid = scene::Rigid::none;
    return scene;
  };
  const std::vector<Kind> kinds{
      {"pyramid", [](int n) { return pyramid(static_cast<int>(std::lround(std::sqrt(2.0 * n)))); }},
      {"wall", brick_wall},
      {"deformable wall", [&](int n) { return deformable(brick_wall(n)); }},
      {"dam", brick_dam},
      {"deformable dam", [&](int n) { return deformable(brick_dam(n)); }},
      {"slope", [](int n) { return rock_slope(n, 0.6); }},
      {"sliding slope", [](int n) { return rock_slope(n, 0.3); }}};
  std::vector<int> sizes;
  std::vector<std::string> wanted;
  for (int i = 1; i < argc; ++i) {
    if (const int size = std::atoi(argv[i]); size > 0) {
      sizes.push_back(size);
    } else {
      wanted.emplace_back(argv[i]);
    }
  }
  if (sizes.empty()) sizes = {100, 1'000, 10'000, 100'000};
  fmt::print("{:<16} {:>7} {:>9} {:>9} {:>9} {:>6} {:>10} {:>11} {:>9} {:>8} {:>8} {:>8} {:>10} {:>9} {:>8} {:>10}\n",
             "scene", "blocks", "contacts", "build [s]", "rest [s]", "solves", "first [ms]", "step [ms]", "on two",
             "speed-up", "solves", "factors", "us/block", "peak [MB]", "kB/block", "moved [m]");
  for (const Kind& kind : kinds) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), kind.name) == wanted.end()) continue;
    for (const int blocks : sizes) {
      std::fflush(stdout);
      if (const pid_t child = fork(); child == 0) {
        try {
          row(kind, blocks, 20);
        } catch (const std::exception& error) {
          fmt::print("{:<16} {:>7} {}\n", kind.name, blocks, error.what());
        }
        std::fflush(stdout);
        _exit(0);
      } else {
        waitpid(child, nullptr, 0);
      }
    }
  }
}
