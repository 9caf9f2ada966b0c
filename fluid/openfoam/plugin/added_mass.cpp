// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/added_mass.hpp"

#include <fixedValueFvPatchFields.H>
#include <fvc.H>
#include <fvm.H>
#include <laplacianScheme.H>
#include <linear.H>
#include <surfaceFields.H>
#include <zeroGradientFvPatchFields.H>

#include "fluid/openfoam/positive_mass.hpp"

namespace blockweir::openfoam {
namespace {

constexpr double moved_cells = 0.5;
constexpr long at_least_every = 100;
constexpr double eps = 1e-6;  // of the flow through blocks, and out of pockets: the equation has one solution

Foam::IOobject unregistered(const char* name, const Foam::fvMesh& mesh) {
  return Foam::IOobject(name, mesh.time().timeName(), mesh, Foam::IOobject::NO_READ, Foam::IOobject::NO_WRITE, false);
}

}  // namespace

bool AddedMass::stale() const {
  if (rows_.empty() || asked_ % at_least_every == 0) return true;
  const double far = moved_cells * blocks_.cell_m();
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

Foam::wordList AddedMass::pressure_patches() const {
  using namespace Foam;
  const auto& pressure = mesh_.lookupObject<volScalarField>("p_rgh");
  wordList types(mesh_.boundary().size(), zeroGradientFvPatchScalarField::typeName);
  forAll(types, i) {
    const fvPatch& patch = mesh_.boundary()[i];
    if (pressure.boundaryField()[i].fixesValue()) types[i] = fixedValueFvPatchScalarField::typeName;
    if (patch.coupled() || patch.type() == "empty") types[i] = patch.type();
  }
  return types;
}

/// s_k V [m2 for translation, m3 for rotation, per metre of thickness].
std::array<Foam::scalarField, 3> AddedMass::sources(std::size_t b) const {
  std::array<Foam::scalarField, 3> source;
  source.fill(Foam::scalarField(mesh_.nCells(), 0.0));
  const Pose& pose = blocks_.poses()[b];
  const Point centroid = blocks_.interface().blocks[b].centroid + Point(pose[0], pose[1]);
  for (const EdgePressures::Wetted& w : edges_.wetted()) {
    if (w.block != static_cast<int>(b)) continue;
    const int cell = blocks_.locator().find(w.looked_at);
    if (cell < 0) continue;
    const Point arm = w.middle - centroid;
    source[0][cell] += w.push.x();
    source[1][cell] += w.push.y();
    source[2][cell] += arm.x() * w.push.y() - arm.y() * w.push.x();
  }
  return source;
}

/// From the centroid to the farthest corner [m].
double AddedMass::reach(std::size_t b) const {
  const Pose& pose = blocks_.poses()[b];
  const Point centroid = blocks_.interface().blocks[b].centroid + Point(pose[0], pose[1]);
  double farthest = 0;
  for (const Point& corner : blocks_.outlines()[b]) farthest = std::max(farthest, (corner - centroid).norm());
  return farthest;
}

std::array<double, 6> AddedMass::of_block(std::size_t b) {
  using namespace Foam;
  const std::array<scalarField, 3> source = sources(b);
  scalar pushed = 0;
  for (const scalarField& s : source) pushed += sumMag(s);
  reduce(pushed, sumOp<scalar>());
  if (pushed == 0) return {};

  const auto& rho = mesh_.lookupObject<volScalarField>("rho");
  const volScalarField open("open", neg(blocks_.filled() - 0.5));
  const surfaceScalarField way("way", max(eps, pos(linearInterpolate(open) - 0.99)) * linearInterpolate(1 / rho));
  const double h = blocks_.cell_m();
  const dimensionedScalar leak("leak", dimless / dimDensity / dimArea, eps / (max(rho).value() * h * h));
  volScalarField p(unregistered("addedMassPressure", mesh_), mesh_, dimensionedScalar("p", dimPressure, 0.0),
                   pressure_patches());
  std::array<scalarField, 3> answer;
  const int talk = SolverPerformance<scalar>::debug;
  SolverPerformance<scalar>::debug = 0;
  // A case of the user's own need not name one for it.
  auto scheme = fv::laplacianScheme<scalar, scalar>::New(mesh_, IStringStream("Gauss linear uncorrected")());
  dictionary controls(mesh_.solverDict("p_rgh"));
  controls.set("relTol", 1e-3);
  for (std::size_t k = 0; k < 3; ++k) {
    p.primitiveFieldRef() = 0;
    p.correctBoundaryConditions();
    fvScalarMatrix equation(scheme.ref().fvmLaplacian(way, p) - fvm::Sp(leak, p));
    equation.source() -= source[k] * mesh_.bounds().span().z();
    equation.solve(controls);
    answer[k] = p.primitiveField();
  }
  SolverPerformance<scalar>::debug = talk;
  const auto entry = [&](std::size_t j, std::size_t k) {
    // Symmetric but for what the solver leaves.
    return 0.5 * (gSum(scalarField(answer[k] * source[j])) + gSum(scalarField(answer[j] * source[k])));
  };
  const std::array<double, 6> row{entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
  return positive_mass(row, reach(b));
}

}  // namespace blockweir::openfoam
