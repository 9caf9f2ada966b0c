// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks in the mesh: their positions, velocities, and the share of each cell that they fill.
#pragma once

#include <volFields.H>

#include "fluid/openfoam/cell_locator.hpp"
#include "fluid/openfoam/plugin/interface.hpp"

namespace blockweir::openfoam {

using Pose = std::array<double, 6>;  ///< as in wire::Motion

/// Outlines of a mesh's cells in the plane, counter-clockwise. Ends the run unless the mesh is one cell thick between
/// two empty patches.
std::vector<Polygon> cell_outlines(const Foam::fvMesh& mesh);

class ImmersedBlocks {
 public:
  /// The part of a cell of this rank that a block fills.
  struct Part {
    Foam::label cell = 0;
    double fraction = 0;
  };

  ImmersedBlocks(const Foam::fvMesh& mesh, const Interface& interface);

  /// Moves the blocks from `start` to `end` over a step of dt_s. Blocks at rest cost nothing. The filled shares of a
  /// block are recomputed only once a corner has moved farther than move_tolerance of the depth, which changes
  /// pressures by the same share of the largest.
  void move(const std::vector<Pose>& start, const std::vector<Pose>& end, double dt_s);
  /// Restores the positions for which the filled shares were computed last, in a resumed run.
  void cut_again(const std::vector<Pose>& poses);

  [[nodiscard]] const Interface& interface() const { return interface_; }
  /// Side of a cell beside blocks [m]: that of the interface, or the largest of all cells at their faces at the start.
  [[nodiscard]] double cell_m() const { return cell_m_; }
  [[nodiscard]] CellLocator& locator() { return locator_; }
  [[nodiscard]] const CellLocator& locator() const { return locator_; }
  [[nodiscard]] const std::vector<Polygon>& outlines() const { return outlines_; }  ///< at the end of the step
  [[nodiscard]] const std::vector<Pose>& poses() const { return placed_; }          ///< of outlines()
  [[nodiscard]] const Foam::volScalarField& filled() const { return filled_; }      ///< share by all blocks, 0..1
  [[nodiscard]] long fills() const { return fills_; }                               ///< how often filled() was made
  [[nodiscard]] const std::vector<Part>& parts(std::size_t block) const { return parts_[block]; }
  /// Mean velocity over the step [m/s] of the block's point that is at x at its end.
  [[nodiscard]] Point velocity(std::size_t block, const Point& x) const;
  [[nodiscard]] bool moves(std::size_t block) const { return start_[block] != end_[block]; }
  /// The first block that has left the mesh: its name, where, and the remedy. Empty: all are inside; the ground, and
  /// blocks less than a cell below the floor, do not count.
  [[nodiscard]] std::string strayed() const;

  /// How often filled shares of a moved block were recomputed, how often that was not needed, and its seconds.
  [[nodiscard]] long cuts() const { return cuts_; }
  [[nodiscard]] long skipped_cuts() const { return skipped_cuts_; }
  [[nodiscard]] double cut_s() const { return cut_s_; }

 private:
  void place(std::size_t block, const Pose& pose);
  void cut(std::size_t block, const Pose& pose);
  void clip(std::size_t block);
  void fill();
  [[nodiscard]] double largest_cell_at_faces() const;

  const Foam::fvMesh& mesh_;
  const Interface& interface_;
  std::vector<Polygon> cells_;
  CellLocator locator_;
  double cell_m_ = 0;
  Foam::volScalarField filled_;
  std::vector<Pose> start_;
  std::vector<Pose> end_;
  double dt_s_ = 1;
  std::vector<Pose> placed_;
  std::vector<Polygon> outlines_;
  Polygon moved_;
  std::vector<std::vector<Part>> parts_;
  PolygonClip clipper_;
  long fills_ = 0;
  long cuts_ = 0;
  long skipped_cuts_ = 0;
  double cut_s_ = 0;
};

}  // namespace blockweir::openfoam
