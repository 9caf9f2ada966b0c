// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step box2d::box2d
// blockweir beside Box2D in one run: the same scenes, wall time from the description of the blocks to the end of the
// motion, and the error of the answer. Box2D takes 16 velocity and 16 position iterations a step of 1/60 s. No sleep on
// either side, except where a row says so.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "solid/step/solid.hpp"
#include "tests/bench/peers/box2d_world.hpp"
#include "tests/large_scenes.hpp"

namespace {

using namespace blockweir;
using scene::Point;

constexpr double dip = 30 * std::numbers::pi / 180;
constexpr double step_s = 1.0 / 60;
constexpr double long_step_s = 1.0 / 20;

/// A rectangle on a long plane of 30 degrees, friction 20 degrees.
scene::Scene incline() {
  scene::Scene scene = large_scene(std::tan(20 * std::numbers::pi / 180));
  const auto turned = [](std::vector<Point> vertices) {
    for (Point& p : vertices) p = Eigen::Rotation2Dd(-dip) * p;
    return vertices;
  };
  add_block(scene, turned(box(-2, -1, 14, 1)), true);
  add_block(scene, turned(box(0, 0, 0.5, 0.2)));
  scene.analysis.max_displacement_ratio = 0.5;
  return scene;
}

scene::Scene column(int cubes) {
  scene::Scene scene = large_scene(1);
  add_block(scene, box(-20, -1, 41, 1), true);
  for (int i = 0; i < cubes; ++i) add_block(scene, box(0, i, 1, 1));
  return scene;
}

/// What a program ends with.
struct End {
  double wall_s = 0;
  double moved_m = 0;     ///< farthest that a block's centre has moved
  double reaction_n = 0;  ///< of the ground, along its normal
};

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

End blockweir_to(const scene::Scene& described, double duration_s, double dt, bool sleep) {
  scene::Scene scene = described;
  scene.analysis.sleep = sleep;
  scene.analysis.step_s = dt;
  End end;
  end.wall_s = seconds([&] {
    solid::Solid solid(scene);
    solid.settle({});
    const auto steps = std::lround(duration_s / dt);
    for (long n = 0; n < steps; ++n) {
      solid.advance(static_cast<double>(n) * dt, static_cast<double>(n + 1) * dt, {});
    }
    for (const auto& state : solid.states()) end.moved_m = std::max(end.moved_m, state.displacement.head<2>().norm());
    for (const auto& c : solid.contacts()) {
      if (c.edge_block == 0 || c.vertex_block == 0) end.reaction_n += c.force.x();
    }
  });
  return end;
}

End box2d_to(const scene::Scene& scene, double duration_s, bool sleep) {
  End end;
  end.wall_s = seconds([&] {
    const auto [world, bodies, centroid] = peers::box2d_world(scene, sleep);
    const auto steps = std::lround(duration_s / step_s);
    for (long n = 0; n < steps; ++n) world->Step(static_cast<float>(step_s), peers::iterations, peers::iterations);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const b2Vec2 moved = bodies[b]->GetPosition() - peers::vec(centroid[b]);
      end.moved_m = std::max(end.moved_m, static_cast<double>(moved.Length()));
    }
    for (const b2Contact* c = world->GetContactList(); c != nullptr; c = c->GetNext()) {
      if (c->GetFixtureA()->GetBody() != bodies[0] && c->GetFixtureB()->GetBody() != bodies[0]) continue;
      const b2Manifold& manifold = *c->GetManifold();
      for (int i = 0; i < manifold.pointCount; ++i) {
        end.reaction_n += static_cast<double>(manifold.points[i].normalImpulse) / step_s;
      }
    }
  });
  return end;
}

struct Comparison {
  std::string name;
  std::string quantity;
  scene::Scene scene;
  double duration_s;
  std::function<double(const End&)> error;
  int rounds;
};

void row(const Comparison& of, const char* program, const std::vector<End>& ends, double other_s) {
  double fastest = ends[0].wall_s;
  for (const End& end : ends) fastest = std::min(fastest, end.wall_s);
  fmt::print("{:<18} {:<20} {:>10.2f} {:>8} {:>12.2e}  {}\n", of.name, program, 1e3 * fastest,
             other_s > 0 ? fmt::format("{:.2f}", fastest / other_s) : "", of.error(ends[0]), of.quantity);
}

void compare(const Comparison& of) {
  std::vector<End> theirs;
  std::vector<End> ours;
  std::vector<End> ours_in_long_steps;
  std::vector<End> ours_asleep;
  std::vector<End> theirs_asleep;
  for (int i = 0; i < of.rounds; ++i) {  // by turns: whatever else the machine does meets both
    theirs.push_back(box2d_to(of.scene, of.duration_s, false));
    ours.push_back(blockweir_to(of.scene, of.duration_s, step_s, false));
    ours_in_long_steps.push_back(blockweir_to(of.scene, of.duration_s, long_step_s, false));
    theirs_asleep.push_back(box2d_to(of.scene, of.duration_s, true));
    ours_asleep.push_back(blockweir_to(of.scene, of.duration_s, step_s, true));
  }
  double box2d_s = theirs[0].wall_s;
  for (const End& end : theirs) box2d_s = std::min(box2d_s, end.wall_s);
  row(of, "Box2D", theirs, 0);
  row(of, "blockweir", ours, box2d_s);
  row(of, "blockweir, 1/20 s", ours_in_long_steps, box2d_s);
  row(of, "Box2D, sleep", theirs_asleep, box2d_s);
  row(of, "blockweir, sleep", ours_asleep, box2d_s);
}

}  // namespace

int main() {
  fmt::print("{:<18} {:<20} {:>10} {:>8} {:>12}\n", "scene", "program", "wall [ms]", "/ Box2D", "error");
  const double slide = 9.81 * (std::sin(dip) - std::cos(dip) * std::tan(20 * std::numbers::pi / 180)) / 2;
  compare({"incline, 1 s", "of the displacement, relative", incline(), 1.0,
           [=](const End& end) { return std::abs(end.moved_m / slide - 1); }, 5});
  for (const int cubes : {20, 200}) {
    const double weight = cubes * 2000 * 9.81;
    compare({fmt::format("column {}, 2 s", cubes), "of the base reaction, relative", column(cubes), 2.0,
             [=](const End& end) { return std::abs(end.reaction_n / weight - 1); }, 3});
  }
  for (const int base : {20, 50, 100}) {
    compare({fmt::format("pyramid {}, 2 s", base), "largest drift of a centre, m", pyramid(base), 2.0,
             [](const End& end) { return end.moved_m; }, base < 100 ? 3 : 1});
  }
}
