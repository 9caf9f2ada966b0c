// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step solid_output bridge_scene_read box2d::box2d
// Walls that fall when gravity is tilted, and heaps of stones, beside Box2D in one run: wall time, energy made over
// energy dissipated, largest overlap of two blocks at any step's end. Steps are 0.01 s on both sides; Box2D takes 16
// velocity and 16 position iterations. Nothing sleeps.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
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

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

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
  [[nodiscard]] double made_over_dissipated() const { return made_ / (first_ - last_ + made_); }
  [[nodiscard]] double overlap_m() const { return overlap_; }

 private:
  bool begun_ = false;
  double first_ = 0;
  double last_ = 0;
  double made_ = 0;
  double overlap_ = 0;
};

/// Another program's or ours: makes a step; looks.
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

void row(const std::string& scene, const std::string& program, double wall_s, double other_s, const Fall& fall) {
  fmt::print("{:<16} {:<10} {:>10.1f} {:>8} {:>16.1e} {:>14.1e}\n", scene, program, 1e3 * wall_s,
             other_s > 0 ? fmt::format("{:.1f}", wall_s / other_s) : "", fall.made_over_dissipated(), fall.overlap_m());
  std::fflush(stdout);
}

void compare(const std::string& name, const scene::Scene& scene, int rounds) {
  constexpr long steps = 300;
  const auto all_steps = [&](const Run& run) {
    for (long n = 0; n < steps; ++n) run.step(n);
  };
  const auto watched = [&](const Run& run) {
    Fall fall;
    for (long n = 0; n < steps; ++n) run.step(n), run.look(fall);
    return fall;
  };
  double box2d_s = std::numeric_limits<double>::infinity();
  double our_s = box2d_s;
  for (int round = 0; round < rounds; ++round) {  // by turns: whatever else the machine does meets both
    box2d_s = std::min(box2d_s, seconds([&] {
                         auto world = peers::box2d_world(scene, false);
                         all_steps(theirs(scene, world));
                       }));
    our_s = std::min(our_s, seconds([&] {
                       solid::Solid solid(scene);
                       all_steps(ours(solid));
                     }));
  }
  auto world = peers::box2d_world(scene, false);
  row(name, "Box2D", box2d_s, 0, watched(theirs(scene, world)));
  solid::Solid solid(scene);
  row(name, "blockweir", our_s, box2d_s, watched(ours(solid)));
}

}  // namespace

int main() {
  fmt::print("{:<16} {:<10} {:>10} {:>8} {:>16} {:>14}\n", "scene", "program", "wall [ms]", "/ Box2D",
             "made/dissipated", "overlap [m]");
  for (const auto& [rows, columns] : {std::pair{10, 2}, {20, 3}, {30, 4}, {40, 10}}) {
    compare(fmt::format("wall {}x{}", rows, columns), test::collapse(test::wall(rows, columns, 1), 3, 20, 30),
            rows < 40 ? 2 : 1);
  }
  for (const int stones : {25, 100, 400}) {
    compare(fmt::format("heap {}", stones), test::collapse(test::heap(stones, 1), 3, 0, 30), stones < 400 ? 2 : 1);
  }
}
