// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/edge_elements.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::openfoam {
namespace {

constexpr double sealed_cells = 2;  // a narrower gap carries no water in the mesh
constexpr double parallel = 0.26;   // sine of the angle beyond which two faces bound a corner and not a gap: 15 degrees
constexpr double infinite = std::numeric_limits<double>::infinity();

/// From nothing to all of it between two and three cells, without a kink.
double openness_of(double gap_cells) {
  const double x = std::clamp((gap_cells - sealed_cells) / (open_cells - sealed_cells), 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

void cut_edge(int block, int edge, const std::vector<Polygon>& outlines, const ElementRules& rules,
              std::vector<double>& cuts) {
  const Polygon& own = outlines[static_cast<std::size_t>(block)];
  const auto e = static_cast<std::size_t>(edge);
  const Point& from = own[e];
  const Point span = own[(e + 1) % own.size()] - from;
  const double length = span.norm();
  const Point t = span / length;
  const Point normal(t.y(), -t.x());
  const double reach = open_cells * rules.cell_m;
  cuts.clear();
  const int n = std::max(1, static_cast<int>(std::ceil(length / rules.cell_m - 1e-9)));
  for (int i = 0; i <= n; ++i) cuts.push_back(static_cast<double>(i) / n);
  for (std::size_t other = 0; other < outlines.size(); ++other) {
    const double behind = static_cast<int>(other) == block ? 0 : -reach;
    for (const Point& p : outlines[other]) {
      const double s = t.dot(p - from) / length;
      const double away = normal.dot(p - from);
      if (s > 0 && s < 1 && away > behind && away < reach) cuts.push_back(s);
    }
  }
  for (const auto* intervals : {&rules.cuts, &rules.closed}) {
    for (const EdgeInterval& i : *intervals) {
      if (i.block != block || i.edge != edge) continue;
      cuts.push_back(i.s_from);
      cuts.push_back(i.s_to);
    }
  }
  std::sort(cuts.begin(), cuts.end());
}

}  // namespace

Faces::Faces(const std::vector<Polygon>& outlines) : outlines_(outlines) {
  for (const Polygon& outline : outlines) {
    Point low = outline.front();
    Point high = low;
    for (const Point& p : outline) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    boxes_.emplace_back(low, high);
  }
}

Faces::Hit Faces::nearest(const Point& from, const Point& direction, double reach_m, int block, int edge,
                          double overlap_m) const {
  Hit hit;
  const Point start = from - overlap_m * direction;
  const Point end = from + reach_m * direction;
  const Point low = start.cwiseMin(end);
  const Point high = start.cwiseMax(end);
  for (std::size_t b = 0; b < outlines_.size(); ++b) {
    if ((boxes_[b].first.array() > high.array()).any() || (boxes_[b].second.array() < low.array()).any()) continue;
    const bool own = static_cast<int>(b) == block;
    const Polygon& outline = outlines_[b];
    for (std::size_t e = 0; e < outline.size(); ++e) {
      if (own && static_cast<int>(e) == edge) continue;
      const Point& a = outline[e];
      const Point span = outline[(e + 1) % outline.size()] - a;
      // A face that looks our way: from + distance direction = a + s span
      const double turn = cross(direction, span);
      if (turn >= 0) continue;
      const double s = cross(a - from, direction) / turn;
      const double distance = cross(a - from, span) / turn;
      if (s < 0 || s > 1 || distance < (own ? 0 : -overlap_m) || distance > reach_m) continue;
      if (distance < hit.distance_m) hit = {std::max(0.0, distance), span.normalized()};
    }
  }
  return hit;
}

std::vector<EdgeInterval> closed_intervals(const std::vector<Polygon>& outlines, ElementRules rules) {
  rules.closed.clear();
  std::vector<EdgeInterval> closed;
  for (const EdgeElement& e : edge_elements(Faces(outlines), rules)) {
    if (e.openness > 0 || e.slot) continue;
    closed.push_back({e.block, e.edge, e.s_from, e.s_to});
  }
  return closed;
}

std::vector<EdgeElement> edge_elements(const Faces& faces, const ElementRules& rules) {
  const double h = rules.cell_m;
  const double overlap = 0.02 * h;  // blocks in contact may penetrate a little
  constexpr double shortest = 1e-9;
  std::vector<EdgeElement> elements;
  std::vector<double> cuts;
  const auto classify = [&](EdgeElement& e) {
    const double reach = std::max(open_cells * h, rules.open_crack_width_m);
    const Faces::Hit across = faces.nearest(e.middle(), e.normal, reach, e.block, e.edge, overlap);
    const Point along(-e.normal.y(), e.normal.x());
    e.gap_m = across.distance_m;
    const double middle = (e.s_from + e.s_to) / 2;
    const bool joint = std::any_of(rules.closed.begin(), rules.closed.end(), [&](const EdgeInterval& i) {
      return i.block == e.block && i.edge == e.edge && i.s_from <= middle && middle <= i.s_to;
    });
    const double openness = openness_of(e.gap_m / h);
    const bool gap = e.gap_m < infinite && std::abs(cross(along, across.along)) < parallel;
    e.openness = joint || gap ? openness : 1;
    if (!joint && gap && e.gap_m <= rules.open_crack_width_m) e.openness = 0;
    e.slot = !joint && gap && e.openness < 1 && e.gap_m > rules.open_crack_width_m;
  };
  for (std::size_t b = 0; b < faces.outlines().size(); ++b) {
    if (!rules.loaded[b]) continue;
    const Polygon& outline = faces.outlines()[b];
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Point& from = outline[k];
      const Point span = outline[(k + 1) % outline.size()] - from;
      const Point t = span.normalized();
      cut_edge(static_cast<int>(b), static_cast<int>(k), faces.outlines(), rules, cuts);
      double s = 0;
      for (const double next : cuts) {
        if (next - s < shortest) continue;
        EdgeElement& e = elements.emplace_back();
        e.block = static_cast<int>(b);
        e.edge = static_cast<int>(k);
        e.s_from = s;
        e.s_to = next;
        e.from = from + s * span;
        e.to = from + next * span;
        e.normal = {t.y(), -t.x()};
        classify(e);
        s = next;
      }
    }
  }
  return elements;
}

std::vector<SlotMouth> slot_mouths(const EdgeElement& element, const Faces& faces, double cell_m) {
  constexpr int most_steps = 1000;
  constexpr int halvings = 12;
  const double step = cell_m / 2;
  const double wide = open_cells * cell_m;
  const Point& n = element.normal;
  const auto ahead = [&](const Point& at) { return faces.nearest(at, n, wide).distance_m; };
  const auto behind = [&](const Point& at) { return faces.nearest(at, -n, wide).distance_m; };
  std::vector<SlotMouth> mouths;
  for (const Point& way : {Point(-n.y(), n.x()), Point(n.y(), -n.x())}) {
    Point at = element.middle() + element.gap_m / 2 * n;
    for (int i = 0; i < most_steps; ++i) {
      if (faces.nearest(at, way, step).distance_m <= step) break;  // a dead end
      at += step * way;
      if (ahead(at) + behind(at) <= wide) {
        at += (ahead(at) - behind(at)) / 2 * n;
        continue;
      }
      Point lip = at - step * way;
      for (double part = step / 2; part > std::ldexp(step, -halvings); part /= 2) {
        if (ahead(lip + part * way) + behind(lip + part * way) <= wide) lip += part * way;
      }
      mouths.push_back({lip, at, way, step * (i + 1)});
      break;
    }
  }
  return mouths;
}

}  // namespace blockweir::openfoam
