// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks in the mesh: where they are, how fast they move, and how much of each cell they fill.
#pragma once

#include <volFields.H>

#include "fluid/openfoam/cell_locator.hpp"
#include "fluid/openfoam/plugin/interface.hpp"

namespace blockweir::openfoam {

using Pose = std::array<double, 6>;  ///< as in wire::Motion

/// Outlines of a mesh's cells in the plane, counter-clockwise. Ends the run unless the mesh is one cell thick between
/// two empty sides.
std::vector<Polygon> cell_outlines(const Foam::fvMesh& mesh);

class ImmersedBlocks {
 public:
  /// What a block fills of a cell of this rank.
  struct Part {
    Foam::label cell = 0;
    double fraction = 0;
  };

  ImmersedBlocks(const Foam::fvMesh& mesh, const Interface& interface);

  /// Over a step of dt_s the blocks go from `start` to `end`. Those that do not move cost nothing, and one is cut out
  /// of the cells anew only once a corner has gone farther than move_tolerance of the depth, where pressures differ by
  /// as much of the largest.
  void move(const std::vector<Pose>& start, const std::vector<Pose>& end, double dt_s);
  /// Where they were cut out of the cells last, in a run that goes on.
  void cut_again(const std::vector<Pose>& poses);

  [[nodiscard]] const Interface& interface() const { return interface_; }
  /// Side of a cell beside blocks [m]: the interface's, or else the largest of all cells at their faces at the start.
  [[nodiscard]] double cell_m() const { return cell_m_; }
  [[nodiscard]] CellLocator& locator() { return locator_; }
  [[nodiscard]] const CellLocator& locator() const { return locator_; }
  [[nodiscard]] const std::vector<Polygon>& outlines() const { return outlines_; }  ///< at the step's end
  [[nodiscard]] const std::vector<Pose>& poses() const { return placed_; }          ///< of outlines()
  [[nodiscard]] const Foam::volScalarField& filled() const { return filled_; }      ///< by all blocks together, 0..1
  [[nodiscard]] const std::vector<Part>& parts(std::size_t block) const { return parts_[block]; }
  /// Mean velocity over the step [m/s] of the point of a block that is at x at its end.
  [[nodiscard]] Point velocity(std::size_t block, const Point& x) const;
  [[nodiscard]] bool moves(std::size_t block) const { return start_[block] != end_[block]; }
  /// Of the first block that has left the mesh: its name, where, and what to do. Empty: all are inside, but for the
  /// ground and for what sinks below the floor by less than a cell.
  [[nodiscard]] std::string strayed() const;

  /// How often a block that had moved was cut out of the cells, how often that was not needed, and its seconds.
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
  long cuts_ = 0;
  long skipped_cuts_ = 0;
  double cut_s_ = 0;
};

}  // namespace blockweir::openfoam
