// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/geometry/crossings.hpp"

#include <algorithm>

namespace blockweir::geometry {
namespace {

/// On which side of the segment's line a point lies, by the sign.
double side(const Segment& s, const Point& p) {
  return cross(Point(s.to - s.from), Point(p - s.from));
}

bool pass_through(const Segment& a, const Segment& b) {
  return side(a, b.from) * side(a, b.to) < 0 && side(b, a.from) * side(b, a.to) < 0;
}

std::vector<Segment> segments_of(const Section& section, const std::vector<Line>& lines) {
  std::vector<Segment> segments;
  const auto add_ring = [&](const std::vector<Point>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) segments.push_back({ring[i], ring[(i + 1) % ring.size()]});
  };
  add_ring(section.outline);
  for (const auto& hole : section.holes) add_ring(hole);
  for (const Line& line : lines) {
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) segments.push_back({line.points[i], line.points[i + 1]});
  }
  return segments;
}

}  // namespace

std::size_t count_segments(const Section& section, const std::vector<Line>& lines) {
  std::size_t count = section.outline.size();
  for (const auto& hole : section.holes) count += hole.size();
  for (const Line& line : lines) count += line.points.size() - 1;
  return count;
}

std::size_t count_crossings(const Section& section, const std::vector<Line>& lines, std::size_t most) {
  std::vector<Segment> segments = segments_of(section, lines);
  // From left to right: a segment can cross those alone that begin before it ends.
  for (Segment& s : segments) {
    if (s.from.x() > s.to.x()) std::swap(s.from, s.to);
  }
  std::sort(segments.begin(), segments.end(),
            [](const Segment& a, const Segment& b) { return a.from.x() < b.from.x(); });
  std::size_t count = 0;
  for (std::size_t i = 0; i < segments.size() && count <= most; ++i) {
    for (std::size_t j = i + 1; j < segments.size() && segments[j].from.x() <= segments[i].to.x(); ++j) {
      if (pass_through(segments[i], segments[j])) ++count;
    }
  }
  return count;
}

}  // namespace blockweir::geometry
