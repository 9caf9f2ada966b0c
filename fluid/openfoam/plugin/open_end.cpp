// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/open_end.hpp"

#include <uniformDimensionedFields.H>

#include <algorithm>
#include <cmath>

namespace blockweir::openfoam {

OpenEnd::OpenEnd(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks, const Foam::dictionary& dict, Side side)
    : mesh_(mesh), blocks_(blocks), side_(side) {
  const bool upstream = side == Side::upstream;
  gravity_ = -mesh.time().lookupObject<Foam::uniformDimensionedVectorField>("g").value().y();
  level_ = Foam::Function1<Foam::scalar>::New(upstream ? "upstreamLevel" : "downstreamLevel", dict);
  if (upstream && dict.found("wave")) {
    const Foam::dictionary& wave = dict.subDict("wave");
    wave_ = StokesWave{wave.get<Foam::scalar>("height"), wave.get<Foam::scalar>("period"),
                       wave.get<Foam::scalar>("depth"), gravity_};
  }
  patch_ = mesh.boundaryMesh().findPatchID(upstream ? "upstream" : "downstream");
  if (patch_ < 0) {
    FatalIOErrorInFunction(dict) << "the mesh has no patch " << (upstream ? "upstream" : "downstream")
                                 << ", where level_control = \"inflow\" lets water in"
                                 << Foam::exit(Foam::FatalIOError);
  }
  const Foam::fvPatch& patch = mesh.boundary()[patch_];
  for (Foam::label i = 0; i < patch.size(); ++i) {
    const double height = patch.magSf()[i] / mesh.bounds().span().z();
    faces_.push_back({patch.faceCells()[i], patch.Cf()[i].y(), height});
  }
}

double OpenEnd::inflow(double time_s, double bed, double level, double wanted, double y) const {
  if (!wave_) return 2 * (std::sqrt(gravity_ * std::max(0.0, wanted - bed)) - std::sqrt(gravity_ * (level - bed)));
  const double phase = wave_->frequency() * time_s - M_PI / 2;  // from the still level upwards
  const double grown = std::min(1.0, time_s / wave_->period_s);
  const double above_bed = y - bed;
  return grown * wave_->velocity(phase, above_bed) +
         wave_->velocity_per_elevation(above_bed) * (wanted + grown * wave_->elevation(phase) - level);
}

double OpenEnd::smooth_level(double time_s, double depth) const {
  constexpr int samples = 16;
  const double span_s = 4 * std::sqrt(depth / gravity_);
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    sum += level_->value(std::max(0.0, time_s - span_s * (i + 0.5) / samples));
  }
  return sum / samples;
}

void OpenEnd::set(double time_s) {
  if (faces_.empty()) return;
  const auto& water = mesh_.lookupObject<Foam::volScalarField>("alpha.water");
  auto& velocity = mesh_.lookupObjectRef<Foam::volVectorField>("U");
  const auto wet = [&](const Face& face) {
    return std::clamp(water[face.cell], 0.0, 1.0) * (1 - blocks_.filled()[face.cell]);
  };
  double bed = mesh_.bounds().min().y();
  double depth = 0;
  double weight = 0;
  for (const Face& face : faces_) {
    bed += blocks_.filled()[face.cell] * face.height;
    depth += wet(face) * face.height;
    weight += wet(face) * wet(face) * face.height;
  }
  const double wanted = smooth_level(time_s, depth);
  // A face that the surface cuts lets in water at its cell's fraction only: the others make up for it.
  const double scale = weight > 0 ? depth / weight : 0;
  const double inwards = side_ == Side::upstream ? 1 : -1;
  auto& at_end = velocity.boundaryFieldRef()[patch_];
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const Face& face = faces_[i];
    const double u = wet(face) > 0 ? scale * wet(face) * inflow(time_s, bed, bed + depth, wanted, face.y) : 0;
    at_end[static_cast<Foam::label>(i)] = Foam::vector(inwards * u, velocity[face.cell].y(), 0);
  }
}

}  // namespace blockweir::openfoam
