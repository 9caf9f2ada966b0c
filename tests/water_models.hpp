// SPDX-License-Identifier: GPL-3.0-or-later
// Random structures of some 10 m whose wet faces are known by construction.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "bridge/scene/at.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::tests {

using scene::Point;

inline constexpr double weight = 9810;  // of water [N/m3]
inline constexpr double dry = -1e300;   // level of a side without a pool

/// Part of a block's outline, which runs counter-clockwise, under pressures that are linear from a to b.
struct Loaded {
  int block;
  Point a;
  Point b;
  double pressure_a;
  double pressure_b;
};

/// A structure whose water is known.
struct Model {
  std::vector<std::vector<Point>> outlines;
  std::vector<bool> fixed;
  std::vector<Loaded> loaded;
  std::vector<scene::Joint> joints;
  double upstream = dry;
  double downstream = dry;
  double height = 10;
  double density = 2400;

  int add(std::vector<Point> outline, bool is_fixed = false) {
    outlines.push_back(std::move(outline));
    fixed.push_back(is_fixed);
    return static_cast<int>(outlines.size()) - 1;
  }
  /// The part of a straight face that lies under the level is wet.
  void wet(int block, Point a, Point b, double level) {
    if (a.y() >= level && b.y() >= level) return;
    const auto cut = [&](const Point& below, const Point& above) {
      return Point(below + (above - below) * ((level - below.y()) / (above.y() - below.y())));
    };
    if (a.y() > level) a = cut(b, a);
    if (b.y() > level) b = cut(a, b);
    const auto pressure = [&](const Point& p) { return weight * std::max(0.0, level - p.y()); };
    loaded.push_back({block, a, b, pressure(a), pressure(b)});
  }
  /// Edges first..last of a block.
  void wet(int block, int first, int last, double level) {
    const auto& outline = outlines[at(block)];
    for (int e = first; e <= last; ++e) wet(block, outline[at(e)], outline[(at(e) + 1) % outline.size()], level);
  }
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  double of_any_size(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  bool toss() { return engine_() % 2 == 0; }
  int count(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  std::mt19937& engine() { return engine_; }

 private:
  std::mt19937 engine_;
};

/// A dam of 10 m whose faces go in and out; the first edge is its base.
inline std::vector<Point> dam(Random& any) {
  const double base = any.between(6, 12);
  std::vector<Point> outline = {{0, 0}, {base, 0}};
  const double crest = any.between(2, 4);
  const auto face = [&](double from, double to, bool upwards) {
    const int n = any.count(0, 4);
    for (int i = 0; i < n; ++i) {
      const double share = (i + 0.5 + any.between(-0.25, 0.25)) / n;
      const double height = upwards ? 10 * share : 10 * (1 - share);
      outline.emplace_back(from + (to - from) * share + any.between(-0.4, 0.4) * std::min(1.0, 3.0 / n), height);
    }
  };
  const double lean = any.between(-0.5, 2);
  face(base, lean + crest, true);
  outline.emplace_back(lean + crest, 10);
  outline.emplace_back(lean, 10);
  face(lean, 0, false);
  return outline;
}

inline int crest_edge(const std::vector<Point>& dam) {
  int edge = 1;
  while (dam[at(edge)].y() < 10) ++edge;
  return edge;
}

inline void wet_dam(Model& model, int block) {
  const int crest = crest_edge(model.outlines[at(block)]);
  model.wet(block, 1, crest - 1, model.downstream);
  model.wet(block, crest + 1, static_cast<int>(model.outlines[at(block)].size()) - 1, model.upstream);
}

inline void set_levels(Model& model, Random& any) {
  model.upstream = any.between(3, 9.9);
  model.downstream = any.toss() ? dry : any.toss() ? model.upstream : any.between(1, 9);
}

inline Model dam_on_ground(Random& any) {
  Model model;
  set_levels(model, any);
  const double left = -any.between(6, 30);
  const double right = 12 + any.between(6, 30);
  const double deep = any.between(1, 10);
  const int ground = model.add({{left, -deep}, {right, -deep}, {right, 0}, {left, 0}}, true);
  const int block = model.add(dam(any));
  model.wet(ground, {model.outlines[at(block)][1].x(), 0}, {left, 0}, dry);
  model.wet(ground, {right, 0}, model.outlines[at(block)][1], model.downstream);
  model.wet(ground, model.outlines[at(block)][0], {left, 0}, model.upstream);
  wet_dam(model, block);
  return model;
}

inline Model wall_alone(Random& any) {
  Model model;
  set_levels(model, any);
  wet_dam(model, model.add(dam(any), any.toss()));
  return model;
}

/// Under equal levels, or in one pool: all of its outline that is under water.
inline Model floating_block(Random& any) {
  Model model;
  model.upstream = any.between(4, 9);
  model.downstream = any.toss() ? model.upstream : dry;
  const int ground = model.add({{-20, -2}, {20, -2}, {20, 0}, {-20, 0}}, true);
  model.wet(ground, 2, 2, model.upstream);
  std::vector<Point> outline;
  const int corners = any.count(3, 9);
  const double radius = any.between(0.5, 2.5);
  const Point centre(any.between(-10, 10), any.between(3.5, 9));
  const double turn = any.between(0, 6.28);
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2 * std::acos(-1.0) * (i + any.between(-0.3, 0.3)) / corners;
    outline.emplace_back(centre + radius * Point(std::cos(angle), std::sin(angle)));
  }
  const int block = model.add(outline);
  model.wet(block, 0, corners - 1, model.upstream);
  if (any.toss()) {  // without ground: it is lighter than water, which is below it, too
    model.outlines.erase(model.outlines.begin());
    model.fixed.erase(model.fixed.begin());
    std::erase_if(model.loaded, [&](const Loaded& l) { return l.block == ground; });
    for (Loaded& l : model.loaded) l.block = 0;
    model.density = 600;
  }
  return model;
}

/// A slab on two walls over the ground, water below it. Levels that differ part at the middle of its top.
inline Model culvert(Random& any) {
  Model model;
  const double length = any.between(6, 12);
  const double under = any.between(1.5, 3);
  const double top = under + any.between(1, 3);
  const double foot = any.between(0.4, 1);
  model.upstream = any.between(under - 0.5, top + (any.toss() ? 2 : 0));
  model.downstream = model.upstream;
  if (any.toss()) {
    model.upstream = any.between(under, top);
    model.downstream = any.between(0.5, top);
  }
  const double middle = length / 2;
  const auto both = [&](int block, const Point& a, const Point& b) {
    const double share = (middle - a.x()) / (b.x() - a.x());
    const auto level = [&](double x) { return x < middle ? model.upstream : model.downstream; };
    if (!(share > 0 && share < 1)) return model.wet(block, a, b, level((a.x() + b.x()) / 2));
    const Point cut = a + share * (b - a);
    model.wet(block, a, cut, level(a.x()));
    model.wet(block, cut, b, level(b.x()));
  };
  const int ground = model.add({{-20, -2}, {30, -2}, {30, 0}, {-20, 0}}, true);
  both(ground, {30, 0}, {-20, 0});
  const int slab = model.add({{0, under}, {length, under}, {length, top}, {0, top}});
  const double wall = 0.5;
  const double at_m[2] = {any.between(0.5, 2), length - any.between(1.2, 2.2)};
  for (const double x : at_m) {
    const int block = model.add({{x, foot}, {x + wall, foot}, {x + wall, under}, {x, under}}, true);
    both(block, {x, foot}, {x + wall, foot});
    both(block, {x + wall, foot}, {x + wall, under});
    both(block, {x, under}, {x, foot});
  }
  both(slab, {0, under}, {at_m[0], under});
  both(slab, {at_m[0] + wall, under}, {at_m[1], under});
  both(slab, {at_m[1] + wall, under}, {length, under});
  both(slab, {length, under}, {length, top});
  both(slab, {0, top}, {0, under});
  if (model.upstream == model.downstream) model.wet(slab, {length, top}, {0, top}, model.upstream);
  return model;
}

/// Columns of rock on a fixed base, at the model's ends too, and a dam on them.
inline Model dam_on_rock(Random& any) {
  Model model;
  set_levels(model, any);
  const int block = model.add(dam(any));
  wet_dam(model, block);
  const double heel = 0;
  const double toe = model.outlines[at(block)][1].x();
  const double deep = any.between(3, 12);
  std::vector<double> x = {-any.between(10, 20), -any.between(4, 8), any.between(1, 4), toe + any.between(1, 4),
                           toe + any.between(10, 20)};
  model.add({{x.front(), -deep - 1}, {x.back(), -deep - 1}, {x.back(), -deep}, {x.front(), -deep}}, true);
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const double joint = -deep * any.between(0.3, 0.7);
    model.add({{x[i], -deep}, {x[i + 1], -deep}, {x[i + 1], joint}, {x[i], joint}});
    const int top = model.add({{x[i], joint}, {x[i + 1], joint}, {x[i + 1], 0}, {x[i], 0}});
    if (x[i] < heel) model.wet(top, {std::min(x[i + 1], heel), 0}, {x[i], 0}, model.upstream);
    if (x[i + 1] > toe) model.wet(top, {x[i + 1], 0}, {std::max(x[i], toe), 0}, model.downstream);
  }
  return model;
}

/// A dam in lifts, each with water in the joint below it.
inline Model cracked_dam(Random& any) {
  Model model;
  model.upstream = any.between(3, 9.9);
  model.downstream = any.toss() ? dry : any.between(1, 5);
  const int ground = model.add({{-20, -2}, {30, -2}, {30, 0}, {-20, 0}}, true);
  const double base = any.between(6, 12);
  const double slope = any.between(0.3, 0.5);
  model.wet(ground, {30, 0}, {base, 0}, model.downstream);
  model.wet(ground, {0, 0}, {-20, 0}, model.upstream);
  double low = 0;
  int below = ground;
  const int lifts = any.count(1, 4);
  const auto right = [&](double y) { return base - slope * y; };
  for (int i = 1; i <= lifts; ++i) {
    const double high = 10.0 * i / lifts;
    const int lift = model.add({{0, low}, {right(low), low}, {right(high), high}, {0, high}});
    model.wet(lift, 1, 1, model.downstream);
    model.wet(lift, 3, 3, model.upstream);
    scene::Joint joint{std::to_string(i), {below, lift}, {}};
    joint.law.uplift = any.toss() ? scene::Uplift::triangular : scene::Uplift::full;
    model.joints.push_back(joint);
    const auto pressure = [&](double level) { return weight * std::max(0.0, level - low); };
    const double mouth = pressure(model.upstream);
    const double end = joint.law.uplift == scene::Uplift::full ? mouth : pressure(model.downstream);
    model.loaded.push_back({lift, {0, low}, {right(low), low}, mouth, end});
    model.loaded.push_back({below, {right(low), low}, {0, low}, end, mouth});
    below = lift;
    low = high;
  }
  return model;
}

}  // namespace blockweir::tests
