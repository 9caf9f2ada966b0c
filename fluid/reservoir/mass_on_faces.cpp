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
    const WaterMesh mesh = mesh_of(scene, body, {still.outlines()});
    if (mesh.triangle.empty()) continue;
    const PressureEquation equation(mesh, {.density_kg_per_m3 = scene.water.density_kg_per_m3}, ground, 1);
    const FaceFlux flux = flux_on_faces(mesh, moves);
    const Eigen::MatrixXd own = equation.added_mass(flux.g);
    for (Eigen::Index k = 0; k < own.cols(); ++k) {
      for (Eigen::Index i = 0; i < own.rows(); ++i) {
        entries.emplace_back(flux.unknown[static_cast<std::size_t>(i)], flux.unknown[static_cast<std::size_t>(k)],
                             own(i, k));
      }
    }
  }
  Eigen::SparseMatrix<double> mass(unknowns, unknowns);
  mass.setFromTriplets(entries.begin(), entries.end());
  return mass;
}

}  // namespace blockweir::reservoir
