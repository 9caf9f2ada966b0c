// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/independent/limit_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace blockweir::independent {
namespace {

struct Resultant {
  double right = 0;  ///< N/m
  double up = 0;
  double about_toe = 0;  ///< counter-clockwise, N

  void add(double fx, double fy, double arm_x, double arm_y) {
    right += fx;
    up += fy;
    about_toe += arm_x * fy - arm_y * fx;
  }
};

/// Pool of depth h over the foot of a face that rises by `height` and leans by `lean` to the body's side (`to` is 1
/// where the body lies right of it), foot at (foot_x, foot_y) from the toe.
void add_pool(double h, double height, double lean, double to, double foot_x, double foot_y, Resultant& sum) {
  if (h <= 0) return;
  const double wet = std::min(h, height);
  const double thrust = water_weight * (h * wet - wet * wet / 2);
  const double moment = water_weight * (h * wet * wet / 2 - wet * wet * wet / 3);  // of the thrust, about the foot
  const double up_to = moment / thrust;
  sum.add(to * thrust, 0, 0, foot_y + up_to);
  sum.add(0, -lean * thrust, foot_x + to * lean * up_to, 0);
}

/// Distance to failure, positive while it stands.
struct Margins {
  double sliding;
  double overturning;
  double sliding_factor;  ///< strength over shear
};

/// A part of the joint, by its way from the heel, in which the water's pressure is linear.
struct Stretch {
  double from_m;
  double to_m;
  double from_pa;
  double to_pa;
};

/// What a joint without tension keeps closed, b = 3 (N r - p L^2/2)/(N - p L), N at r from the closed end and p the
/// pressure at the other; all of it or nothing at most.
double closed_m(double normal, double lever, double p, double length) {
  return std::clamp(3 * (lever - p * length * length / 2) / (normal - p * length), 0.0, length);
}

/// `normal` and `about_toe`: of all but the joint's water.
std::vector<Stretch> uplift_of(const Stack& s, double level_m, double length, double normal, double about_toe) {
  const double mouth = water_weight * std::max(0.0, level_m - s.heel_m.y());
  const double far = water_weight * std::max(0.0, s.tail_level_m - s.toe_m.y());
  switch (s.law.uplift) {
    case Uplift::none:
      return {};
    case Uplift::triangular:
      return {{0, length, mouth, far}};
    case Uplift::full:
      return {{0, length, mouth, mouth}};
    case Uplift::drained: {
      const double share = s.law.drain_m / length;
      const double height = s.heel_m.y() + share * (s.toe_m.y() - s.heel_m.y());
      const double far_head = s.toe_m.y() + far / water_weight;
      const double mouth_head = s.heel_m.y() + mouth / water_weight;
      const double head = far_head + (1 - s.law.drain_efficiency) * (1 - share) * (mouth_head - far_head);
      const double drain = water_weight * std::max(0.0, head - height);
      return {{0, s.law.drain_m, mouth, drain}, {s.law.drain_m, length, drain, far}};
    }
    default: {
      const double linear = (mouth + far) / 2 * length;
      if (normal <= linear) return {{0, length, mouth, mouth}};
      const double open = length - closed_m(normal, about_toe, mouth, length);
      const double open_toe = length - closed_m(normal, normal * length - about_toe, far, length);
      if (open > 0) return {{0, open, mouth, mouth}, {open, length, mouth, far}};
      return {{0, length - open_toe, mouth, far}, {length - open_toe, length, far, far}};
    }
  }
}

Margins margins_of(const Stack& s, double level_m) {
  Resultant sum;
  const auto from_toe = [&](const Vec& p) { return Vec(p - s.toe_m); };
  sum.add(0, -s.weight_n_per_m, from_toe(s.centroid_m).x(), 0);
  const Vec face = s.face_top_m - s.heel_m;
  const Vec back = s.back_top_m - s.toe_m;
  const Vec heel = from_toe(s.heel_m);
  add_pool(level_m - s.heel_m.y(), face.y(), face.x() / face.y(), 1, heel.x(), heel.y(), sum);
  add_pool(s.tail_level_m - s.toe_m.y(), back.y(), -back.x() / back.y(), -1, 0, 0, sum);
  for (const Bolt& bolt : s.bolts) {
    const Vec pull = bolt.yield_n_per_m * (bolt.to_m - bolt.from_m).normalized();
    sum.add(pull.x(), pull.y(), from_toe(bolt.from_m).x(), from_toe(bolt.from_m).y());
  }
  const double length = heel.norm();
  const double dip = std::atan2(heel.y(), -heel.x());  // positive: down towards the toe
  double normal = -sum.up * std::cos(dip) - sum.right * std::sin(dip);
  const double shear = sum.right * std::cos(dip) - sum.up * std::sin(dip);
  // Clockwise turns over the toe; what presses the heel down turns counter-clockwise.
  double heel_reaction = sum.about_toe / length;
  for (const Stretch& stretch : uplift_of(s, level_m, length, normal, sum.about_toe)) {
    const double l = stretch.to_m - stretch.from_m;
    normal -= (stretch.from_pa + stretch.to_pa) / 2 * l;
    const double about_from = l * l / 6 * (stretch.from_pa + 2 * stretch.to_pa);
    heel_reaction -= ((length - stretch.from_m) * (stretch.from_pa + stretch.to_pa) / 2 * l - about_from) / length;
  }
  const double friction = std::tan(s.law.friction_deg * std::numbers::pi / 180);
  const double strength = normal * friction + s.law.cohesion_pa * length;
  return {strength - shear, heel_reaction + borne_tension_pa(s.law) * length / 2, strength / shear};
}

double root(const std::function<double(double)>& margin, double low, double high) {
  if (margin(low) <= 0) return low;
  if (margin(high) > 0) return high;
  for (int i = 0; i < 200 && high - low > 1e-14 * std::abs(high); ++i) {
    const double middle = (low + high) / 2;
    (margin(middle) > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

double level_of(double Margins::*margin, const Stack& stack, double high_m) {
  return root([&](double z) { return margins_of(stack, z).*margin; }, stack.heel_m.y(), high_m);
}

double level_once_broken(Stack stack, const std::string& mode, double high_m) {
  const bool slides = mode == "sliding";
  stack.law.cohesion_pa *= slides ? 0 : 0.5;
  stack.law.tension_pa = 0;
  return level_of(slides ? &Margins::overturning : &Margins::sliding, stack, high_m);
}

}  // namespace

Stack stack_of(const std::string& joint, const Vec& heel, const Vec& toe, const Vec& face_top, const Vec& back_top,
               const Law& law, double density_kg_per_m3, double tail_level_m) {
  // Two triangles on either side of the diagonal from the heel.
  const auto twice = [&](const Vec& p, const Vec& q) {
    return (p - heel).x() * (q - heel).y() - (p - heel).y() * (q - heel).x();
  };
  const double lower = twice(toe, back_top) / 2;
  const double upper = twice(back_top, face_top) / 2;
  Stack stack{joint, heel, toe, face_top, back_top};
  stack.weight_n_per_m = density_kg_per_m3 * gravity * (lower + upper);
  stack.centroid_m = (lower * (heel + toe + back_top) + upper * (heel + back_top + face_top)) / (3 * (lower + upper));
  stack.law = law;
  stack.tail_level_m = tail_level_m;
  return stack;
}

double sliding_factor(const Stack& stack, double level_m) {
  return margins_of(stack, level_m).sliding_factor;
}

double overturning_level(const Stack& stack, double high_m) {
  return level_of(&Margins::overturning, stack, high_m);
}

Failing first_failure(const std::vector<Stack>& stacks, double high_m) {
  std::vector<Failing> ways;
  for (const Stack& stack : stacks) {
    const auto add = [&](const char* mode, double Margins::*margin) {
      const double level = level_of(margin, stack, high_m);
      ways.push_back({level, mode, stack.joint, level - stack.heel_m.y(), high_m});
      ways.back().broken_level_m = level_once_broken(stack, mode, high_m);
    };
    add("sliding", &Margins::sliding);
    add("overturning", &Margins::overturning);
  }
  std::sort(ways.begin(), ways.end(), [](const auto& a, const auto& b) { return a.level_m < b.level_m; });
  ways.front().next_level_m = ways[1].level_m;
  return ways.front();
}

}  // namespace blockweir::independent
