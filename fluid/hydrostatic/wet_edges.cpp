// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/wet_edges.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace blockweir::hydrostatic {
namespace {

/// The exact value that `s` stands for: an end of the edge, the water surface, or itself when neither is near.
double exact_end(double s, double surface, double tolerance) {
  double best = s;
  double distance = tolerance;
  for (const double candidate : {0.0, 1.0, surface}) {
    if (std::abs(s - candidate) >= distance) continue;
    distance = std::abs(s - candidate);
    best = candidate;
  }
  return std::clamp(best, 0.0, 1.0);
}

}  // namespace

WetEdges::WetEdges(const std::vector<std::vector<Point>>& outlines, double level_m, double growth_m, const Grid& grid)
    : level_m_(level_m), growth_m_(growth_m), unit_m_(grid.unit_m), tiny_m_(grid.tiny_m) {
  edges_.reserve(4 * outlines.size());
  heights_.reserve(4 * outlines.size());
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    const auto& outline = outlines[k];
    for (std::size_t e = 0; e < outline.size(); ++e) {
      const Point& from = outline[e];
      const Point span = outline[(e + 1) % outline.size()] - from;
      const bool flat = std::abs(span.y()) < tiny_m_;
      if (flat && from.y() >= level_m) continue;
      const double surface = flat ? -1 : (level_m - from.y()) / span.y();
      const double cut = flat ? 1 : std::clamp(surface, 0.0, 1.0);
      const auto [low, high] = span.y() < 0 && !flat ? std::pair(cut, 1.0) : std::pair(0.0, cut);
      if (low >= high) continue;
      const double length = span.norm();
      edges_.push_back({static_cast<int>(k), static_cast<int>(e), from, span / length, length, low, high, surface});
      const auto [bottom_m, top_m] = std::minmax({from.y(), from.y() + span.y()});
      if (heights_.size() % group == 0) groups_.push_back({bottom_m, top_m});
      groups_.back() = {std::min(groups_.back().bottom_m, bottom_m), std::max(groups_.back().top_m, top_m)};
      heights_.push_back({bottom_m, top_m});
    }
  }
  parts_.reserve(edges_.size());
}

void WetEdges::add(const Piece& boundary) {
  const double length = (boundary.to - boundary.from).norm();
  const bool surface = std::min(boundary.from.y(), boundary.to.y()) > level_m_ - tiny_m_;
  if (surface || length < tiny_m_) return;
  std::vector<std::pair<double, double>> found;
  add_near(boundary, 4 * tiny_m_ + 8 * unit_m_ * growth_m_ / length, found);
  // If blocks have slipped slightly past each other, the closed gap is in front of one block's face.
  std::sort(found.begin(), found.end());
  found.emplace_back(length, length);
  const Point along = (boundary.from - boundary.to) / length;
  double done = 0;
  for (std::vector<std::pair<double, double>> ignored; const auto& [from, to] : found) {
    if (from - done > tiny_m_) {
      add_near({boundary.to + from * along, boundary.to + done * along}, 0.4 * growth_m_, ignored);
    }
    done = std::max(done, to);
  }
}

void WetEdges::add_near(const Piece& boundary, double near_m, std::vector<std::pair<double, double>>& found) {
  const Point& start = boundary.to;  // blocks have their inside on the left, too: they run against the boundary
  const Point way = boundary.from - start;
  const double length = way.norm();
  const auto [bottom_m, top_m] = std::minmax({start.y(), boundary.from.y()});
  const Heights near{bottom_m - 2 * near_m, top_m + 2 * near_m};
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (i % group == 0) {
      while (i < edges_.size() && near.beyond(groups_[i / group])) i += group;
      if (i >= edges_.size()) break;
    }
    if (near.beyond(heights_[i])) continue;
    const Sunken& edge = edges_[i];
    const double cosine = edge.along.dot(way) / length;
    if (cosine <= 0.99) continue;
    const double first = edge.along.dot(start - edge.from);
    const double from = std::max(edge.s_from * edge.length_m, first);
    const double to = std::min(edge.s_to * edge.length_m, first + cosine * length);
    if (to - from <= tiny_m_) continue;
    const auto away = [&](double x) {  // only there: faces that are all but in line cross somewhere
      const Point q = start + way * ((x - first) / (cosine * length)) - edge.from;
      return std::abs(edge.along.x() * q.y() - edge.along.y() * q.x());
    };
    if (away(from) > near_m || away(to) > near_m) continue;
    parts_.push_back({i, from / edge.length_m, to / edge.length_m});
    found.emplace_back((from - first) / cosine, (to - first) / cosine);
  }
}

std::vector<WetInterval> WetEdges::intervals() const {
  std::vector<Part> parts = parts_;
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return std::tie(a.sunken, a.s_from, a.s_to) < std::tie(b.sunken, b.s_from, b.s_to);
  });
  std::vector<WetInterval> joined;
  joined.reserve(parts.size());
  for (const Part& part : parts) {
    const Sunken& edge = edges_[part.sunken];
    const double tolerance = 4 * tiny_m_ / edge.length_m;
    const double from = exact_end(part.s_from, edge.surface, tolerance);
    const double to = exact_end(part.s_to, edge.surface, tolerance);
    if (from >= to) continue;
    if (!joined.empty() && joined.back().block == edge.block && joined.back().edge == edge.edge &&
        from <= joined.back().s_to + tolerance) {
      joined.back().s_to = std::max(joined.back().s_to, to);
    } else {
      joined.push_back({edge.block, edge.edge, from, to});
    }
  }
  return joined;
}

}  // namespace blockweir::hydrostatic
