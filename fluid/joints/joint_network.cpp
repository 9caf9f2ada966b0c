// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/joint_network.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "bridge/geometry/crossing.hpp"
#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/block_facts.hpp"
#include "bridge/scene/viscous_ground.hpp"
#include "fluid/joints/disjoint_sets.hpp"
#include "fluid/joints/open_space.hpp"

namespace blockweir::joints {
namespace {

constexpr double mouth_widths = 4;  // of a crack that carries open water: it ends so far from an acute corner

/// The angle about p that a block fills: all of its own at a corner, half a turn on an edge.
double filled_angle(const std::vector<Point>& outline, const Point& p, double near_m) {
  const std::size_t n = outline.size();
  for (std::size_t v = 0; v < n; ++v) {
    if ((outline[v] - p).norm() > near_m) continue;
    const Point next = outline[(v + 1) % n] - outline[v];
    const Point last = outline[(v + n - 1) % n] - outline[v];
    const double angle = std::atan2(geometry::cross(next, last), next.dot(last));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
  }
  for (std::size_t v = 0; v < n; ++v) {
    if (geometry::distance_to_segment(p, outline[v], outline[(v + 1) % n]) <= near_m) return std::numbers::pi;
  }
  return geometry::holds_point(outline, p, 0) ? 2 * std::numbers::pi : 0;
}

double linear(const std::array<double, 2>& ends, double share) {
  return ends[0] + share * (ends[1] - ends[0]);
}

}  // namespace

JointNetwork::JointNetwork(const scene::Scene& scene, const GroundCut& ground, double open_m)
    : scene_(scene), ground_(ground), search_(scene, open_m) {
  if (!scene.blocks.empty()) touching_m_ = 1e-6 * scene::bounds_of(scene).size();
}

void JointNetwork::follow(const std::vector<std::vector<Point>>& outlines, const Point& ground_m) {
  stretches_ = search_.find(outlines);
  // Two faces with a block between them are no joint.
  std::erase_if(stretches_, [&](const Stretch& s) {
    if (std::max(s.gap_m[0], s.gap_m[1]) <= touching_m_) return false;
    const auto& near = search_.neighbours()[at(s.sides[0].block)];
    return std::any_of(near.begin(), near.end(), [&](int b) {
      return b != s.sides[1].block && geometry::holds_point(outlines[at(b)], s.place(0.5), 0);
    });
  });
  join_ends();
  find_exposed(outlines, ground_m);
}

/// Ends no farther apart than the gaps that end there are one node.
void JointNetwork::join_ends() {
  struct StretchEnd {
    Point at;
    double near_m;
  };
  std::vector<StretchEnd> ends;
  double widest_m = 0;
  for (const Stretch& s : stretches_) {
    for (const std::size_t e : {0U, 1U}) {
      ends.push_back({e == 0 ? s.from : s.to, touching_m_ + 1.05 * std::max(0.0, s.gap_m[e])});
      widest_m = std::max(widest_m, ends.back().near_m);
    }
  }
  std::vector<std::size_t> by_x(ends.size());
  std::iota(by_x.begin(), by_x.end(), 0);
  std::sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) { return ends[a].at.x() < ends[b].at.x(); });
  DisjointSets groups(ends.size());
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    const StretchEnd& a = ends[by_x[i]];
    for (std::size_t k = i + 1; k < by_x.size(); ++k) {
      const StretchEnd& b = ends[by_x[k]];
      if (b.at.x() - a.at.x() > a.near_m + widest_m) break;
      if ((b.at - a.at).norm() <= a.near_m + b.near_m) groups.join(by_x[i], by_x[k]);
    }
  }
  std::vector<int> node(ends.size(), -1);
  std::vector<int> count;
  joined_.clear();
  ends_.assign(stretches_.size(), {});
  for (std::size_t i = 0; i < ends.size(); ++i) {
    int& n = node[groups.of(i)];
    if (n < 0) {
      n = static_cast<int>(joined_.size());
      joined_.push_back({Point::Zero()});
      count.push_back(0);
    }
    ends_[i / 2][i % 2] = n;
    Place& place = joined_[at(n)];
    const Stretch& s = stretches_[i / 2];
    place.at += (ends[i].at - place.at) / ++count[at(n)];
    place.gap_m = std::max(place.gap_m, s.gap_m[i % 2]);
    for (const Side& side : s.sides) {
      if (std::find(place.blocks.begin(), place.blocks.end(), side.block) == place.blocks.end()) {
        place.blocks.push_back(side.block);
      }
    }
  }
}

void JointNetwork::find_exposed(const std::vector<std::vector<Point>>& outlines, const Point& ground_m) {
  constexpr double open_angle = 0.35;  // 20 degrees: what a joint that opens leaves free is less
  std::vector<geometry::Bounds> boxes;
  for (const std::vector<Point>& outline : outlines) boxes.push_back(geometry::bounds_of(outline));
  std::optional<OpenSpace> space;
  for (Place& place : joined_) {
    std::vector<int> around = place.blocks;
    for (const int b : place.blocks) {
      for (const int other : search_.neighbours()[at(b)]) {
        if (std::find(around.begin(), around.end(), other) == around.end()) around.push_back(other);
      }
    }
    const double near_m = 2 * touching_m_ + 2 * std::max(0.0, place.gap_m);
    double filled = 0;
    std::vector<int> beside;
    for (const int b : around) {
      const geometry::Bounds& box = boxes[at(b)];
      if (((place.at - box.high).array() > near_m).any() || ((box.low - place.at).array() > near_m).any()) continue;
      const double angle = filled_angle(outlines[at(b)], place.at, near_m);
      if (angle > 0) beside.push_back(b);
      filled += angle;
    }
    place.blocks = std::move(beside);
    place.exposed = filled < 2 * std::numbers::pi - open_angle;
    place.on_cut = place.exposed && is_cut(place, ground_m);
    if (!place.exposed || place.on_cut) continue;
    if (!space) space.emplace(outlines, scene_.water.open_crack_width_m);
    place.exposed =
        space->reaches(place.at, mouth_widths * scene_.water.open_crack_width_m + std::max(0.0, place.gap_m));
  }
}

bool JointNetwork::is_cut(const Place& place, const Point& ground_m) const {
  const Point p = place.at - ground_m;
  const double near_m = 10 * touching_m_;
  const auto below = [&](const std::optional<Point>& bed) {
    return bed && std::abs(p.x() - bed->x()) <= near_m && p.y() < bed->y() - near_m;
  };
  if (below(ground_.left) || below(ground_.right)) return true;
  const auto held = [&](int b) {
    return scene_.blocks[at(b)].fixed ||
           std::any_of(scene_.supports.begin(), scene_.supports.end(),
                       [&](const scene::Support& s) { return s.block == b; }) ||
           scene::is_viscous_ground(scene_, b);
  };
  return p.y() <= ground_.bottom_m + near_m && std::any_of(place.blocks.begin(), place.blocks.end(), held);
}

int JointNetwork::drain_at(const Point& p) const {
  const auto& drains = scene_.joint_flow.drains;
  for (std::size_t d = 0; d < drains.size(); ++d) {
    if (geometry::distance_to_segment(p, drains[d].from_m, drains[d].to_m) <= touching_m_) return static_cast<int>(d);
  }
  return -1;
}

/// Without pressure.
double JointNetwork::closed_aperture(const Stretch& stretch, double share) const {
  double aperture = stretch.law->hydraulic_aperture_m;
  for (const scene::Grout& grout : scene_.joint_flow.grouts) {
    if (geometry::holds_point(grout.outline_m, stretch.place(share), 0)) aperture *= grout.aperture_factor;
  }
  return aperture;
}

/// Shares of a stretch at which its channels begin and end.
std::vector<double> JointNetwork::cuts(const Stretch& s, const OpenWater& open) const {
  constexpr double tiny = 1e-7;
  std::vector<double> shares;
  const auto add = [&](double share) {
    if (share > tiny && share < 1 - tiny) shares.push_back(share);
  };
  // Where the water falls through an uneven gap its pressure may fall below 0 between the ends: several panels see it.
  constexpr int of_uneven = 20;
  const double uneven_m = std::abs(s.gap_m[1] - s.gap_m[0]);
  const bool may_part = uneven_m > 0.05 * s.law->hydraulic_aperture_m && std::abs(s.to.y() - s.from.y()) > uneven_m;
  const int panels = std::max(scene_.joint_flow.panels_per_joint, may_part ? of_uneven : 1);
  for (int k = 1; k < panels; ++k) add(static_cast<double>(k) / panels);
  for (const scene::DrainLine& drain : scene_.joint_flow.drains) {
    if (const auto share = geometry::crossing({s.from, s.to}, {drain.from_m, drain.to_m})) add(*share);
  }
  for (const scene::Grout& grout : scene_.joint_flow.grouts) {
    for (std::size_t i = 0; i < grout.outline_m.size(); ++i) {
      const Point& next = grout.outline_m[(i + 1) % grout.outline_m.size()];
      if (const auto share = geometry::crossing({s.from, s.to}, {grout.outline_m[i], next})) add(*share);
    }
  }
  for (const Side& side : s.sides) {
    for (const OpenWater::Face& face : open.on(side.block, side.edge)) {
      for (const double end : {face.s_from, face.s_to}) add((end - side.s_from) / (side.s_to - side.s_from));
    }
  }
  std::sort(shares.begin(), shares.end());
  // Where the aperture reaches its bounds.
  const scene::JointLaw& law = *s.law;
  std::vector<double> from = {0};
  from.insert(from.end(), shares.begin(), shares.end());
  for (std::size_t i = 0; i < from.size() && !law.aperture_stiffness_pa_per_m; ++i) {
    const double to = i + 1 < from.size() ? from[i + 1] : 1;
    const double closed = closed_aperture(s, (from[i] + to) / 2);
    const double bounds[] = {law.least_aperture_m.value_or(closed / 100),
                             law.largest_aperture_m.value_or(scene_.water.open_crack_width_m)};
    for (const double bound : bounds) {
      const double share = (bound - closed - s.gap_m[0]) / (s.gap_m[1] - s.gap_m[0]);
      if (share > from[i] && share < to) add(share);
    }
  }
  shares.push_back(0);
  shares.push_back(1);
  std::sort(shares.begin(), shares.end());
  shares.erase(std::unique(shares.begin(), shares.end(), [](double a, double b) { return b - a < tiny; }),
               shares.end());
  shares.back() = 1;
  return shares;
}

void JointNetwork::add_channels(std::size_t stretch, const OpenWater& open) {
  const Stretch& s = stretches_[stretch];
  const scene::JointLaw& law = *s.law;
  const std::vector<double> shares = cuts(s, open);
  int last = ends_[stretch][0];
  for (std::size_t i = 1; i < shares.size(); ++i) {
    int next = ends_[stretch][1];
    if (i + 1 < shares.size()) {
      next = static_cast<int>(places_.size());
      Place& place = places_.emplace_back(Place{s.place(shares[i])});
      place.blocks = {s.sides[0].block, s.sides[1].block};
      place.gap_m = linear(s.gap_m, shares[i]);
    }
    const double middle = (shares[i - 1] + shares[i]) / 2;
    const auto in_open = [&](const Side& side) {
      return open.covers(side.block, side.edge, side.s_from + middle * (side.s_to - side.s_from));
    };
    Part part{stretch, shares[i - 1], shares[i], in_open(s.sides[0]) && in_open(s.sides[1])};
    const double closed = closed_aperture(s, middle);
    Channel channel{.from = last, .to = next, .length_m = (shares[i] - shares[i - 1]) * s.length_m()};
    if (law.aperture_stiffness_pa_per_m) channel.compliance_m_per_pa = 1 / *law.aperture_stiffness_pa_per_m;
    channel.least_m = law.least_aperture_m.value_or(closed / 100);
    channel.largest_m = law.largest_aperture_m.value_or(scene_.water.open_crack_width_m);
    for (const std::size_t e : {0U, 1U}) {
      channel.aperture_m[e] =
          closed + linear(s.gap_m, shares[i - 1 + e]) - channel.compliance_m_per_pa * law.aperture_pressure_pa;
    }
    if (part.open) {
      for (const int node : {last, next}) places_[at(node)].in_open = true;
    }
    network_.channels.push_back(channel);
    parts_.push_back(part);
    last = next;
  }
}

Node JointNetwork::node_at(Place& place, const OpenWater& open) const {
  Node node{.height_m = place.at.y()};
  place.drain = drain_at(place.at);
  if ((place.exposed || place.in_open) && !place.on_cut) {
    const double near_m = mouth_widths * scene_.water.open_crack_width_m + std::max(0.0, place.gap_m);
    if (const std::optional<double> pressure = open.pressure(place.at, place.blocks, near_m)) {
      node.kind = NodeKind::held;
      node.pressure_pa = *pressure;
    } else if (place.exposed) {
      node.kind = NodeKind::seeps;
    }
  }
  return node;
}

void JointNetwork::fill(const OpenWater& open) {
  places_ = joined_;
  parts_.clear();
  network_.channels.clear();
  network_.nodes.clear();
  for (std::size_t s = 0; s < stretches_.size(); ++s) add_channels(s, open);
  for (Place& place : places_) network_.nodes.push_back(node_at(place, open));
}

}  // namespace blockweir::joints
