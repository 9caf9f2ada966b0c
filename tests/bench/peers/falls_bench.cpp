// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step solid_output bridge_scene_read box2d::box2d
// Walls that fall when gravity is tilted, and heaps of stones, beside Box2D in one run: wall time, slowest step over
// the median step, energy made over energy dissipated, largest overlap of two blocks at any step's end. Steps are 0.01
// s on both sides; Box2D takes 16 velocity and 16 position iterations. Nothing sleeps. Rows of 10,000 blocks want
// --large; a word after that, or alone, is of the scenes' names; --random FROM TO makes the falls of these seeds,
// without Box2D.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "solid/step/solid.hpp"
#include "solid/watch/energy.hpp"
#include "tests/bench/peers/box2d_world.hpp"
#include "tests/collapse_scenes.hpp"
#include "tests/overlap.hpp"

namespace {

using namespace blockweir;
using scene::Point;
using test::largest_overlap_m;
using test::Outline;

constexpr double step_s = 0.01;

/// What a fall is judged by, from its energies and places after each step.
class Fall {
 public:
  void look(double energy_j, const std::vector<Outline>& outlines) {
    if (!begun_) first_ = energy_j;
    if (begun_) made_ += std::max(0.0, energy_j - last_);
    begun_ = true;
    last_ = energy_j;
    overlap_ = std::max(overlap_, largest_overlap_m(outlines));
  }
  [[nodiscard]] double made_over_dissipated() const { return made_over(0); }
  /// Of what stands: over at least so much energy.
  [[nodiscard]] double made_over(double least_j) const {
    return made_ > 0 ? made_ / std::max(first_ - last_ + made_, least_j) : 0;
  }
  [[nodiscard]] double overlap_m() const { return overlap_; }

 private:
  bool begun_ = false;
  double first_ = 0;
  double last_ = 0;
  double made_ = 0;
  double overlap_ = 0;
};

/// Another program's or ours: makes a step; looks, which costs no time.
struct Run {
  std::function<void(long)> step;
  std::function<void(Fall&)> look;
};

Run ours(solid::Solid& solid) {
  return {[&](long n) { solid.advance(static_cast<double>(n) * step_s, static_cast<double>(n + 1) * step_s, {}); },
          [&](Fall& fall) {
            std::vector<Outline> outlines;
            for (std::size_t b = 0; b < solid.blocks().size(); ++b) {
              Outline& outline = outlines.emplace_back();
              for (const Point& X : solid.blocks()[b].vertices) outline.push_back(solid.placements()[b].position(X));
            }
            fall.look(solid::energy_of(solid).total(), outlines);
          }};
}

Run theirs(const scene::Scene& scene, peers::Box2dWorld& made) {
  return {[&](long) { made.world->Step(static_cast<float>(step_s), peers::iterations, peers::iterations); },
          [&](Fall& fall) {
            double energy = 0;
            std::vector<Outline> outlines;
            const Point gravity = scene.analysis.gravity();
            for (std::size_t b = 0; b < made.bodies.size(); ++b) {
              const b2Body& body = *made.bodies[b];
              const Point moved = Point(body.GetPosition().x, body.GetPosition().y) - made.centroid[b];
              const double mass = static_cast<double>(body.GetMass());
              const double v = static_cast<double>(body.GetLinearVelocity().LengthSquared());
              const double w = static_cast<double>(body.GetAngularVelocity());
              energy += mass * (v / 2 - gravity.dot(moved)) + static_cast<double>(body.GetInertia()) * w * w / 2;
              Outline& outline = outlines.emplace_back();
              const Eigen::Rotation2Dd turn(static_cast<double>(body.GetAngle()));
              for (const Point& p : scene.blocks[b].vertices) {
                outline.push_back(made.centroid[b] + moved + turn * (p - made.centroid[b]));
              }
            }
            fall.look(energy, outlines);
          }};
}

struct Measured {
  double wall_s = 0;  ///< of all steps
  double slowest_over_median = 0;
  Fall fall{};
};

Measured measured(const Run& run, long steps) {
  Measured all;
  std::vector<double> times_s;
  for (long n = 0; n < steps; ++n) {
    const auto start = std::chrono::steady_clock::now();
    run.step(n);
    times_s.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    all.wall_s += times_s.back();
    run.look(all.fall);
  }
  std::sort(times_s.begin(), times_s.end());
  all.slowest_over_median = times_s.back() / times_s[times_s.size() / 2];
  return all;
}

void row(const std::string& scene, const std::string& program, const Measured& m, double other_s) {
  fmt::print("{:<16} {:<10} {:>10.1f} {:>8} {:>16.1f} {:>16.1e} {:>14.1e}\n", scene, program, 1e3 * m.wall_s,
             other_s > 0 ? fmt::format("{:.1f}", m.wall_s / other_s) : "", m.slowest_over_median,
             m.fall.made_over_dissipated(), m.fall.overlap_m());
  std::fflush(stdout);
}

std::string only;  // scenes with this in their names

/// The faster of so many rounds, by turns: whatever else the machine does meets both.
void compare(const std::string& name, const std::string& blocks, double duration_s, double tilt_deg, int rounds) {
  if (name.find(only) == std::string::npos) return;
  const scene::Scene scene = test::collapse(blocks, duration_s, tilt_deg, 30);
  const long steps = std::lround(duration_s / step_s);
  std::vector<Measured> box2d;
  std::vector<Measured> us;
  for (int round = 0; round < rounds; ++round) {
    auto world = peers::box2d_world(scene, false);
    box2d.push_back(measured(theirs(scene, world), steps));
    solid::Solid solid(scene);
    us.push_back(measured(ours(solid), steps));
  }
  const auto fastest = [](const std::vector<Measured>& all) {
    return *std::min_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.wall_s < b.wall_s; });
  };
  row(name, "Box2D", fastest(box2d), 0);
  row(name, "blockweir", fastest(us), fastest(box2d).wall_s);
}

void compare_wall(int rows, int columns, double duration_s, int rounds) {
  compare(fmt::format("wall {}x{}", rows, columns), test::wall(rows, columns, 1), duration_s, 20, rounds);
}

void compare_heap(int stones, double duration_s, int rounds) {
  compare(fmt::format("heap {}", stones), test::heap(stones, 1), duration_s, 0, rounds);
}

/// Walls that gravity tilts, and heaps, of 60 to 290 blocks. What stands is judged by a drop of all by a tenth of a
/// metre.
void random_falls(unsigned from, unsigned to) {
  double made = 0;
  double overlap_m = 0;
  for (unsigned seed = from; seed <= to; ++seed) {
    const scene::Scene scene = test::random_fall(seed);
    solid::Solid solid(scene);
    const Measured all = measured(ours(solid), std::lround(scene.analysis.duration_s / step_s));
    double weight_n = 0;
    for (const solid::Block& block : solid.blocks()) weight_n += block.fixed ? 0 : block.mass_per_m() * 9.81;
    fmt::print("{:>4} {} of {:<4} {:>8.1f} ms, slowest/median {:>6.1f}, made {:.1e}, overlap {:.1e} m\n", seed,
               scene.analysis.gravity_tilt_deg == 0 ? "heap" : "wall", solid.blocks().size(), 1e3 * all.wall_s,
               all.slowest_over_median, all.fall.made_over(0.1 * weight_n), all.fall.overlap_m());
    std::fflush(stdout);
    made = std::max(made, all.fall.made_over(0.1 * weight_n));
    overlap_m = std::max(overlap_m, all.fall.overlap_m());
  }
  fmt::print("made over dissipated up to {:.1e}, overlap up to {:.1e} m\n", made, overlap_m);
}

}  // namespace

int main(int argc, char** argv) {
  const bool large = argc > 1 && std::string(argv[1]) == "--large";
  if (argc == 4 && std::string(argv[1]) == "--random") {
    random_falls(static_cast<unsigned>(std::stoul(argv[2])), static_cast<unsigned>(std::stoul(argv[3])));
    return 0;
  }
  if (argc > (large ? 2 : 1)) only = argv[large ? 2 : 1];
  fmt::print("{:<16} {:<10} {:>10} {:>8} {:>16} {:>16} {:>14}\n", "scene", "program", "wall [ms]", "/ Box2D",
             "slowest/median", "made/dissipated", "overlap [m]");
  if (large) {
    compare_heap(10'000, 1, 1);
    compare_wall(200, 50, 1, 1);
    return 0;
  }
  for (const auto& [rows, columns] : {std::pair{10, 2}, {20, 3}, {30, 4}, {40, 10}}) {
    compare_wall(rows, columns, 3, rows < 40 ? 2 : 1);
  }
  for (const int stones : {25, 100, 400}) compare_heap(stones, 3, stones < 400 ? 2 : 1);
  compare_wall(50, 20, 1, 1);
  compare_heap(1000, 1, 1);
}
