// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/independent/random_structures.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "tests/independent/limit_analysis.hpp"
#include "tests/independent/random_section.hpp"
#include "tests/independent/rock_foundation.hpp"
#include "tests/independent/voronoi_cells.hpp"

namespace blockweir::independent {
namespace {

/// Tries until the structure fails at a level worth the trial.
template <class Draw>
RandomStructure drawn(std::uint64_t seed, const char* kind, Draw draw) {
  Random random(seed, kind);
  for (;;) {
    RandomStructure one{.seed = seed, .kind = kind};
    draw(random, one);
    const double high_m = 1.15 * one.height_m;
    if (one.stacks.empty()) {
      const auto limit = limit_level(one.structure, 0.3 * one.height_m, high_m);
      if (!limit) continue;
      one.level_m = limit->level_m;
      if (one.kind == "on_rock") one.by_hand = failing_on_rock(one.structure, *limit, 2 * one.height_m);
      if (one.by_hand) one.level_m = one.by_hand->level_m;
      return one;
    }
    one.by_hand = first_failure(one.stacks, high_m);
    one.level_m = one.by_hand->level_m;
    const bool stands_before = one.level_m > 0.3 * one.height_m && one.by_hand->head_m > 0.2 * one.height_m &&
                               first_failure(one.stacks, 2 * high_m).level_m == one.level_m;
    if (stands_before && one.level_m < high_m) return one;
  }
}

double random_height(Random& random) {
  return random.between_orders(3e-3, 3e3);
}

void draw_monolith(Random& random, RandomStructure& one) {
  const Section section = random_section(random, random_height(random));
  Structure& s = one.structure;
  one.height_m = section.height;
  s.density_kg_per_m3 = random.between(2000, 2700);
  s.bodies = {ground_under(section), {"dam", section.outline()}};
  const Law law = random_law(random, s.density_kg_per_m3 * gravity * section.height / 2);
  if (random.chance(0.3)) s.tail_level_m = section.height * random.between(0.05, 0.3);
  s.joints = {{"base", "ground", "dam", law}};
  one.stacks = {stack_of("base", Vec(0, 0), section.toe(), section.face_top(), section.back_top(), law,
                         s.density_kg_per_m3, s.tail_level_m)};
}

void draw_gravity_section(Random& random, RandomStructure& one) {
  Section section = random_section(random, random.between(5, 60));
  section.dip = 0;
  Structure& s = one.structure;
  one.height_m = section.height;
  s.density_kg_per_m3 = random.between(2200, 2600);
  s.bodies = {ground_under(section), {"dam", section.outline()}};
  Law law{.friction_deg = random.between(30, 60)};
  if (random.chance(0.5)) law.cohesion_pa = random.between(0, 0.4) * s.density_kg_per_m3 * gravity * section.height / 2;
  law.uplift = static_cast<Uplift>(one.seed % 5);
  if (law.uplift == Uplift::drained) {
    law.drain_m = section.base * random.between(0.05, 0.5);
    law.drain_efficiency = random.between(0, 1);
  }
  if (random.chance(0.4)) s.tail_level_m = section.height * random.between(0.05, 0.3);
  s.joints = {{"base", "ground", "dam", law}};
  one.stacks = {stack_of("base", Vec(0, 0), section.toe(), section.face_top(), section.back_top(), law,
                         s.density_kg_per_m3, s.tail_level_m)};
}

void draw_lifts(Random& random, RandomStructure& one) {
  const Section section = random_section(random, random_height(random));
  Structure& s = one.structure;
  one.height_m = section.height;
  s.density_kg_per_m3 = random.between(2000, 2700);
  const double stress = s.density_kg_per_m3 * gravity * section.height / 2;
  const std::size_t count = 2 + random.below(7);
  const std::size_t weak = random.chance(0.5) ? 0 : random.below(count);
  s.others = {.friction_deg = 60, .cohesion_pa = 20 * stress, .tension_pa = 10 * stress};
  if (random.chance(0.3)) s.tail_level_m = section.height * random.between(0.05, 0.2);
  s.bodies = {ground_under(section)};
  double from = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double share = static_cast<double>(k + 1) / static_cast<double>(count);
    const double to = k + 1 == count ? 1 : share + random.between(-0.2, 0.2) / static_cast<double>(count);
    const std::string name = "lift" + std::to_string(k);
    const std::string below = s.bodies.back().name;
    const std::string joint = k == 0 ? "base" : "joint" + std::to_string(k);
    s.bodies.push_back(
        {name, {section.on_face(from), section.on_back(from), section.on_back(to), section.on_face(to)}});
    Law law = s.others;
    if (k == weak) {
      law = random_law(random, 0);
      s.joints.push_back({joint, below, name, law});
    } else if (k == 0) {
      s.joints.push_back({joint, below, name, law});
    }
    one.stacks.push_back(stack_of(joint, section.on_face(from), section.on_back(from), section.face_top(),
                                  section.back_top(), law, s.density_kg_per_m3, s.tail_level_m));
    from = to;
  }
}

/// Upright lifts that friction alone holds on each other; the lowest has cohesion on the ground and no tension
/// strength.
void draw_loose_lifts(Random& random, RandomStructure& one) {
  Structure& s = one.structure;
  one.height_m = random_height(random);
  const double width = one.height_m * random.between(0.3, 0.5);
  s.density_kg_per_m3 = random.between(2000, 2700);
  s.others = {.friction_deg = 60};
  s.bodies = {ground_under({.height = one.height_m, .base = width})};
  const std::size_t count = 2 + random.below(4);
  for (std::size_t k = 0; k < count; ++k) {
    const double low = one.height_m * static_cast<double>(k) / static_cast<double>(count);
    const double high = one.height_m * static_cast<double>(k + 1) / static_cast<double>(count);
    const std::string name = "lift" + std::to_string(k);
    Law law = s.others;
    if (k == 0) {
      law.cohesion_pa = random.between(0.05, 0.5) * s.density_kg_per_m3 * gravity * one.height_m;
      law.uplift = random.of(std::vector{Uplift::none, Uplift::triangular, Uplift::full});
    }
    const std::string joint = k == 0 ? "base" : "joint" + std::to_string(k);
    s.joints.push_back({joint, s.bodies.back().name, name, law});
    s.bodies.push_back({name, {Vec(0, low), Vec(width, low), Vec(width, high), Vec(0, high)}});
    one.stacks.push_back(stack_of(joint, Vec(0, low), Vec(width, low), Vec(0, one.height_m), Vec(width, one.height_m),
                                  law, s.density_kg_per_m3, none_m));
  }
}

/// From the middle of the crest into the ground between heel and toe, with a pull that does not change.
void draw_anchored(Random& random, RandomStructure& one) {
  random.chance(0.5) ? draw_monolith(random, one) : draw_lifts(random, one);
  Structure& s = one.structure;
  const Stack& whole = one.stacks.front();
  const Vec head = (whole.face_top_m + whole.back_top_m) / 2;
  const Vec foot(whole.toe_m.x() * random.between(0.05, 0.4), -0.3 * one.height_m);
  const double yield = whole.weight_n_per_m * random.between(0.05, 0.3);
  s.bolts = {{.name = "anchor",
              .body = s.bodies.back().name,
              .from_m = head,
              .to_m = foot,
              .stiffness_n_per_m2 = 30 * whole.weight_n_per_m / one.height_m,
              .prestress_n_per_m = yield,
              .yield_n_per_m = yield}};
  for (Stack& stack : one.stacks) stack.bolts = s.bolts;
}

/// Friction alone, as a bond would break before the anchor yields; the anchor stretches on the way to its yield.
void draw_stretching(Random& random, RandomStructure& one) {
  draw_monolith(random, one);
  Structure& s = one.structure;
  Stack& whole = one.stacks.front();
  whole.law.cohesion_pa = whole.law.tension_pa = 0;
  s.joints.front().law = whole.law;
  // Along the base and into it, so that it stretches whether the dam slides or turns.
  const bool low = random.chance(0.3);
  const Vec along = (whole.heel_m - whole.toe_m).normalized();
  const double steep = low ? 0 : random.between(0.9, 1.3);  // flat ones at the crest would hold it as the foot slides
  const Vec way = std::cos(steep) * along + std::sin(steep) * Vec(-along.y(), along.x());
  const Vec head = low ? Vec(whole.heel_m + 0.1 * (whole.face_top_m - whole.heel_m))
                       : Vec((whole.face_top_m + whole.back_top_m) / 2);
  const Vec foot = head + 1.5 * one.height_m * way;
  const double yield = whole.weight_n_per_m * random.between(0.05, 0.3);
  const double prestress = random.chance(0.5) ? 0 : yield * random.between(0, 0.9);
  // With its short lever a low one lets the dam lean as a failure does before it yields.
  const double stretch_m = one.height_m * random.between_orders(1e-6, low ? 3e-5 : 3e-4);
  s.bolts = {{.name = "anchor",
              .body = s.bodies.back().name,
              .from_m = head,
              .to_m = foot,
              .stiffness_n_per_m2 = (yield - prestress) / stretch_m,
              .prestress_n_per_m = prestress,
              .yield_n_per_m = yield}};
  whole.bolts = s.bolts;
}

/// Bed of rock from a joint below the heel to where its bedding comes to the surface.
void draw_on_rock(Random& random, RandomStructure& one) {
  Section section = random_section(random, random.between_orders(0.3, 300));
  section.dip = 0;
  Structure& s = one.structure;
  const double h = section.height;
  one.height_m = h;
  const double depth = h * random.between(0.1, 0.3);
  const double fall = std::tan(random.between(0, 8) * std::numbers::pi / 180);
  const double length = section.base + h * random.between(0.05, 0.3);
  const auto on_bedding = [&](double x) { return Vec(x, -depth - fall * x); };
  const Vec end = on_bedding(length + 2 * h);
  const double floor = end.y() - h / 2;
  s.bodies = {
      {"ground", {Vec(-2 * h, floor), Vec(end.x(), floor), end, on_bedding(0), Vec(0, 0), Vec(-2 * h, 0)}, true},
      {"rock", {on_bedding(0), on_bedding(length), Vec(length, 0), Vec(0, 0)}},
      {"dam", section.outline()}};
  s.joints = {{"contact", "rock", "dam", {.friction_deg = random.between(45, 60)}},
              {"bedding", "ground", "rock", {.friction_deg = random.between(15, 35)}}};
}

void draw_bricks(Random& random, RandomStructure& one) {
  Structure& s = one.structure;
  const double h = random.between_orders(0.3, 300);
  one.height_m = h;
  s.density_kg_per_m3 = random.between(2000, 2700);
  const std::size_t rows = 3 + random.below(5);
  const std::size_t columns = 2 + random.below(3);
  const double width = h * random.between(0.5, 0.9);
  const double length = width / static_cast<double>(columns);
  s.others.friction_deg = random.between(25, 45);
  s.bodies = {ground_under({.height = h, .base = width})};
  for (std::size_t row = 0; row < rows; ++row) {
    std::vector<double> ends = {0};
    for (double x = row % 2 == 0 ? length : length / 2; x < width - length / 4; x += length) ends.push_back(x);
    ends.push_back(width);
    const double low = h * static_cast<double>(row) / static_cast<double>(rows);
    const double high = h * static_cast<double>(row + 1) / static_cast<double>(rows);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      s.bodies.push_back({"b" + std::to_string(row) + "-" + std::to_string(k),
                          {Vec(ends[k], low), Vec(ends[k + 1], low), Vec(ends[k + 1], high), Vec(ends[k], high)}});
    }
  }
}

void draw_voronoi(Random& random, RandomStructure& one) {
  Structure& s = one.structure;
  Section of{.height = random.between_orders(0.3, 300)};
  of.base = of.height * random.between(0.5, 0.9);
  of.crest = of.base * random.between(0.2, 0.6);
  one.height_m = of.height;
  s.density_kg_per_m3 = random.between(2000, 2700);
  s.others.friction_deg = random.between(25, 45);
  std::vector<std::vector<Vec>> cells;
  while (cells.empty()) {
    std::vector<Vec> seeds(5 + random.below(36));
    for (Vec& seed : seeds) seed = {random.between(0, of.base), random.between(0, of.height)};
    cells = voronoi_cells(of.outline(), seeds, 1e-2 * of.height);
  }
  s.bodies = {ground_under(of)};
  for (std::size_t k = 0; k < cells.size(); ++k) s.bodies.push_back({"v" + std::to_string(k), cells[k]});
}

template <class T>
void shuffle(std::vector<T>& all, Random& random) {
  for (std::size_t k = all.size(); k > 1; --k) std::swap(all[k - 1], all[random.below(k)]);
}

}  // namespace

RandomStructure monolith(std::uint64_t seed) {
  return drawn(seed, "monolith", draw_monolith);
}

RandomStructure gravity_section(std::uint64_t seed) {
  return drawn(seed, "gravity_section", draw_gravity_section);
}

RandomStructure lifts(std::uint64_t seed) {
  return drawn(seed, "lifts", draw_lifts);
}

RandomStructure anchored(std::uint64_t seed) {
  return drawn(seed, "anchored", draw_anchored);
}

RandomStructure loose_lifts(std::uint64_t seed) {
  return drawn(seed, "loose_lifts", draw_loose_lifts);
}

RandomStructure stretching(std::uint64_t seed) {
  return drawn(seed, "stretching", draw_stretching);
}

RandomStructure on_rock(std::uint64_t seed) {
  return drawn(seed, "on_rock", draw_on_rock);
}

RandomStructure bricks(std::uint64_t seed) {
  return drawn(seed, "bricks", draw_bricks);
}

RandomStructure voronoi(std::uint64_t seed) {
  return drawn(seed, "voronoi", draw_voronoi);
}

Structure reordered(Structure structure, std::uint64_t seed) {
  Random random(seed, "order");
  shuffle(structure.bodies, random);
  shuffle(structure.joints, random);
  for (Joint& joint : structure.joints) {
    if (random.chance(0.5)) std::swap(joint.below, joint.above);
  }
  return structure;
}

}  // namespace blockweir::independent
