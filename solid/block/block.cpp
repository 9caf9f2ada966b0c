// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/block.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "bridge/geometry/polygon_moments.hpp"

namespace blockweir::solid {
namespace {

/// Hooke's law between (ex, ey, gxy) and (sxx, syy, sxy).
Eigen::Matrix3d elastic_matrix(const scene::Material& material, scene::Plane plane) {
  const double nu = material.poissons_ratio;
  Eigen::Matrix3d D;
  if (plane == scene::Plane::strain) {
    D << 1 - nu, nu, 0, nu, 1 - nu, 0, 0, 0, 0.5 - nu;
    return material.youngs_modulus_pa / ((1 + nu) * (1 - 2 * nu)) * D;
  }
  D << 1, nu, 0, nu, 1, 0, 0, 0, (1 - nu) / 2;
  return material.youngs_modulus_pa / (1 - nu * nu) * D;
}

/// Rows of T at (X, Y): (1, 0, -Y, X, 0, Y/2) and (0, 1, X, 0, Y, X/2); centroid terms integrate to zero.
Inertia inertia_of(const geometry::PolygonMoments& m, double density) {
  const double difference = (m.xx - m.yy) / 2;
  const double half = m.xy / 2;
  Eigen::Matrix4d M;
  M << m.xx + m.yy, -m.xy, m.xy, difference,  //
      -m.xy, m.xx, 0, half,                   //
      m.xy, 0, m.yy, half,                    //
      difference, half, half, (m.xx + m.yy) / 4;
  return {density * m.area, density * M};
}

constexpr double sliding_damping_ratio = 0.5;

}  // namespace

Retardation retardation_of(const Block& block, const scene::Material& material) {
  const double sliding = material.damping_ratio.value_or(sliding_damping_ratio);
  const double at_rest = material.damping_ratio.value_or(0);
  if (sliding == 0) return {};
  const Eigen::Matrix3d M = block.inertia.matrix().bottomRightCorner<3, 3>();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> modes(block.stiffness, M, Eigen::EigenvaluesOnly);
  const double longest = 2 / std::sqrt(modes.eigenvalues().minCoeff());
  return {longest * at_rest, longest * sliding};
}

Block make_block(const scene::Block& described, const scene::Material& material, scene::Plane plane) {
  const geometry::PolygonMoments moments = geometry::polygon_moments(described.vertices);
  Block block;
  block.name = described.name;
  block.centroid = moments.centroid;
  block.area = moments.area;
  block.fixed = described.fixed;
  for (const Point& vertex : described.vertices) {
    block.vertices.push_back(vertex - moments.centroid);
    block.radius = std::max(block.radius, block.vertices.back().norm());
  }
  block.inertia = inertia_of(moments, material.density_kg_per_m3);
  block.elasticity = elastic_matrix(material, plane);
  block.stiffness = moments.area * block.elasticity;
  block.initial_stress = described.initial_stress_pa.value_or(material.initial_stress_pa);
  block.retardation = retardation_of(block, material);
  return block;
}

Eigen::Vector3d stress_in_block(const Block& block, const Vector6& displacement) {
  return block.initial_stress + block.elasticity * displacement.tail<3>();
}

}  // namespace blockweir::solid
