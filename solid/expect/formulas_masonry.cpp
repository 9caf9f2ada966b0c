// SPDX-License-Identifier: GPL-3.0-or-later
// Limit analysis of masonry whose joints neither slip nor crush nor pull (Heyman 1966).
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "solid/expect/formula_tables.hpp"

namespace blockweir::solid::expect {
namespace {

/// Half of a symmetric ring of voussoirs, of unit weight. By symmetry the thrust H is horizontal at the crown; M is its
/// moment about the centre. The ring from the crown to a joint at the angle b weighs W and has the moment W x, so the
/// joint bears N = W sin b + H cos b across its radius, at the distance r from the centre: r N = M + W x.
class HalfArch {
 public:
  HalfArch(const scene::Arch& arch, double thickness_m)
      : inner_(arch.mean_radius_m - thickness_m / 2), outer_(arch.mean_radius_m + thickness_m / 2) {
    const double each = arch.embrace_deg * std::numbers::pi / 180 / arch.voussoirs;
    const double area = (outer_ * outer_ - inner_ * inner_) / 2 * std::sin(each);
    // Of a voussoir with straight faces, from the centre.
    const double centroid =
        std::cos(each / 2) * 2 / 3 * (std::pow(outer_, 3) - std::pow(inner_, 3)) / (outer_ * outer_ - inner_ * inner_);
    // The crown is a joint, or the middle of a voussoir.
    for (double angle = arch.voussoirs % 2 == 0 ? 0 : each / 2; joints_.size() <= arch.voussoirs / 2U; angle += each) {
      Joint joint{.angle = angle};
      if (joints_.empty() && angle > 0) {
        joint.weight = area / 2;
        joint.moment = half_voussoir_moment(each / 2);
      } else if (!joints_.empty()) {
        joint.weight = joints_.back().weight + area;
        joint.moment = joints_.back().moment + area * centroid * std::sin(angle - each / 2);
      }
      joints_.push_back(joint);
    }
  }

  /// Does a thrust line exist that is within the ring at all joints?
  [[nodiscard]] bool stands() const {
    double low = 0;
    double high = 1000 * joints_.back().weight;
    for (int i = 0; i < 100; ++i) {  // room is concave in H: its largest value
      const double third = (high - low) / 3;
      if (room(low + third) < room(high - third)) {
        low += third;
      } else {
        high -= third;
      }
    }
    return room((low + high) / 2) >= 0;
  }

 private:
  struct Joint {
    double angle = 0;   ///< from the crown [rad]
    double weight = 0;  ///< W
    double moment = 0;  ///< W x
  };

  /// About the crown's line: of the half of a voussoir that reaches from it to `angle`.
  [[nodiscard]] double half_voussoir_moment(double angle) const {
    const double slope = std::tan(angle);
    const double top = outer_ * std::cos(angle);
    const double bottom = inner_ * std::cos(angle);
    return slope * slope * (std::pow(top, 3) - std::pow(bottom, 3)) / 6;
  }

  /// Highest less lowest M for which inner <= r <= outer at all joints: r N is between inner N and outer N.
  [[nodiscard]] double room(double thrust) const {
    double lowest = -std::numeric_limits<double>::infinity();
    double highest = std::numeric_limits<double>::infinity();
    for (const Joint& joint : joints_) {
      const double normal = joint.weight * std::sin(joint.angle) + thrust * std::cos(joint.angle);
      lowest = std::max(lowest, inner_ * normal - joint.moment);
      highest = std::min(highest, outer_ * normal - joint.moment);
    }
    return highest - lowest;
  }

  double inner_;
  double outer_;
  std::vector<Joint> joints_;
};

/// The least thickness with which the arch stands under its own weight [m]. With joints at every angle a half circle
/// needs 0.1075 of its mean radius (Milankovitch 1907).
double arch_thickness(const Scene& s, const std::string& subject) {
  const auto arch = std::find_if(s.arches.begin(), s.arches.end(), [&](const auto& a) { return a.name == subject; });
  if (arch == s.arches.end()) throw std::runtime_error("[[expect]] of = \"" + subject + "\" names no arch");
  if (s.analysis.gravity_tilt_deg != 0)
    throw std::runtime_error("arch-thickness is for gravity that is not tilted; set gravity_tilt_deg = 0");
  double falls = 0;
  double stands = arch->mean_radius_m;
  for (int i = 0; i < 50; ++i) {
    const double middle = (falls + stands) / 2;
    (HalfArch(*arch, middle).stands() ? stands : falls) = middle;
  }
  return stands;
}

}  // namespace

const Formulas& masonry_formulas() {
  static const Formulas all = {{"arch-thickness", arch_thickness}};
  return all;
}

}  // namespace blockweir::solid::expect
