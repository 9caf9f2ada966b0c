// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/immersed_blocks.hpp"

#include <emptyPolyPatch.H>
#include <zeroGradientFvPatchFields.H>

#include <fmt/format.h>

#include <algorithm>

#include "bridge/results/stopwatch.hpp"
#include "bridge/wire/placement.hpp"

namespace blockweir::openfoam {

std::vector<Polygon> cell_outlines(const Foam::fvMesh& mesh) {
  std::vector<Polygon> outlines(static_cast<std::size_t>(mesh.nCells()));
  for (const Foam::polyPatch& patch : mesh.boundaryMesh()) {
    if (!Foam::isA<Foam::emptyPolyPatch>(patch)) continue;
    for (Foam::label f = 0; f < patch.size(); ++f) {
      Polygon outline;
      for (const Foam::label vertex : patch[f]) {
        outline.emplace_back(mesh.points()[vertex].x(), mesh.points()[vertex].y());
      }
      // One of a cell's two sides looks along z: its outline runs counter-clockwise.
      if (area(outline) > 0) outlines[static_cast<std::size_t>(patch.faceCells()[f])] = std::move(outline);
    }
  }
  for (const Polygon& outline : outlines) {
    if (!outline.empty()) continue;
    FatalErrorInFunction << "the mesh is not one cell thick between patches of type empty that face along z"
                         << Foam::exit(Foam::FatalError);
  }
  return outlines;
}

ImmersedBlocks::ImmersedBlocks(const Foam::fvMesh& mesh, const Interface& interface)
    : mesh_(mesh),
      interface_(interface),
      cells_(cell_outlines(mesh)),
      locator_(cells_),
      filled_(
          Foam::IOobject("blocks", mesh.time().timeName(), mesh, Foam::IOobject::NO_READ, Foam::IOobject::AUTO_WRITE),
          mesh, Foam::dimensionedScalar("blocks", Foam::dimless, 0.0), Foam::zeroGradientFvPatchScalarField::typeName),
      start_(interface.blocks.size(), Pose{}),
      end_(start_),
      placed_(start_),
      parts_(interface.blocks.size()) {
  for (const InterfaceBlock& block : interface.blocks) outlines_.push_back(block.outline);
  for (std::size_t b = 0; b < outlines_.size(); ++b) clip(b);
  fill();
  cell_m_ = interface.cell_m ? *interface.cell_m : largest_cell_at_faces();
}

double ImmersedBlocks::largest_cell_at_faces() const {
  constexpr double all = 1 - 1e-6;
  double largest = 0;
  for (std::size_t b = 0; b < outlines_.size(); ++b) {
    if (!interface_.blocks[b].loaded) continue;
    for (const Part& part : parts_[b]) {
      const Foam::labelList& beside = mesh_.cellCells()[part.cell];
      const bool open = std::any_of(beside.begin(), beside.end(), [&](Foam::label c) { return filled_[c] < all; });
      if (!open && filled_[part.cell] >= all) continue;
      Point low = cells_[static_cast<std::size_t>(part.cell)].front();
      Point high = low;
      for (const Point& p : cells_[static_cast<std::size_t>(part.cell)]) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
      largest = std::max(largest, (high - low).maxCoeff());
    }
  }
  Foam::reduce(largest, Foam::maxOp<Foam::scalar>());
  if (largest == 0) {
    FatalErrorInFunction << "no block that water can press on stands in the mesh" << Foam::exit(Foam::FatalError);
  }
  return largest;
}

void ImmersedBlocks::move(const std::vector<Pose>& start, const std::vector<Pose>& end, double dt_s) {
  dt_s_ = dt_s;
  start_ = start;
  end_ = end;
  const double tolerance_m = interface_.move_tolerance * interface_.depth_m;
  const long cuts_before = cuts_;
  for (std::size_t b = 0; b < outlines_.size(); ++b) {
    if (end[b] == placed_[b]) continue;
    place(b, end[b]);
    double farthest = 0;
    for (std::size_t v = 0; v < moved_.size(); ++v) {
      farthest = std::max(farthest, (moved_[v] - outlines_[b][v]).norm());
    }
    if (farthest <= tolerance_m) {
      ++skipped_cuts_;
      continue;
    }
    const Stopwatch watch(cut_s_);
    ++cuts_;
    cut(b, end[b]);
  }
  if (cuts_ == cuts_before) return;
  const Stopwatch watch(cut_s_);
  fill();
}

void ImmersedBlocks::cut_again(const std::vector<Pose>& poses) {
  for (std::size_t b = 0; b < outlines_.size(); ++b) {
    if (poses[b] == placed_[b]) continue;
    place(b, poses[b]);
    cut(b, poses[b]);
  }
  fill();
}

/// moved_ is the outline there.
void ImmersedBlocks::place(std::size_t b, const Pose& pose) {
  const InterfaceBlock& block = interface_.blocks[b];
  moved_.clear();
  for (const Point& vertex : block.outline) moved_.push_back(wire::place(block.centroid, pose, vertex));
}

/// At moved_.
void ImmersedBlocks::cut(std::size_t b, const Pose& pose) {
  placed_[b] = pose;
  outlines_[b].swap(moved_);
  clip(b);
}

std::string ImmersedBlocks::strayed() const {
  const Foam::boundBox& box = mesh_.bounds();  // of all ranks
  const double rounding = 1e-9 * box.mag();
  for (std::size_t b = 0; b < outlines_.size(); ++b) {
    if (!interface_.blocks[b].loaded) continue;
    for (const Point& p : outlines_[b]) {
      if (p.x() >= box.min().x() - rounding && p.x() <= box.max().x() + rounding && p.y() > box.min().y() - cell_m_ &&
          p.y() <= box.max().y() + rounding) {
        continue;
      }
      return fmt::format(
          "block \"{}\" leaves the mesh at ({:.6g}, {:.6g}) m, which spans ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) m; "
          "{}, or end the run before: stop_at_failure or duration_s in [analysis]",
          interface_.hello.block_names[b], p.x(), p.y(), box.min().x(), box.min().y(), box.max().x(), box.max().y(),
          interface_.own_case
              ? "widen the case's mesh"
              : "raise upstream_depths, downstream_depths or freeboard_depths or lower floor_m in [fluid]");
    }
  }
  return "";
}

void ImmersedBlocks::clip(std::size_t b) {
  parts_[b].clear();
  Point low = outlines_[b].front();
  Point high = low;
  for (const Point& p : outlines_[b]) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  constexpr double least = 1e-9;  // of a cell: round-off of cells that the outline only touches
  locator_.each_near(low, high, [&](int cell) {
    const Polygon& outline = cells_[static_cast<std::size_t>(cell)];
    const double fraction = clipper_.common_area(outlines_[b], outline) / area(outline);
    if (fraction > least) parts_[b].push_back({cell, std::min(1.0, fraction)});
  });
}

/// Summed again over all blocks: the result does not depend on the order or number of their movements.
void ImmersedBlocks::fill() {
  ++fills_;
  Foam::scalarField& filled = filled_.primitiveFieldRef();
  filled = 0;
  for (const auto& parts : parts_) {
    for (const Part& part : parts) filled[part.cell] += part.fraction;
  }
  for (Foam::scalar& f : filled) f = std::min(1.0, f);
}

Point ImmersedBlocks::velocity(std::size_t b, const Point& x) const {
  const Point& centroid = interface_.blocks[b].centroid;
  const Point material = wire::unplace(centroid, end_[b], x);
  return (wire::place(centroid, end_[b], material) - wire::place(centroid, start_[b], material)) / dt_s_;
}

}  // namespace blockweir::openfoam
