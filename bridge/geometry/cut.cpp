// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/geometry/cut.hpp"

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <deque>
#include <map>

namespace blockweir::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Segments = CGAL::Arr_segment_traits_2<Kernel>;
using Traits = CGAL::Arr_consolidated_curve_data_traits_2<Segments, int>;

/// Crossings of the section's boundary on the way from outside, and the piece that the face becomes.
struct FaceData {
  int depth = -1;
  int piece = -1;
};
using Arrangement = CGAL::Arrangement_2<Traits, CGAL::Arr_face_extended_dcel<Traits, FaceData>>;
using Halfedge = Arrangement::Halfedge_const_handle;
using Face = Arrangement::Face_handle;

constexpr double thinnest_ratio = 1e-8;  ///< of the section's size: what is thinner is no block
constexpr int boundary = -1;             ///< what edges of the section's outline and holes carry

Kernel::Point_2 exact(const Point& p) {
  return {p.x(), p.y()};
}
Point rounded(const Kernel::Point_2& p) {
  return {CGAL::to_double(p.x().exact()), CGAL::to_double(p.y().exact())};
}
double length(const Halfedge& e) {
  return (rounded(e->target()->point()) - rounded(e->source()->point())).norm();
}

void add(std::vector<Traits::Curve_2>& curves, const Point& a, const Point& b, int id) {
  if (a != b) curves.emplace_back(Kernel::Segment_2(exact(a), exact(b)), id);
}
void add_ring(std::vector<Traits::Curve_2>& curves, const std::vector<Point>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) add(curves, ring[i], ring[(i + 1) % ring.size()], boundary);
}

double size_of(const Section& section) {
  Point low = section.outline.front();
  Point high = low;
  for (const Point& p : section.outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (high - low).maxCoeff();
}

int boundaries(const Halfedge& e) {
  const auto& ids = e->curve().data();
  return static_cast<int>(std::count(ids.begin(), ids.end(), boundary));
}
int line_of(const Halfedge& e) {
  const auto& ids = e->curve().data();
  return *std::min_element(ids.begin(), ids.end());
}

/// Calls `visit` for each edge around a face, seen from it.
template <class Visit>
void around(Face face, Visit visit) {
  const auto walk = [&](Arrangement::Ccb_halfedge_circulator edge) {
    const auto begin = edge;
    do visit(edge);
    while (++edge != begin);
  };
  if (!face->is_unbounded()) walk(face->outer_ccb());
  for (auto inner = face->inner_ccbs_begin(); inner != face->inner_ccbs_end(); ++inner) walk(*inner);
}

/// An inner edge with the same face on both sides separates nothing.
void remove_dangling(Arrangement& arrangement, double& length_m) {
  std::vector<Arrangement::Halfedge_handle> dangling;
  for (auto e = arrangement.edges_begin(); e != arrangement.edges_end(); ++e) {
    if (e->face() == e->twin()->face()) dangling.push_back(e);
  }
  for (const auto& e : dangling) {
    if (e->face()->data().depth % 2 == 1) length_m += length(e);
    arrangement.remove_edge(e);
  }
}

/// Depth by crossings of the boundary: odd inside.
void mark_inside(Arrangement& arrangement) {
  std::deque<Face> border;
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
    face->set_data({});
    if (!face->is_unbounded()) continue;
    face->set_data({.depth = 0});
    border.push_back(face);
  }
  while (!border.empty()) {
    const Face face = border.front();
    border.pop_front();
    around(face, [&](Arrangement::Halfedge_handle e) {
      const Face next = e->twin()->face();
      if (next->data().depth >= 0) return;
      next->set_data({.depth = face->data().depth + boundaries(e)});
      border.push_back(next);
    });
  }
}

using Ring = std::vector<Kernel::Point_2>;

Ring outer_ring(Face face) {
  Ring ring;
  auto edge = face->outer_ccb();
  const auto begin = edge;
  do ring.push_back(edge->target()->point());
  while (++edge != begin);
  return ring;
}

/// Corners of a ring: not what lies on a straight line, nor within `tolerance` of it or of another corner.
Piece piece_of(const Ring& ring, double tolerance) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto& before = ring[(i + ring.size() - 1) % ring.size()];
    if (!CGAL::collinear(before, ring[i], ring[(i + 1) % ring.size()])) points.push_back(rounded(ring[i]));
  }
  const auto needless = [&](std::size_t i) {
    const Point& before = points[(i + points.size() - 1) % points.size()];
    const Point in = points[i] - before;
    const Point through = points[(i + 1) % points.size()] - before;
    return std::abs(in.x() * through.y() - in.y() * through.x()) <= tolerance * std::max(through.norm(), in.norm());
  };
  for (std::size_t i = 0; points.size() > 3 && i < points.size();) {
    if (needless(i)) {
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
      i = i > 0 ? i - 1 : 0;
    } else {
      ++i;
    }
  }
  return {std::move(points)};
}

/// What the face encloses: holes, and parts attached to its boundary at one point.
std::vector<Point> enclosed_by(Face face, Ring ring) {
  std::vector<Point> corners;
  for (auto inner = face->inner_ccbs_begin(); inner != face->inner_ccbs_end(); ++inner) {
    corners.push_back(rounded((*inner)->source()->point()));
  }
  std::sort(ring.begin(), ring.end());
  for (auto twice = std::adjacent_find(ring.begin(), ring.end()); twice != ring.end();
       twice = std::adjacent_find(twice + 1, ring.end())) {
    corners.push_back(rounded(*twice));
  }
  return corners;
}

/// Depth of a slender face: twice its area over its perimeter.
double depth_of(Face face) {
  double area = 0;
  double perimeter = 0;
  const Point origin = rounded(face->outer_ccb()->source()->point());
  around(face, [&](Arrangement::Halfedge_handle e) {
    const Point a = rounded(e->source()->point()) - origin;
    const Point b = rounded(e->target()->point()) - origin;
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
    perimeter += (b - a).norm();
  });
  return 2 * area / perimeter;
}

/// Lines that almost meet leave faces thinner than any block: each joins the neighbour with which it shares most.
bool merge_a_sliver(Arrangement& arrangement, double thinnest) {
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
    if (face->data().depth % 2 != 1 || depth_of(face) >= thinnest) continue;
    std::map<Face, double> shared;
    around(face, [&](Arrangement::Halfedge_handle e) {
      if (boundaries(e) == 0) shared[e->twin()->face()] += length(e);
    });
    if (shared.empty()) continue;
    const Face into = std::max_element(shared.begin(), shared.end(), [](const auto& p, const auto& q) {
                        return p.second < q.second;
                      })->first;
    std::vector<Arrangement::Halfedge_handle> edges;
    around(face, [&](Arrangement::Halfedge_handle e) {
      if (boundaries(e) == 0 && e->twin()->face() == into) edges.push_back(e);
    });
    for (const auto& e : edges) arrangement.remove_edge(e);
    return true;
  }
  return false;
}

Point lowest(const Piece& piece) {
  return *std::min_element(piece.vertices.begin(), piece.vertices.end(), [](const Point& p, const Point& q) {
    return p.y() != q.y() ? p.y() < q.y() : p.x() < q.x();
  });
}

/// Faces inside the section, as pieces in their order.
void collect_pieces(Arrangement& arrangement, double tolerance, Cut& result) {
  std::vector<std::pair<Piece, Face>> found;
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
    if (face->data().depth % 2 != 1) continue;
    const Ring ring = outer_ring(face);
    const std::vector<Point> enclosed = enclosed_by(face, ring);
    result.enclosed.insert(result.enclosed.end(), enclosed.begin(), enclosed.end());
    if (enclosed.empty()) found.emplace_back(piece_of(ring, tolerance), face);
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    const Point p = lowest(a.first);
    const Point q = lowest(b.first);
    if (p != q) return p.y() != q.y() ? p.y() < q.y() : p.x() < q.x();
    return std::lexicographical_compare(
        a.first.vertices.begin(), a.first.vertices.end(), b.first.vertices.begin(), b.first.vertices.end(),
        [](const Point& r, const Point& s) { return r.x() != s.x() ? r.x() < s.x() : r.y() < s.y(); });
  });
  for (auto& [piece, face] : found) {
    face->set_data({.depth = 1, .piece = static_cast<int>(result.pieces.size())});
    result.pieces.push_back(std::move(piece));
  }
}

void collect_neighbours(Arrangement& arrangement, Cut& result) {
  std::map<std::pair<int, int>, std::map<int, double>> lengths;  // by line, of each pair
  for (auto e = arrangement.edges_begin(); e != arrangement.edges_end(); ++e) {
    const int a = e->face()->data().piece;
    const int b = e->twin()->face()->data().piece;
    if (a >= 0 && b >= 0 && boundaries(e) == 0) lengths[std::minmax(a, b)][line_of(e)] += length(e);
  }
  for (const auto& [pair, by_line] : lengths) {
    const auto longest = std::max_element(by_line.begin(), by_line.end(),
                                          [](const auto& p, const auto& q) { return p.second < q.second; });
    result.neighbours.push_back({pair.first, pair.second, longest->first});
  }
}

}  // namespace

Cut cut(const Section& section, const std::vector<Line>& lines) {
  std::vector<Traits::Curve_2> curves;
  add_ring(curves, section.outline);
  for (const auto& hole : section.holes) add_ring(curves, hole);
  for (const Line& line : lines) {
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) add(curves, line.points[i], line.points[i + 1], line.id);
  }
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());
  Cut result;
  mark_inside(arrangement);
  remove_dangling(arrangement, result.dangling_m);
  mark_inside(arrangement);
  const double thinnest = thinnest_ratio * size_of(section);
  while (merge_a_sliver(arrangement, thinnest)) {
    remove_dangling(arrangement, result.dangling_m);
    mark_inside(arrangement);
  }
  collect_pieces(arrangement, thinnest, result);
  collect_neighbours(arrangement, result);
  return result;
}

}  // namespace blockweir::geometry
