// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/independent/structure.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace blockweir::independent {
namespace {

double cross(const Vec& a, const Vec& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double size_of(const Structure& structure) {
  double size = 0;
  for (const Body& body : structure.bodies) {
    if (body.fixed) continue;
    for (const Vec& p : body.outline_m) size = std::max(size, (p - body.outline_m.front()).norm());
  }
  return size;
}

Law law_between(const Structure& structure, std::size_t a, std::size_t b) {
  const std::string& one = structure.bodies[a].name;
  const std::string& other = structure.bodies[b].name;
  for (const Joint& joint : structure.joints) {
    if ((joint.below == one && joint.above == other) || (joint.below == other && joint.above == one)) return joint.law;
  }
  return structure.others;
}

/// Fractions of the side from p to q that a side from r to s, the other way about, covers; empty where first >= second.
std::pair<double, double> covered(const Vec& p, const Vec& q, const Vec& r, const Vec& s, double near_m) {
  const Vec along = (q - p).normalized();
  const double length = (q - p).norm();
  if ((s - r).normalized().dot(along) > -1 + 1e-9) return {0, 0};
  if (std::abs(cross(along, r - p)) > near_m || std::abs(cross(along, s - p)) > near_m) return {0, 0};
  const double from = std::max(0.0, along.dot(s - p) / length);
  const double to = std::min(1.0, along.dot(r - p) / length);
  return (to - from) * length > near_m ? std::pair(from, to) : std::pair(0.0, 0.0);
}

template <class Each>  // (index, from, to) of the sides of an outline
void each_side(const std::vector<Vec>& outline, Each each) {
  for (std::size_t i = 0; i < outline.size(); ++i) each(outline[i], outline[(i + 1) % outline.size()]);
}

/// A pressure that is linear from p to q, on the body that lies left of this way.
Wrench pressure_on(const Vec& p, const Vec& q, double at_p, double at_q) {
  const Vec inward(-(q - p).y(), (q - p).x());  // as long as the side
  const double mean = (at_p + at_q) / 2;
  if (mean == 0) return Wrench::Zero();
  const double share = (at_p + 2 * at_q) / (6 * mean);  // of the way to q where the resultant acts
  return wrench_of(mean * inward, p + share * (q - p));
}

/// Still water against the part of a side below its level.
Wrench water_on(Vec p, Vec q, double level_m) {
  if (std::max(p.y(), q.y()) > level_m) {
    if (std::min(p.y(), q.y()) >= level_m) return Wrench::Zero();
    const Vec surface = p + (level_m - p.y()) / (q.y() - p.y()) * (q - p);
    (p.y() > level_m ? p : q) = surface;
  }
  return pressure_on(p, q, water_weight * (level_m - p.y()), water_weight * (level_m - q.y()));
}

/// Parts of the sides of body b that no other body touches.
std::vector<std::pair<Vec, Vec>> bare_sides(const Structure& structure, std::size_t b, double near_m) {
  std::vector<std::pair<Vec, Vec>> bare;
  each_side(structure.bodies[b].outline_m, [&](const Vec& p, const Vec& q) {
    std::vector<std::pair<double, double>> parts;
    for (std::size_t other = 0; other < structure.bodies.size(); ++other) {
      if (other == b) continue;
      each_side(structure.bodies[other].outline_m, [&](const Vec& r, const Vec& s) {
        const auto part = covered(p, q, r, s, near_m);
        if (part.first < part.second) parts.push_back(part);
      });
    }
    std::sort(parts.begin(), parts.end());
    parts.emplace_back(1, 1);
    double from = 0;
    for (const auto& [begin, end] : parts) {
      if ((begin - from) * (q - p).norm() > near_m) bare.emplace_back(p + from * (q - p), p + begin * (q - p));
      from = std::max(from, end);
    }
  });
  return bare;
}

/// Of one pool on the sides that look at it; `looks` is -1 for those that look left.
std::vector<Wrench> pool_on(const Structure& structure, double level_m, double looks) {
  const double near_m = 1e-7 * size_of(structure);
  std::vector<Wrench> sum(structure.bodies.size(), Wrench::Zero());
  for (std::size_t b = 0; b < sum.size(); ++b) {
    if (structure.bodies[b].fixed) continue;
    for (const auto& [p, q] : bare_sides(structure, b, near_m)) {
      const double outward_x = (q - p).normalized().y();
      if (outward_x * looks > 1e-6) sum[b] += water_on(p, q, level_m);
    }
  }
  return sum;
}

/// Water in the joints: pressures at the reservoir's end of each and at the other.
template <class Pressures>
void add_uplift(const std::vector<Face>& faces, Pressures pressures, std::vector<Wrench>& sum) {
  for (const Face& face : faces) {
    if (face.law.uplift == Uplift::none) continue;
    const auto [mouth, end] = pressures(face);
    // `a` lies left of the way from p to q.
    const bool forth = Vec(face.along().y(), -face.along().x()).dot(face.normal) > 0;
    const Wrench on_a =
        forth ? pressure_on(face.from_m, face.to_m, mouth, end) : pressure_on(face.to_m, face.from_m, end, mouth);
    sum[face.a] += on_a;
    sum[face.b] -= on_a;
  }
}

double pressure_at(const Vec& point, double level_m) {
  return water_weight * std::max(0.0, level_m - point.y());
}

template <class Move>
Structure moved(Structure structure, Move move) {
  for (Body& body : structure.bodies) std::for_each(body.outline_m.begin(), body.outline_m.end(), move);
  for (Bolt& bolt : structure.bolts) move(bolt.from_m), move(bolt.to_m);
  return structure;
}

}  // namespace

Wrench wrench_of(const Vec& force, const Vec& at) {
  return {force.x(), force.y(), cross(at, force)};
}

double area_of(const std::vector<Vec>& outline) {
  double twice = 0;
  each_side(outline, [&](const Vec& p, const Vec& q) { twice += cross(p - outline[0], q - outline[0]); });
  return twice / 2;
}

Vec centroid_of(const std::vector<Vec>& outline) {
  Vec sum = Vec::Zero();
  each_side(outline, [&](const Vec& p, const Vec& q) {
    sum += cross(p - outline[0], q - outline[0]) * (p + q - 2 * outline[0]);
  });
  return outline[0] + sum / (6 * area_of(outline));
}

std::size_t body_of(const Structure& structure, const std::string& name) {
  for (std::size_t b = 0; b < structure.bodies.size(); ++b) {
    if (structure.bodies[b].name == name) return b;
  }
  throw std::invalid_argument("no body " + name);
}

std::vector<Face> faces_of(const Structure& structure) {
  std::vector<Face> faces;
  const double near_m = 1e-7 * size_of(structure);
  for (std::size_t a = 0; a < structure.bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < structure.bodies.size(); ++b) {
      if (structure.bodies[a].fixed && structure.bodies[b].fixed) continue;
      each_side(structure.bodies[a].outline_m, [&](const Vec& p, const Vec& q) {
        each_side(structure.bodies[b].outline_m, [&](const Vec& r, const Vec& s) {
          const auto [from, to] = covered(p, q, r, s, near_m);
          if (from >= to) return;
          Face face{.a = a, .b = b, .from_m = p + from * (q - p), .to_m = p + to * (q - p)};
          face.normal = Vec((q - p).y(), -(q - p).x()).normalized();
          face.law = law_between(structure, a, b);
          if ((face.from_m.x() > face.to_m.x()) != structure.reservoir_right) std::swap(face.from_m, face.to_m);
          faces.push_back(face);
        });
      });
    }
  }
  return faces;
}

std::vector<Wrench> weights_of(const Structure& structure) {
  std::vector<Wrench> weights;
  for (const Body& body : structure.bodies) {
    const double weight = structure.density_kg_per_m3 * gravity * area_of(body.outline_m);
    weights.push_back(wrench_of(Vec(0, -weight), centroid_of(body.outline_m)));
  }
  return weights;
}

std::vector<Wrench> reservoir_on(const Structure& structure, const std::vector<Face>& faces, double level_m) {
  std::vector<Wrench> sum = pool_on(structure, level_m, structure.reservoir_right ? 1 : -1);
  const auto pressures = [&](const Face& face) {
    const double mouth = pressure_at(face.from_m, level_m);
    return std::pair(mouth, face.law.uplift == Uplift::full ? mouth : 0.0);
  };
  add_uplift(faces, pressures, sum);
  return sum;
}

std::vector<Wrench> tailwater_on(const Structure& structure, const std::vector<Face>& faces) {
  std::vector<Wrench> sum = pool_on(structure, structure.tail_level_m, structure.reservoir_right ? -1 : 1);
  const auto pressures = [&](const Face& face) {
    return std::pair(0.0, face.law.uplift == Uplift::full ? 0.0 : pressure_at(face.to_m, structure.tail_level_m));
  };
  add_uplift(faces, pressures, sum);
  return sum;
}

Structure mirrored(Structure structure) {
  structure = moved(std::move(structure), [](Vec& p) { p.x() = -p.x(); });
  for (Body& body : structure.bodies) std::reverse(body.outline_m.begin(), body.outline_m.end());
  structure.reservoir_right = !structure.reservoir_right;
  return structure;
}

Structure scaled(Structure structure, double factor) {
  structure = moved(std::move(structure), [&](Vec& p) { p *= factor; });
  const auto scale = [&](Law& law) { law.cohesion_pa *= factor, law.tension_pa *= factor; };
  scale(structure.others);
  for (Joint& joint : structure.joints) scale(joint.law);
  for (Bolt& bolt : structure.bolts) {
    bolt.stiffness_n_per_m2 *= factor;
    bolt.prestress_n_per_m *= factor * factor;
    bolt.yield_n_per_m *= factor * factor;
  }
  structure.tail_level_m *= factor;
  return structure;
}

Structure shifted(Structure structure, const Vec& by) {
  structure = moved(std::move(structure), [&](Vec& p) { p += by; });
  structure.tail_level_m += by.y();
  return structure;
}

}  // namespace blockweir::independent
