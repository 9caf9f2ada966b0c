// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the nodes of a mesh with the boundary of its water, its triangles kept:
//
//     div (grad u / A) = 0,    u given at the boundary, A the area of a triangle
//
// by linear elements on the mesh as it was made, so that small triangles hardly change their shape. u is the
// displacement since then: where nodes are depends on where the boundary is, and on nothing between.
#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <optional>

#include "fluid/reservoir/water_mesh.hpp"

namespace blockweir::reservoir {

class MeshMotion {
 public:
  /// `mesh` as mesh_water made it of the same body and banks.
  MeshMotion(const WaterMesh& mesh, const hydrostatic::WaterBody& body, const Banks& banks);
  ~MeshMotion();
  MeshMotion(MeshMotion&& other) noexcept;
  MeshMotion& operator=(MeshMotion&& other) noexcept;

  /// The mesh where body and banks are now. None where other faces are wet, where the boundary is not that of the mesh
  /// moved, or where a triangle would be stretched or compressed too much.
  [[nodiscard]] std::optional<WaterMesh> moved(const hydrostatic::WaterBody& body, const Banks& banks,
                                               const FarEnds& ends);

 private:
  using Points = std::vector<Point>;
  /// A node of the boundary between two points of the rings.
  struct OnBoundary {
    int node;
    std::size_t from;
    std::size_t to;
    double way;
  };

  bool prepare();
  bool trace_boundary();
  void factorize();
  [[nodiscard]] std::optional<Points> points_now(const hydrostatic::WaterBody& body, const Banks& banks,
                                                 const FarEnds& ends) const;
  void move_inside(std::vector<Point>& node) const;
  [[nodiscard]] bool is_well_shaped(const std::vector<Point>& node) const;

  WaterMesh mesh_;
  std::vector<std::array<int, 2>> faces_;  ///< block and edge of each wet face
  Points known_;                           ///< ends of the wet faces, then mesh corners on faces
  double same_place_m_;
  bool prepared_ = false;
  bool can_move_ = false;
  Points ring_;                                     ///< points of all rings
  std::vector<std::optional<std::size_t>> anchor_;  ///< of each of ring_: the known point that it is at
  std::vector<std::size_t> nearest_known_;          ///< of each of ring_
  std::vector<std::optional<std::size_t>> place_;   ///< of each known point: that of ring_ where it is
  std::vector<OnBoundary> boundary_;
  std::vector<int> inner_;  ///< corners of triangles that are not on the boundary
  Eigen::SparseMatrix<double> to_boundary_;
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace blockweir::reservoir
