// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic solid_block
// Random structures of 3 mm to 3 km in still water: force and moment on each block against integrals of -p n over the
// parts of their outlines that are wet by construction. BLOCKWEIR_CAMPAIGN=N in the environment: N of each kind.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"
#include "fluid/hydrostatic/hydrostatic_model.hpp"
#include "solid/block/panel.hpp"
#include "tests/samples.hpp"
#include "tests/water_models.hpp"

namespace blockweir::hydrostatic::water_loads_property_test {
namespace {

using tests::dry;
using tests::Loaded;
using tests::Model;
using tests::Random;
using tests::weight;

int runs() {
  const char* campaign = std::getenv("BLOCKWEIR_CAMPAIGN");
  return campaign != nullptr ? std::max(1, std::atoi(campaign)) : test::samples(30);
}

struct Resultant {
  Point force = Point::Zero();
  double moment = 0;  ///< about the centroid of the block's outline

  void add(const Point& force_there, const Point& arm) {
    force += force_there;
    moment += arm.x() * force_there.y() - arm.y() * force_there.x();
  }
};

std::vector<Resultant> expected(const Model& model) {
  std::vector<Resultant> sums(model.outlines.size());
  for (const Loaded& l : model.loaded) {
    const Point centre = geometry::centroid(model.outlines[at(l.block)]);
    const Point inward(-(l.b - l.a).y(), (l.b - l.a).x());
    const auto part = [&](double share, double of_it) {  // Simpson's rule, exact for p linear and x linear
      const double p = l.pressure_a + share * (l.pressure_b - l.pressure_a);
      sums[at(l.block)].add(of_it * p * inward, l.a + share * (l.b - l.a) - centre);
    };
    part(0, 1.0 / 6), part(0.5, 4.0 / 6), part(1, 1.0 / 6);
  }
  return sums;
}

scene::Scene scene_of(const Model& model, double width) {
  scene::Scene scene;
  scene.materials.push_back({"stone", 30e9, 0.2, model.density});
  for (std::size_t b = 0; b < model.outlines.size(); ++b) {
    scene::Block& block = scene.blocks.emplace_back();
    block.name = std::to_string(b);
    block.vertices = model.outlines[b];
    block.fixed = model.fixed[b];
  }
  scene.joints = model.joints;
  if (model.upstream != dry) scene.water.upstream_level_m = scene::TimeTable::constant(model.upstream);
  if (model.downstream != dry) scene.water.downstream_level_m = scene::TimeTable::constant(model.downstream);
  scene.water.open_crack_width_m = width;
  scene.water.elements_per_face = 1;
  return scene;
}

std::vector<Resultant> obtained(const scene::Scene& scene) {
  HydrostaticModel fluid(scene);
  wire::Motion motion;
  motion.displacement.own().resize(scene.blocks.size());
  wire::Load load;
  fluid.advance(motion, 0, load);
  std::vector<Resultant> sums(scene.blocks.size());
  for (std::size_t i = 0; i < load.block.size(); ++i) {
    const std::size_t b = load.block[i];
    const auto block = solid::make_block(scene.blocks[b], scene.materials[0], scene::Plane::strain);
    const solid::Placement placement(block.centroid, solid::Vector6::Zero());
    const auto acting = solid::panel_force(block, placement,
                                           {static_cast<int>(b), static_cast<int>(load.edge[i]), load.s_from[i],
                                            load.s_to[i], load.pressure_from_pa[i], load.pressure_to_pa[i]},
                                           scene.water.nodal_rule);
    for (std::size_t k = 0; k < 2; ++k) sums[b].add(acting.force[k], acting.node[k]);
  }
  return sums;
}

/// The largest difference of a force over rho g H^2, and of a moment over rho g H^3.
double worst(const std::vector<Resultant>& a, const std::vector<Resultant>& b, double height) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, (a[i].force - b[i].force).norm() / (weight * height * height));
    most = std::max(most, std::abs(a[i].moment - b[i].moment) / (weight * std::pow(height, 3)));
  }
  return most;
}

Model mirrored(Model model) {
  for (auto& outline : model.outlines) {
    for (Point& p : outline) p.x() *= -1;
    std::reverse(outline.begin(), outline.end());
  }
  for (auto& [block, a, b, pressure_a, pressure_b] : model.loaded) {
    std::swap(a, b);
    std::swap(pressure_a, pressure_b);
    a.x() *= -1;
    b.x() *= -1;
  }
  std::swap(model.upstream, model.downstream);
  return model;
}

Model moved(Model model, double scale, const Point& way) {
  const auto move = [&](Point& p) { p = scale * (p + way); };
  for (auto& outline : model.outlines) std::for_each(outline.begin(), outline.end(), move);
  for (Loaded& l : model.loaded) {
    move(l.a), move(l.b);
    l.pressure_a *= scale;
    l.pressure_b *= scale;
  }
  for (double* level : {&model.upstream, &model.downstream}) {
    if (*level != dry) *level = scale * (*level + way.y());
  }
  model.height *= scale;
  return model;
}

Model shuffled(const Model& model, Random& any) {
  std::vector<int> place(model.outlines.size());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), any.engine());
  Model other = model;
  for (std::size_t b = 0; b < place.size(); ++b) {
    other.outlines[at(place[b])] = model.outlines[b];
    other.fixed[at(place[b])] = model.fixed[b];
  }
  for (Loaded& l : other.loaded) l.block = place[at(l.block)];
  for (scene::Joint& joint : other.joints) {
    for (int& block : joint.between) block = place[at(block)];
  }
  return other;
}

class RandomStructures : public testing::Test {
 protected:
  /// Of any size, anywhere, in any order, with any width of cracks that are shut, seen from either side.
  template <class Kind>
  void check(Kind kind, bool has_mirror_image = true) {
    double most = 0;
    for (int seed = 0; seed < runs(); ++seed) {
      Random any(static_cast<unsigned>(seed));
      Model model = kind(any);
      if (has_mirror_image && any.toss()) model = mirrored(std::move(model));
      const double scale = any.of_any_size(3e-4, 300);
      model = shuffled(moved(std::move(model), scale, {any.between(-100, 100), any.between(-100, 100)}), any);
      const double width = scale * any.of_any_size(1e-6, 0.3);
      const double off = worst(obtained(scene_of(model, width)), expected(model), model.height);
      EXPECT_LT(off, 1e-9) << "seed " << seed << ", a metre is " << scale << " m, width " << width / scale;
      most = std::max(most, off);
    }
    std::printf("largest error of %d: %.3g\n", runs(), most);
  }
};

TEST_F(RandomStructures, DamsOnGroundArePressedOnTheirFaces) {
  check(tests::dam_on_ground);
}

TEST_F(RandomStructures, WallsThatStandAloneArePressedOnTheirFaces) {
  check(tests::wall_alone);
}

TEST_F(RandomStructures, FloatingBlocksLoseTheWeightOfTheirWater) {
  check(tests::floating_block);
}

TEST_F(RandomStructures, SlabsOverWaterArePressedOnceByWhatConnectsThePools) {
  check(tests::culvert);
}

TEST_F(RandomStructures, NoWaterPressesTheEndsOfJointedRock) {
  check(tests::dam_on_rock);
}

TEST_F(RandomStructures, CracksAreFilledByTheirLaw) {
  check(tests::cracked_dam, false);
}

/// Off by C/N^2, C being what faces longer than the dam is high make of 1/6.
TEST_F(RandomStructures, LumpedForcesConvergeWithTheSquareOfTheElements) {
  for (int seed = 0; seed < runs(); ++seed) {
    Random any(static_cast<unsigned>(seed));
    const Model model = tests::cracked_dam(any);
    scene::Scene scene = scene_of(model, 0.01);
    scene.water.nodal_rule = scene::NodalRule::lumped;
    const auto error = [&](int elements) {
      scene.water.elements_per_face = elements;
      return worst(obtained(scene), expected(model), model.height);
    };
    for (const int n : {20, 80, 320}) EXPECT_LT(error(n), 4.0 / (n * n)) << seed;
  }
}

}  // namespace
}  // namespace blockweir::hydrostatic::water_loads_property_test
