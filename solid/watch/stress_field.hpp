// SPDX-License-Identifier: GPL-3.0-or-later
// The stress of a block as a field: recovered from its mesh, or uniform without a mesh.
#pragma once

#include <array>
#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Strains of a mesh are smoothed over the domains of sides. A linear field is fitted to their stresses by least
/// squares over the patch of triangles around a point (after Zienkiewicz and Zhu 1992). It is of second order up to the
/// outline; single triangles are of first.
class StressField {
 public:
  StressField(const Solid& solid, std::size_t block);

  /// (xx, yy, xy) [Pa] in global axes, tension positive, at a point of the scene as drawn.
  [[nodiscard]] Eigen::Vector3d stress_at(const Point& point) const;
  /// At the nodes of the mesh, in their order.
  [[nodiscard]] std::vector<Eigen::Vector3d> at_nodes() const;

  /// Nodes as drawn [m] and at present; triangles by nodes. Empty without a mesh.
  [[nodiscard]] const std::vector<Point>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<Point>& places() const { return places_; }
  [[nodiscard]] const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }

 private:
  /// Stress of the domain of a side, which belongs to one or two triangles.
  struct Sample {
    std::array<int, 2> triangles;
    Point place;
    Eigen::Vector3d stress;
    double area = 0;
  };
  void number_nodes();
  void sample_sides();
  [[nodiscard]] Eigen::Vector3d fit(const std::vector<int>& seeds, const Point& point) const;

  const Solid& solid_;
  std::size_t block_;
  int first_ = 0;  ///< part index of triangle 0
  std::vector<Point> nodes_;
  std::vector<Point> places_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<std::vector<int>> around_;  ///< triangles at each node
  std::vector<Sample> samples_;
  std::vector<std::vector<int>> samples_of_;  ///< of each triangle
};

}  // namespace blockweir::solid
