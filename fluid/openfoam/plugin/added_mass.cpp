// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/added_mass.hpp"

#include <fixedValueFvPatchFields.H>
#include <fvc.H>
#include <fvm.H>
#include <surfaceFields.H>
#include <zeroGradientFvPatchFields.H>

namespace blockweir::openfoam {
namespace {

constexpr double moved_cells = 0.5;
constexpr long at_least_every = 100;
constexpr double eps = 1e-4;  // water that seeps through blocks: the equation holds in them, too

Foam::IOobject unregistered(const char* name, const Foam::fvMesh& mesh) {
  return Foam::IOobject(name, mesh.time().timeName(), mesh, Foam::IOobject::NO_READ, Foam::IOobject::NO_WRITE, false);
}

}  // namespace

bool AddedMass::stale() const {
  if (rows_.empty() || asked_ % at_least_every == 0) return true;
  const double far = moved_cells * blocks_.interface().cell_m;
  for (std::size_t b = 0; b < measured_at_.size(); ++b) {
    for (std::size_t v = 0; v < measured_at_[b].size(); ++v) {
      if ((blocks_.outlines()[b][v] - measured_at_[b][v]).norm() > far) return true;
    }
  }
  return false;
}

void AddedMass::measure(std::vector<std::array<double, 6>>& rows) {
  if (stale()) {
    rows_.assign(blocks_.outlines().size(), {});
    for (std::size_t b = 0; b < rows_.size(); ++b) {
      if (blocks_.interface().blocks[b].movable) rows_[b] = of_block(b);
    }
    measured_at_ = blocks_.outlines();
  }
  ++asked_;
  rows = rows_;
}

std::array<double, 6> AddedMass::of_block(std::size_t b) {
  using namespace Foam;
  const volScalarField& pressure = mesh_.lookupObject<volScalarField>("p_rgh");
  const volScalarField& rho = mesh_.lookupObject<volScalarField>("rho");
  wordList types(mesh_.boundary().size(), zeroGradientFvPatchScalarField::typeName);
  forAll(types, i) {
    if (pressure.boundaryField()[i].fixesValue()) types[i] = fixedValueFvPatchScalarField::typeName;
    if (mesh_.boundary()[i].type() == "empty") types[i] = "empty";
    if (mesh_.boundary()[i].coupled()) types[i] = mesh_.boundary()[i].type();
  }
  volScalarField p(unregistered("addedMassPressure", mesh_), mesh_, dimensionedScalar("p", dimPressure, 0.0), types);
  const surfaceScalarField open("open", fvc::interpolate((1 + eps - blocks_.filled()) / rho));

  const Pose& pose = blocks_.poses()[b];
  const Point centroid = blocks_.interface().blocks[b].centroid + Point(pose[0], pose[1]);
  PtrList<scalarField> sources(3);
  std::array<scalarField, 3> answers;
  for (int k = 0; k < 3; ++k) {
    volVectorField a(unregistered("blockAcceleration", mesh_), mesh_,
                     dimensionedVector("a", dimAcceleration, vector::zero));
    for (const ImmersedBlocks::Part& part : blocks_.parts(b)) {
      const vector& x = mesh_.C()[part.cell];
      const vector unit = k == 0   ? vector(1, 0, 0)
                          : k == 1 ? vector(0, 1, 0)
                                   : vector(-(x.y() - centroid.y()), x.x() - centroid.x(), 0);
      a[part.cell] = part.fraction * unit;
    }
    a.correctBoundaryConditions();
    const volScalarField divergence(fvc::div(fvc::flux(a)));
    sources.set(k, new scalarField(divergence.primitiveField() * mesh_.V().field()));
    p.primitiveFieldRef() = 0;
    p.correctBoundaryConditions();
    fvScalarMatrix equation(fvm::laplacian(open, p) == divergence);
    const int talk = SolverPerformance<scalar>::debug;
    SolverPerformance<scalar>::debug = 0;
    equation.solve(mesh_.solverDict("addedMass"));
    SolverPerformance<scalar>::debug = talk;
    ++solutions_;
    answers[static_cast<std::size_t>(k)] = p.primitiveField();
  }
  const auto entry = [&](int j, int k) {
    const auto& p_j = answers[static_cast<std::size_t>(j)];
    const auto& p_k = answers[static_cast<std::size_t>(k)];
    // Symmetric but for what the solver leaves.
    return -0.5 * (gSum(scalarField(p_k * sources[j])) + gSum(scalarField(p_j * sources[k])));
  };
  return {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
}

}  // namespace blockweir::openfoam
