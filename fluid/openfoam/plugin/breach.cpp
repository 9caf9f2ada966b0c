// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/breach.hpp"

#include <linear.H>
#include <regionSplit.H>
#include <surfaceFields.H>

#include <algorithm>
#include <limits>

namespace blockweir::openfoam {

Breach::Breach(const Foam::fvMesh& mesh, const Foam::dictionary& dict, const ImmersedBlocks& blocks)
    : mesh_(mesh),
      blocks_(blocks),
      upstream_to_(dict.get<Foam::scalar>("upstreamTo")),
      downstream_from_(dict.get<Foam::scalar>("downstreamFrom")) {}

bool Breach::look() {
  if (!looked_) {
    looked_ = true;
    open_from_start_ = is_open();
  } else if (!found_ && !open_from_start_ && moved()) {
    found_ = is_open();
  }
  return found_;
}

bool Breach::moved() const {
  for (std::size_t b = 0; b < blocks_.outlines().size(); ++b) {
    const Polygon& start = blocks_.interface().blocks[b].outline;
    for (std::size_t v = 0; v < start.size(); ++v) {
      if ((blocks_.outlines()[b][v] - start[v]).norm() > blocks_.cell_m()) return true;
    }
  }
  return false;
}

bool Breach::is_open() const {
  using namespace Foam;
  double crest = -std::numeric_limits<double>::infinity();
  for (const auto& block : blocks_.interface().blocks) {
    if (!block.loaded) continue;
    for (const Point& p : block.outline) crest = std::max(crest, p.y());
  }
  const auto& water = mesh_.lookupObject<volScalarField>("alpha.water");
  volScalarField wet("wet", pos(water - 0.5) * pos(0.5 - blocks_.filled()));
  forAll(wet, c) {
    if (mesh_.C()[c].y() > crest) wet[c] = 0;
  }
  wet.correctBoundaryConditions();
  const surfaceScalarField both("both", linearInterpolate(wet));  // 1 only between two wet cells, of two ranks as well
  boolList closed(mesh_.nFaces(), false);
  const auto close = [&](const scalarField& values, label first) {
    forAll(values, f) closed[first + f] = values[f] < 0.99;
  };
  close(both.primitiveField(), 0);
  forAll(mesh_.boundary(), i) {
    if (mesh_.boundary()[i].coupled()) close(both.boundaryField()[i], mesh_.boundary()[i].start());
  }
  const regionSplit regions(mesh_, closed);
  const label n = std::max(0, regions.nRegions());  // the compiler fears for less
  boolList upstream(n, false);
  boolList downstream(n, false);
  forAll(wet, c) {
    if (wet[c] < 0.5) continue;
    if (mesh_.C()[c].x() < upstream_to_) upstream[regions[c]] = true;
    if (mesh_.C()[c].x() > downstream_from_) downstream[regions[c]] = true;
  }
  for (boolList* side : {&upstream, &downstream}) {
    Pstream::listCombineGather(*side, orEqOp<bool>());
    Pstream::listCombineScatter(*side);
  }
  forAll(upstream, r) {
    if (upstream[r] && downstream[r]) return true;
  }
  return false;
}

}  // namespace blockweir::openfoam
