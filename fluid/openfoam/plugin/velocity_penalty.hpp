// SPDX-License-Identifier: GPL-3.0-or-later
// fvOption "blockweirBlocks": holds the velocity in cells to that of the blocks that fill them.
#pragma once

#include <fvOption.H>

#include "fluid/openfoam/plugin/session.hpp"

namespace blockweir::openfoam {

/// Penalty on the momentum, C = (rho_water / dt) phi / (1 - phi + eps) with phi what all blocks fill of a cell
/// together, shared out as each of them fills it. The water's density everywhere: with the mixture's, a dry cell would
/// let through a thousand times as much.
class VelocityPenalty : public Foam::fv::option {
 public:
  TypeName("blockweirBlocks")

      /// Opens the line to the solid process: what goes wrong here ends interFoam, unlike in a function object.
      VelocityPenalty(const Foam::word& name, const Foam::word& type, const Foam::dictionary& dict,
                      const Foam::fvMesh& mesh);

  void addSup(const Foam::volScalarField& rho, Foam::fvMatrix<Foam::vector>& eqn, const Foam::label field) override;

  bool read(const Foam::dictionary& dict) override { return Foam::fv::option::read(dict); }

 private:
  Foam::autoPtr<Session> session_;
};

}  // namespace blockweir::openfoam
