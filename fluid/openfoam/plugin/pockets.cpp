// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/pockets.hpp"

#include <PstreamReduceOps.H>
#include <regionSplit.H>

#include <algorithm>

namespace blockweir::openfoam {

void Pockets::find() {
  if (blocks_.fills() == fills_) return;
  fills_ = blocks_.fills();
  constexpr double open = 0.5;  // the least part of a cell that is blocked, as the added mass has it
  constexpr double few = 0.05;  // of the cells that are connected with most others
  const Foam::volScalarField& filled = blocks_.filled();
  Foam::boolList blocked(mesh_.nFaces(), false);
  for (Foam::label f = 0; f < mesh_.nInternalFaces(); ++f) {
    blocked[f] = filled[mesh_.owner()[f]] >= open || filled[mesh_.neighbour()[f]] >= open;
  }
  for (const Foam::fvPatchScalarField& patch : filled.boundaryField()) {
    if (!patch.coupled()) continue;
    const Foam::scalarField beyond(patch.patchNeighbourField());
    for (Foam::label i = 0; i < patch.size(); ++i) {
      blocked[patch.patch().start() + i] = filled[patch.patch().faceCells()[i]] >= open || beyond[i] >= open;
    }
  }
  const Foam::regionSplit regions(mesh_, blocked);
  Foam::labelList cells(regions.nRegions(), 0);
  for (Foam::label c = 0; c < mesh_.nCells(); ++c) ++cells[regions[c]];
  Foam::labelList ways_out(regions.nRegions(), 0);
  for (const Foam::fvPatchScalarField& p : mesh_.lookupObject<Foam::volScalarField>("p_rgh").boundaryField()) {
    if (!p.fixesValue()) continue;
    for (const Foam::label c : p.patch().faceCells()) ways_out[regions[c]] += filled[c] < open ? 1 : 0;
  }
  for (Foam::labelList* all : {&cells, &ways_out}) {
    Foam::Pstream::listCombineGather(*all, Foam::plusEqOp<Foam::label>());
    Foam::Pstream::listCombineScatter(*all);
  }
  const Foam::label largest = *std::max_element(cells.begin(), cells.end());
  enclosed_.assign(static_cast<std::size_t>(mesh_.nCells()), false);
  for (Foam::label c = 0; c < mesh_.nCells(); ++c) {
    const Foam::label region = regions[c];
    enclosed_[static_cast<std::size_t>(c)] =
        ways_out[region] == 0 && cells[region] < few * static_cast<double>(largest);
  }
}

}  // namespace blockweir::openfoam
