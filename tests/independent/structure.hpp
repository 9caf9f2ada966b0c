// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies, joints, bolts and still water as plain data, and the forces that follow from them. Written for the tests
// alone: nothing here is shared with the program that is tested.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace blockweir::independent {

using Vec = Eigen::Vector2d;
constexpr double none_m = -std::numeric_limits<double>::infinity();  ///< level where there is no water

enum class Uplift { none, triangular, full, drained, cracked };

struct Law {
  double friction_deg = 30;
  double cohesion_pa = 0;
  double tension_pa = 0;
  Uplift uplift = Uplift::none;
  double drain_m = 0;  ///< from the reservoir's end; drained only
  double drain_efficiency = 0;
};

/// What the law bears in tension [Pa]: Mohr-Coulomb's cone ends at c/tan(phi).
inline double borne_tension_pa(const Law& law) {
  return std::min(law.tension_pa, law.cohesion_pa / std::tan(law.friction_deg * std::numbers::pi / 180));
}

struct Body {
  std::string name;
  std::vector<Vec> outline_m;  ///< counter-clockwise
  bool fixed = false;
};

struct Joint {
  std::string name;
  std::string below;
  std::string above;
  Law law;
};

/// From a body to the ground; yields at a constant pull, and takes none in compression.
struct Bolt {
  std::string name;
  std::string body;
  Vec from_m;
  Vec to_m;
  double stiffness_n_per_m2 = 0;
  double prestress_n_per_m = 0;
  double yield_n_per_m = 0;
};

struct Structure {
  std::vector<Body> bodies;
  std::vector<Joint> joints;  ///< that differ from `others`
  std::vector<Bolt> bolts;
  Law others;
  double density_kg_per_m3 = 2400;
  double tail_level_m = none_m;
  bool reservoir_right = false;  ///< the reservoir stands on the right, the tailwater on the left
};

constexpr double gravity = 9.81;       // m/s2
constexpr double water_weight = 9810;  // N/m3

/// Where two bodies touch, straight. `from_m` is the end nearer to the reservoir.
struct Face {
  std::size_t a = 0;
  std::size_t b = 0;
  Vec from_m;
  Vec to_m;
  Vec normal;  ///< out of a
  Law law;

  [[nodiscard]] double length_m() const { return (to_m - from_m).norm(); }
  [[nodiscard]] Vec along() const { return (to_m - from_m).normalized(); }
};

/// Force x, force y, moment about the origin [N, N m, per metre of thickness].
using Wrench = Eigen::Vector3d;
Wrench wrench_of(const Vec& force, const Vec& at);

double area_of(const std::vector<Vec>& outline);
Vec centroid_of(const std::vector<Vec>& outline);
std::size_t body_of(const Structure& structure, const std::string& name);

std::vector<Face> faces_of(const Structure& structure);
std::vector<Wrench> weights_of(const Structure& structure);
/// Of the reservoir on the faces that look at it, and in joints with uplift.
std::vector<Wrench> reservoir_on(const Structure& structure, const std::vector<Face>& faces, double level_m);
/// Of the tailwater, likewise.
std::vector<Wrench> tailwater_on(const Structure& structure, const std::vector<Face>& faces);

Structure mirrored(Structure structure);
Structure scaled(Structure structure, double factor);  ///< lengths; stresses of joints and bolts go along
Structure shifted(Structure structure, const Vec& by);

}  // namespace blockweir::independent
