// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch bridge_scene_read
// A mechanism of blocks that strain as they go: its contacts seem to hold it, time and again. It has failed all the
// same, from when it was last at rest.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bridge/scene/read/read.hpp"
#include "solid/watch/failure_watch.hpp"

namespace blockweir::solid::straining_mechanism_test {
namespace {

/// A section that oblique joints cut, on ground that tilts: limit analysis has 0.95 of the strength that it needs.
const std::vector<std::vector<std::vector<double>>> oblique = {
    {{0.425505043845, 0.822556928828}, {0.898930690606, 2}, {0.448152044487, 2}, {0.191062953505, 0.852670230361}},
    {{1.50056418946, 1.17045166805}, {1.68644607994, 2}, {1.38711197879, 2}, {1.09213426693, 1.31456635012}},
    {{1.2010227487, 1.2761450003},
     {1.09213426693, 1.31456635012},
     {0.75798137885, 0.538102147981},
     {0.841261307918, 0.520903594527}},
    {{1.27633284471, 0.169758499261},
     {1.33229349839, 0.419498088183},
     {0.75798137885, 0.538102147981},
     {0.689539244867, 0.379064567125}},
    {{0.877293542849, 1.43045306424}, {1.17232572995, 2}, {0.898930690606, 2}, {0.701230955951, 1.50830677566}},
    {{0.136301590151, 0}, {0.430514779643, 0}, {1.13550427503, 1.92891776649}},
    {{0.0947718172775, 0}, {0.136301590151, 0}, {0.624765571042, 0.942958686245}, {0.495491789107, 0.996618914794}},
    {{0.624765571042, 0.942958686245},
     {0.877293542849, 1.43045306424},
     {0.701230955951, 1.50830677566},
     {0.495491789107, 0.996618914794}},
    {{0.430514779643, 0}, {0.526408066993, 0}, {1.38711197879, 2}, {1.17232572995, 2}, {1.13550427503, 1.92891776649}},
    {{1.39608328824, 0.704177319869},
     {1.50056418946, 1.17045166805},
     {1.35402559193, 1.22215787817},
     {1.04277960013, 0.70610292489}},
    {{1.35402559193, 1.22215787817},
     {1.2010227487, 1.2761450003},
     {0.841261307918, 0.520903594527},
     {0.921132778706, 0.50440893879}},
    {{0.526408066993, 0}, {1.23829403545, 0}, {1.27633284471, 0.169758499261}, {0.689539244867, 0.379064567125}},
    {{1.33229349839, 0.419498088183},
     {1.39608328824, 0.704177319869},
     {1.04277960013, 0.70610292489},
     {0.921132778706, 0.50440893879}},
    {{0, 0}, {0.0947718172775, 0}, {0.425505043845, 0.822556928828}, {0.191062953505, 0.852670230361}},
};

scene::Scene section(double friction_deg, double step_s) {
  std::string text = fmt::format(R"(analysis = {{ duration_s = 1.5, gravity_tilt_deg = 10, step_s = {} }}
joint = {{ friction_angle_deg = {} }}
material.m = {{ youngs_modulus_pa = 2e10, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }}
[[block]]
name = "ground"
material = "m"
fixed = true
vertices_m = [[-4, -1], [6, -1], [6, 0], [-4, 0]]
)",
                                 step_s, friction_deg);
  for (std::size_t b = 0; b < oblique.size(); ++b) {
    text += fmt::format("[[block]]\nname = \"b{}\"\nmaterial = \"m\"\nvertices_m = {}\n", b, oblique[b]);
  }
  return scene::read_text(text, "section.toml").scene;
}

/// Some steps had dated it at 0.15 to 0.55 s, where it had moved by a tenth of a metre at 0.4 m/s, and "stood" before.
TEST(StrainingMechanism, HasFailedSinceItWasAtRest) {
  constexpr double fifth_s = 0.06;  // by then joints have slipped by a fifth of a failure
  for (const double step_s : {2.5e-3, 5e-3, 1e-2}) {
    const scene::Scene scene = section(35.54313957980634, step_s);
    Solid solid(scene);
    FailureWatch watch(solid);
    solid.settle({});
    watch.look(0, {});
    bool moved = false;
    for (long n = 0; watch.failures().empty() && solid.time_s() < scene.analysis.duration_s; ++n) {
      const double t = static_cast<double>(n) * step_s;
      solid.advance(t, t + step_s, {});
      watch.look(t + step_s, {});
      if (solid.largest_displacement_m() < 2 * scene.analysis.failure_displacement_m) continue;
      moved = true;
      EXPECT_TRUE(watch.moving() || watch.failed()) << step_s << " s: " << t;
    }
    EXPECT_TRUE(moved);
    ASSERT_TRUE(watch.failed()) << step_s;
    EXPECT_LE(watch.failures().front().time_s, fifth_s) << step_s;
  }
}

TEST(StrainingMechanism, StandsWhereJointsHoldIt) {
  const scene::Scene scene = section(45, 1e-2);
  Solid solid(scene);
  FailureWatch watch(solid);
  solid.settle({});
  watch.look(0, {});
  for (long n = 0; n < 150; ++n) {
    const double t = static_cast<double>(n) * 1e-2;
    solid.advance(t, t + 1e-2, {});
    watch.look(t + 1e-2, {});
  }
  EXPECT_FALSE(watch.failed());
  EXPECT_FALSE(watch.moving());
}

}  // namespace
}  // namespace blockweir::solid::straining_mechanism_test
