// SPDX-License-Identifier: GPL-3.0-or-later
// The mass of water that a structure pushes, whatever the motions of its faces.
#include <map>

#include "bridge/process/face_motion.hpp"
#include "bridge/scene/at.hpp"
#include "fluid/hydrostatic/hydrostatic_model.hpp"
#include "fluid/reservoir/pressure_equation.hpp"
#include "fluid/reservoir/scene_water.hpp"

namespace blockweir::reservoir {
namespace {

/// g of a unit acceleration of each unknown that moves a wet face, at the nodes.
std::map<int, Eigen::VectorXd> fluxes(const WaterMesh& mesh, const process::FaceMotion& moves) {
  std::map<int, Eigen::VectorXd> flux;
  const Eigen::Matrix3d mass = side_mass();
  for (const BoundarySide& side : mesh.side) {
    if (side.kind != BoundarySide::Kind::face) continue;
    const Point span = mesh.node[at(side.node[2])] - mesh.node[at(side.node[0])];
    const Point normal(span.y(), -span.x());  // out of the water, of the side's length
    const std::array<double, 3> s{side.s_from, (side.s_from + side.s_to) / 2, side.s_to};
    for (std::size_t i = 0; i < 3; ++i) {
      const process::PointMotion point = moves({side.block, side.edge, s[i]});
      for (std::size_t k = 0; k < point.unknown.size(); ++k) {
        const double along = normal.dot(point.by_unknown.col(static_cast<Eigen::Index>(k)));
        auto& g = flux.try_emplace(point.unknown[k], Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.node.size())))
                      .first->second;
        for (std::size_t row = 0; row < 3; ++row) {
          g[side.node[row]] += along * mass(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i));
        }
      }
    }
  }
  return flux;
}

}  // namespace

Eigen::SparseMatrix<double> mass_on_faces(const scene::Scene& scene, const wire::Motion& motion, int unknowns,
                                          const process::FaceMotion& moves) {
  hydrostatic::HydrostaticModel still(scene);
  wire::Load load;
  still.advance(motion, scene.analysis.duration_s, load);
  const std::vector<bool> ground(scene.blocks.size(), false);  // it does not absorb: the water is incompressible
  std::vector<Eigen::Triplet<double>> entries;
  for (const hydrostatic::WaterBody& body : still.bodies()) {
    const WaterMesh mesh = mesh_of(scene, body, still.outlines());
    if (mesh.triangle.empty()) continue;
    const PressureEquation equation(mesh, {.density_kg_per_m3 = scene.water.density_kg_per_m3}, ground, 1);
    const auto flux = fluxes(mesh, moves);
    for (const auto& [column, g] : flux) {
      const Eigen::VectorXd p = equation.pressure(g);
      for (const auto& [row, of_row] : flux) {
        const double half = -of_row.dot(p) / 2;
        entries.emplace_back(row, column, half);
        entries.emplace_back(column, row, half);
      }
    }
  }
  Eigen::SparseMatrix<double> mass(unknowns, unknowns);
  mass.setFromTriplets(entries.begin(), entries.end());
  return mass;
}

}  // namespace blockweir::reservoir
