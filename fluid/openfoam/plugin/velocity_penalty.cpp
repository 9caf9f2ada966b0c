// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/velocity_penalty.hpp"

#include <addToRunTimeSelectionTable.H>
#include <fvMatrices.H>

namespace blockweir::openfoam {

defineTypeNameAndDebug(VelocityPenalty, 0);
using Foam::fv::option;
addToRunTimeSelectionTable(option, VelocityPenalty, dictionary);

VelocityPenalty::VelocityPenalty(const Foam::word& name, const Foam::word& type, const Foam::dictionary& dict,
                                 const Foam::fvMesh& mesh)
    : Foam::fv::option(name, type, dict, mesh), session_(new Session(mesh)) {
  fieldNames_ = Foam::wordList(1, Foam::word("U"));
  applied_.setSize(1, false);
}

void VelocityPenalty::addSup(const Foam::volScalarField& rho, Foam::fvMatrix<Foam::vector>& eqn, const Foam::label) {
  session_->begin_step();
  // Water seeps through blocks at eps dt grad(p)/rho; starting that flow changes the force on a dam by eps/100.
  constexpr double eps = 1e-6;
  const double rho_over_dt = session_->water_density() / mesh_.time().deltaTValue();
  const ImmersedBlocks& blocks = session_->blocks();
  const Foam::scalarField& filled = blocks.filled();
  const Foam::scalarField& volume = mesh_.V();
  const Foam::vectorField& centre = mesh_.C();
  Foam::scalarField& diagonal = eqn.diag();
  Foam::vectorField& source = eqn.source();
  for (std::size_t b = 0; b < blocks.outlines().size(); ++b) {
    const bool moves = blocks.moves(b);
    for (const ImmersedBlocks::Part& part : blocks.parts(b)) {
      const Foam::label c = part.cell;
      // C phi_b / phi
      const double penalty = rho_over_dt * part.fraction / (1 - filled[c] + eps) * volume[c];
      diagonal[c] -= penalty;
      if (!moves) continue;
      const Point u = blocks.velocity(b, {centre[c].x(), centre[c].y()});
      source[c] -= penalty * Foam::vector(u.x(), u.y(), 0);
    }
  }
  // The mesh moves with the ground: water feels -rho a.
  const Foam::vector ground = session_->ground_acceleration();
  if (Foam::magSqr(ground) > 0) source += volume * rho.primitiveField() * ground;
}

}  // namespace blockweir::openfoam
