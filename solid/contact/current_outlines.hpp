// SPDX-License-Identifier: GPL-3.0-or-later
// Where the outlines of the scene's blocks are as a search for contacts looks at them, and how finely it does.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "bridge/scene/at.hpp"
#include "solid/block/moving_parts.hpp"
#include "solid/contact/contact_point.hpp"
#include "solid/contact/outline.hpp"

namespace blockweir::solid {

/// The farthest that a block among others may turn in a step: which vertices may meet which edges holds about as long
/// [rad].
constexpr double most_turn_in_step = 0.05;
constexpr double closing = 2 * most_turn_in_step;  ///< rad by which a face may turn onto an edge in a step

class CurrentOutlines {
 public:
  struct Edge {
    Point along = Point::Zero();  ///< of unit length
    double length_m = 0;
  };

  CurrentOutlines(const MovingParts& parts, double size_m);

  /// Takes one block to where it is.
  void move(std::size_t block, const std::vector<Placement>& placements);

  [[nodiscard]] const MovingParts& parts() const { return parts_; }
  [[nodiscard]] const std::vector<std::vector<Point>>& all() const { return corners_; }
  [[nodiscard]] const std::vector<Point>& of(int block) const { return corners_[at(block)]; }
  /// Edges of one block, each from its corner to the next.
  [[nodiscard]] const std::vector<Edge>& edges(int block) const { return edges_[at(block)]; }
  [[nodiscard]] const Point& vertex_of(const ContactPoint& c) const {
    return corners_[at(c.vertex_block)][at(c.vertex)];
  }
  [[nodiscard]] std::pair<Point, Point> edge_of(const ContactPoint& c) const;
  /// Of a contact's edge, outward.
  [[nodiscard]] Point normal_of(const ContactPoint& c) const;

  /// Two contacts of one pair of blocks whose normals point the same way, or that are each other's twins across the
  /// joint.
  [[nodiscard]] bool of_one_joint(const ContactPoint& a, const ContactPoint& b) const;
  /// Sine of the angle between the edges of two such.
  [[nodiscard]] double turned(const ContactPoint& a, const ContactPoint& b) const;
  /// Gaps that rounded coordinates left at the start are none.
  void count_from_start(ContactPoint& c) const;

  /// Points so near are one [m].
  [[nodiscard]] double coincidence_m() const { return coincidence_; }
  /// By which corners may be past each other and still pass [m].
  [[nodiscard]] double give_m() const { return give_; }
  /// True where points so near [m] were not one before.
  [[nodiscard]] bool rounds_to(double rounding_m);
  void give_way_by(double give_m) { give_ = std::max(2 * coincidence_, give_m); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(coincidence_);
  }

 private:
  const MovingParts& parts_;
  std::vector<std::vector<Point>> corners_;
  std::vector<std::vector<Edge>> edges_;
  double coincidence_;  ///< m
  double give_;         ///< m
};

}  // namespace blockweir::solid
