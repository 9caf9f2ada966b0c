// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/wet_faces.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "bridge/scene/at.hpp"

namespace blockweir::hydrostatic {
namespace {

namespace cl = ClipperLib;
using joints::grown;
using joints::moved_right;

Ring rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

Extent extent_of(const std::vector<Point>& outline) {
  Extent extent;
  for (const Point& p : outline) extent.extend(p);
  return extent;
}

Extent extent_of(const Structure& structure) {
  Extent all;
  for (const auto& outline : structure.outlines) all.extend(extent_of(outline));
  return all;
}

double height_of_crest(const Structure& structure) {
  double height = -std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < structure.outlines.size(); ++b) {
    if (!structure.is_retaining(b)) continue;
    for (const Point& p : structure.outlines[b]) height = std::max(height, p.y());
  }
  return height;
}

Point corner_of_crest(const Structure& structure, const Extent& all, Pool pool) {
  const double low = height_of_crest(structure) - 2e-3 * all.sizes().y();
  const bool upstream = pool == Pool::upstream;
  Point corner(upstream ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity(), 0);
  for (std::size_t b = 0; b < structure.outlines.size(); ++b) {
    if (!structure.is_retaining(b)) continue;
    for (const Point& p : structure.outlines[b]) {
      if (p.y() >= low && (upstream ? p.x() < corner.x() : p.x() > corner.x())) corner = p;
    }
  }
  return corner;
}

/// The half plane under a level, around a structure.
class Search {
 public:
  Search(const Structure& structure, double level_m)
      : structure_(structure),
        all_(extent_of(structure)),
        growth_(structure.open_crack_width_m / 2),
        level_(level_m),
        reach_(all_.min(), Point(all_.max().x(), std::max(level_m, all_.max().y()))),
        grid_(reach_),
        pad_(reach_.sizes().maxCoeff() / 32 + 4 * growth_) {  // any strip of open water beside grown corners will do
    if (structure.ground.left) {
      const Point& bed = corner(*structure.ground.left);
      beside_.push_back(rectangle(all_.min().x() - 2 * pad_, all_.min().y() - pad_, bed.x(), bed.y()));
    }
    if (structure.ground.right) {
      const Point& bed = corner(*structure.ground.right);
      beside_.push_back(rectangle(bed.x(), all_.min().y() - pad_, all_.max().x() + 2 * pad_, bed.y()));
    }
  }

  [[nodiscard]] WetFaces pool(Pool pool, bool expected_behind) {
    const Ends ends{pool == Pool::upstream, pool == Pool::downstream};
    const double middle = add_wall(pool);
    // The region beyond the wall matters only if water reaches it: half the model takes less time.
    if (expected_behind) {
      WetFaces found = on_both_sides(ends, middle);
      if (found.behind) return found;
    }
    WetFaces found = ends.left ? between(left(), middle, ends, middle) : between(middle, right(), ends, middle);
    return found.behind ? on_both_sides(ends, middle) : found;
  }

  [[nodiscard]] WetFaces up_to_the_crest(Pool pool) {
    const double end = (crest(Pool::upstream).x() + crest(Pool::downstream).x()) / 2;
    const double middle = add_wall(pool);
    return pool == Pool::upstream ? between(left(), end + growth_, {true, false}, middle)
                                  : between(end - growth_, right(), {false, true}, middle);
  }

  [[nodiscard]] WetFaces both() { return between(left(), right(), {true, true}, all_.center().x()); }

 private:
  /// From which of the frame's ends the water comes.
  struct Ends {
    bool left;
    bool right;
  };

  [[nodiscard]] const Point& corner(const scene::BedCorner& end) const {
    return structure_.outlines[at(end.block)][at(end.vertex)];
  }
  [[nodiscard]] double left() const { return all_.min().x() - pad_; }
  [[nodiscard]] double right() const { return all_.max().x() + pad_; }
  [[nodiscard]] Point crest(Pool pool) const { return corner_of_crest(structure_, all_, pool); }

  /// Depth of the frame below the blocks: less than their growth, so that no water gets below a structure whose base is
  /// slightly rotated by round-off.
  [[nodiscard]] double below() const { return structure_.floats ? pad_ : growth_ / 2; }

  /// On the crest's corner, and where its middle is.
  double add_wall(Pool pool) {
    const double thickness = 1e-5 * reach_.sizes().maxCoeff();
    const Point crest_m = crest(pool);
    const double from = pool == Pool::upstream ? crest_m.x() : crest_m.x() - thickness;
    beside_.push_back(rectangle(from, crest_m.y() - thickness, from + thickness, reach_.max().y() + pad_));
    return from + thickness / 2;
  }

  /// Water above the crest that is connected below it, too, is one body, and no wall parts it.
  [[nodiscard]] WetFaces on_both_sides(Ends ends, double middle) {
    WetFaces found = between(left(), right(), ends, middle);
    if (!found.breached || level_ <= height_of_crest(structure_)) return found;
    beside_.pop_back();
    return between(left(), right(), ends, middle);
  }

  /// What the grown obstacles leave of the frame: its outer rings and holes.
  [[nodiscard]] cl::Paths water_in(const Ring& frame) const {
    const Point most = Point::Constant(3 * growth_);  // how far a corner grows, and more
    const Extent seen(frame[0] - most, frame[2] + most);
    cl::Clipper clipper;
    clipper.AddPath(grid_.units(frame), cl::ptSubject, true);
    for (const auto* obstacles : {&structure_.outlines, &beside_}) {
      for (const Ring& obstacle : *obstacles) {
        if (!extent_of(obstacle).intersects(seen)) continue;
        clipper.AddPath(grid_.units(grown(obstacle, growth_)), cl::ptClip, true);
      }
    }
    cl::Paths water;
    clipper.Execute(cl::ctDifference, water, cl::pftPositive, cl::pftPositive);
    return water;
  }

  /// The water's boundary where the blocks are: the frame, which is as much larger as they are, moves towards the
  /// water.
  [[nodiscard]] std::vector<Piece> moved_back(const cl::Path& path, const cl::Path& frame) const {
    Ring ring;
    std::vector<double> right_m;
    ring.reserve(path.size());
    right_m.reserve(path.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
      const cl::IntPoint& a = path[i];
      const cl::IntPoint& b = path[(i + 1) % path.size()];
      if ((grid_.metres(b) - grid_.metres(a)).norm() < grid_.tiny_m) continue;  // of no direction
      const bool upright = a.X == b.X && (a.X == frame[0].X || a.X == frame[2].X);
      const bool surface = a.Y == b.Y && a.Y == frame[2].Y;
      const bool bottom = a.Y == b.Y && a.Y == frame[0].Y;
      ring.push_back(grid_.metres(a));
      right_m.push_back(bottom ? -below() : upright || surface ? -growth_ : growth_);
    }
    std::vector<Piece> pieces = moved_right(ring, right_m);
    for (Piece& piece : pieces) piece = {grid_.rounded(piece.from), grid_.rounded(piece.to)};
    return pieces;
  }

  /// `breached` where water reaches from the frame's left to its right, `behind` where it passes `middle_m`.
  [[nodiscard]] WetFaces between(double left_m, double right_m, Ends ends, double middle_m) const {
    WetFaces result;
    const double bottom = all_.min().y() - below();
    const Ring frame = rectangle(left_m, bottom, right_m, level_ + growth_);
    const cl::Path frame_units = grid_.units(frame);
    const cl::cInt middle = grid_.units(Point(middle_m, level_)).X;
    const cl::Paths water = water_in(frame);
    WetEdges edges(structure_.outlines, level_, growth_, grid_);
    const auto add_boundary = [&](const cl::Path& path) {
      const std::vector<Piece> pieces = moved_back(path, frame_units);
      Ring& ring = result.region.emplace_back();
      ring.reserve(2 * pieces.size());
      for (const Piece& piece : pieces) {
        ring.insert(ring.end(), {piece.from, piece.to});
        edges.add(piece);
      }
    };
    for (const cl::Path& component : water) {
      if (!cl::Orientation(component)) continue;  // a hole: the outline of a block under water, see below
      const auto [leftmost, rightmost] = std::minmax_element(component.begin(), component.end(),
                                                             [](const auto& a, const auto& b) { return a.X < b.X; });
      const bool from_left = leftmost->X <= frame_units[0].X;
      const bool from_right = rightmost->X >= frame_units[2].X;
      if (!(from_left && ends.left) && !(from_right && ends.right)) continue;
      result.breached = result.breached || (from_left && from_right);
      result.behind = result.behind || (ends.left ? rightmost->X >= middle : leftmost->X <= middle);
      add_boundary(component);
      for (const cl::Path& hole : water) {
        if (!cl::Orientation(hole) && cl::PointInPolygon(hole.front(), component) != 0) add_boundary(hole);
      }
    }
    result.intervals = edges.intervals();
    return result;
  }

  const Structure& structure_;
  Extent all_;
  double growth_;
  double level_;
  Extent reach_;
  Grid grid_;
  double pad_;
  std::vector<Ring> beside_;  ///< further boundaries of the water: the ground beyond the ends, the wall on the crest
};

/// No water in the model.
bool dry(const Structure& structure, double level_m) {
  return structure.outlines.empty() || level_m <= extent_of(structure).min().y();
}

}  // namespace

Point crest_corner(const Structure& structure, Pool pool) {
  return corner_of_crest(structure, extent_of(structure), pool);
}

double crest_m(const Structure& structure) {
  return height_of_crest(structure);
}

WetFaces wet_faces(const Structure& structure, Pool pool, double level_m, bool expected_behind) {
  if (dry(structure, level_m)) return {};
  return Search(structure, level_m).pool(pool, expected_behind);
}

WetFaces wet_faces_up_to_the_crest(const Structure& structure, Pool pool, double level_m) {
  if (dry(structure, level_m)) return {};
  return Search(structure, level_m).up_to_the_crest(pool);
}

WetFaces wet_faces_of_both(const Structure& structure, double level_m) {
  if (dry(structure, level_m)) return {};
  return Search(structure, level_m).both();
}

}  // namespace blockweir::hydrostatic
