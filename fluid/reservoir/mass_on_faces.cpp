// SPDX-License-Identifier: GPL-3.0-or-later
// The mass of water that a structure pushes, whatever the motions of its faces.
#include "fluid/hydrostatic/hydrostatic_model.hpp"
#include "fluid/reservoir/face_flux.hpp"
#include "fluid/reservoir/pressure_equation.hpp"
#include "fluid/reservoir/scene_water.hpp"

namespace blockweir::reservoir {
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
    const auto flux = flux_on_faces(mesh, moves);
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
