// SPDX-License-Identifier: GPL-3.0-or-later
// fvOption "blockweirBlocks": forces the velocity in cells to that of the blocks that fill them.
#pragma once

#include <fvOption.H>

#include "fluid/openfoam/plugin/session.hpp"

namespace blockweir::openfoam {

/// Penalty in the momentum equation, C = (rho_water / dt) phi / (1 - phi + eps), where phi is the filled share of a
/// cell; it is divided among the blocks by their shares. The density is that of water everywhere: with the mixture's, a
/// dry cell would let through a thousand times as much.
class VelocityPenalty : public Foam::fv::option {
 public:
  TypeName("blockweirBlocks")

      /// Connects to the solid process here, because an error ends interFoam here but not in a function object.
      VelocityPenalty(const Foam::word& name, const Foam::word& type, const Foam::dictionary& dict,
                      const Foam::fvMesh& mesh);

  void addSup(const Foam::volScalarField& rho, Foam::fvMatrix<Foam::vector>& eqn, const Foam::label field) override;

  bool read(const Foam::dictionary& dict) override { return Foam::fv::option::read(dict); }

 private:
  Foam::autoPtr<Session> session_;
};

}  // namespace blockweir::openfoam
