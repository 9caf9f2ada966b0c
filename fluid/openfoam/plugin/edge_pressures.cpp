// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/edge_pressures.hpp"

#include <PstreamReduceOps.H>
#include <ops.H>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/wire/panels.hpp"
#include "bridge/wire/placement.hpp"

namespace blockweir::openfoam {
namespace {

constexpr double sealed_cells = 2;  // a narrower gap carries no water in the mesh
constexpr double open_cells = 3;    // a wider one carries all of it
constexpr int looks = 8;            // half cells outwards, for a cell that no block reaches
constexpr int retries = 2;          // half cells further, where that cell is dry
constexpr int columns = 7;          // of a PressureLine as numbers

double cross(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// From nothing to all of it between two and three cells, without a kink.
double openness_of(double gap_cells) {
  const double x = std::clamp((gap_cells - sealed_cells) / (open_cells - sealed_cells), 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

/// Along the axis nearer to the normal: the cell beside a sloping face is then as deep as the face, and next to a steep
/// one it is under water if that is.
Point outwards(const Point& normal) {
  return std::abs(normal.x()) >= std::abs(normal.y()) ? Point(std::copysign(1, normal.x()), 0)
                                                      : Point(0, std::copysign(1, normal.y()));
}

void store(const PressureLine& line, double* row) {
  if (!line.found) return;
  row[0] = 1;
  row[1] = line.wet ? 1 : 0;
  row[2] = line.whole ? 1 : 0;
  row[3] = line.at_zero;
  row[4] = line.slope;
  row[5] = line.centre.x();
  row[6] = line.centre.y();
}

PressureLine load_line(const double* row) {
  // Where two ranks found the same point, both of them said so.
  const double n = std::max(1.0, row[0]);
  PressureLine line;
  line.found = row[0] > 0;
  line.wet = row[1] > 0;
  line.whole = row[2] > 0;
  line.at_zero = row[3] / n;
  line.slope = row[4] / n;
  line.centre = Point(row[5], row[6]) / n;
  return line;
}

}  // namespace

void EdgePressures::find_elements() {
  elements_.clear();
  const auto& outlines = blocks_.outlines();
  for (std::size_t b = 0; b < outlines.size(); ++b) {
    if (!blocks_.interface().blocks[b].loaded) continue;
    for (std::size_t e = 0; e < outlines[b].size(); ++e) {
      split(static_cast<int>(b), static_cast<int>(e), outlines[b][e], outlines[b][(e + 1) % outlines[b].size()]);
    }
  }
  const double h = blocks_.cell_m();
  for (Element& element : elements_) element.openness = openness_of(gap_beyond(element) / h);
}

/// Elements end where a cell's length does, where a neighbour's corner lies beside the edge, and where a crack ends.
void EdgePressures::split(int block, int edge, const Point& from, const Point& to) {
  const double h = blocks_.cell_m();
  const double reach = open_cells * h;
  const Point span = to - from;
  const double length = span.norm();
  const Point t = span / length;
  const Point normal(t.y(), -t.x());
  cuts_.clear();
  const int n = std::max(1, static_cast<int>(std::ceil(length / h - 1e-9)));
  for (int i = 0; i <= n; ++i) cuts_.push_back(static_cast<double>(i) / n);
  const auto& outlines = blocks_.outlines();
  for (std::size_t other = 0; other < outlines.size(); ++other) {
    if (static_cast<int>(other) == block) continue;
    for (const Point& p : outlines[other]) {
      const double s = t.dot(p - from) / length;
      if (s > 0 && s < 1 && std::abs(normal.dot(p - from)) < reach) cuts_.push_back(s);
    }
  }
  for (const Crack& crack : blocks_.interface().cracks) {
    for (const CrackPanel& panel : crack.panels) {
      if (panel.block != block || panel.edge != edge) continue;
      cuts_.push_back(panel.s_from);
      cuts_.push_back(panel.s_to);
    }
  }
  std::sort(cuts_.begin(), cuts_.end());
  constexpr double shortest = 1e-9;
  double s = 0;
  for (const double next : cuts_) {
    if (next - s < shortest) continue;
    elements_.push_back({block, edge, s, next, from + s * span, from + next * span, normal, 1});
    s = next;
  }
}

/// To the face of another block along the normal from the element's middle [m]; infinite where there is none near.
double EdgePressures::gap_beyond(const Element& element) const {
  const double h = blocks_.cell_m();
  const double reach = open_cells * h;
  const double overlap = 0.02 * h;  // blocks in contact may penetrate a little
  const Point middle = (element.from + element.to) / 2;
  double gap = std::numeric_limits<double>::infinity();
  const auto& outlines = blocks_.outlines();
  for (std::size_t other = 0; other < outlines.size(); ++other) {
    if (static_cast<int>(other) == element.block) continue;
    const Polygon& outline = outlines[other];
    for (std::size_t e = 0; e < outline.size(); ++e) {
      const Point& a = outline[e];
      const Point span = outline[(e + 1) % outline.size()] - a;
      // A face that looks our way: middle + gap n = a + s span
      const double turn = cross(element.normal, span);
      if (turn >= 0) continue;
      const double s = cross(a - middle, element.normal) / turn;
      const double distance = cross(a - middle, span) / turn;
      if (s < 0 || s > 1 || distance < -overlap || distance > reach) continue;
      gap = std::min(gap, std::max(0.0, distance));
    }
  }
  return gap;
}

/// The cells of this rank along a ray, as rows of numbers that ranks can add up.
void EdgePressures::look_along(const Point& from, const Point& direction, std::vector<double>& lines) const {
  const double h = blocks_.cell_m();
  for (int k = 1; k <= looks; ++k) {
    lines.insert(lines.end(), columns, 0.0);
    store(water_.line_at(from + 0.5 * k * h * direction), &lines[lines.size() - columns]);
  }
}

/// Pressure at the edge from the first open cell outwards. Where water fills that and the next one, the part that is
/// not weight goes on linearly to the edge: water that a wall pushes has its largest pressure there.
void EdgePressures::add_open(const Element& element, const double* lines, wire::Load& load) {
  const double h = blocks_.cell_m();
  int first = 0;
  while (first < looks && lines[first * columns] == 0) ++first;
  PressureLine near;
  for (int last = std::min(first + retries, looks - 1); first <= last; ++first) {
    near = load_line(lines + first * columns);
    if (near.wet) break;
  }
  if (!near.wet || near.slope <= 0) return;
  const Point middle = (element.from + element.to) / 2;
  const double length = (element.to - element.from).norm();
  wetted_.push_back({element.block, middle, element.openness * length * element.normal,
                     middle + 0.5 * (first + 1) * h * outwards(element.normal)});
  double at_zero = near.at_zero;
  if (near.whole && first + 2 < looks) {
    const PressureLine next = load_line(lines + (first + 2) * columns);
    const double d_near = element.normal.dot(near.centre - element.from);
    const double d_next = element.normal.dot(next.centre - element.from);
    if (next.whole && d_next - d_near > 0.5 * h) at_zero += (near.at_zero - next.at_zero) * d_near / (d_next - d_near);
  }
  double p_from = at_zero - near.slope * element.from.y();
  double p_to = at_zero - near.slope * element.to.y();
  const double suction = -1.5 * h * near.slope;  // more than what a line drawn above the surface can give
  double s_from = element.s_from;
  double s_to = element.s_to;
  if (!near.whole || std::min(p_from, p_to) > suction) {
    if (p_from <= 0 && p_to <= 0) return;
    if (p_from * p_to < 0) {
      const double surface = s_from + (s_to - s_from) * p_from / (p_from - p_to);
      (p_from < 0 ? s_from : s_to) = surface;
      (p_from < 0 ? p_from : p_to) = 0;
    }
  }
  if (s_from >= s_to) return;
  wire::add_panel(load, element.block, element.edge, s_from, s_to, element.openness * p_from, element.openness * p_to);
}

void EdgePressures::add_cracks(const std::vector<CrackPressure>& pressures, wire::Load& load) const {
  const auto& cracks = blocks_.interface().cracks;
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    const auto pressure = [&](double t) {
      return cracks[c].full ? pressures[c].mouth : pressures[c].mouth + t * (pressures[c].end - pressures[c].mouth);
    };
    for (const CrackPanel& panel : cracks[c].panels) {
      const double length = panel.s_to - panel.s_from;
      for (const Element& e : elements_) {
        const double middle = (e.s_from + e.s_to) / 2;
        if (e.block != panel.block || e.edge != panel.edge || middle < panel.s_from || middle > panel.s_to) continue;
        const auto along = [&](double s) {
          return panel.t_from + (s - panel.s_from) / length * (panel.t_to - panel.t_from);
        };
        const double closed = 1 - e.openness;
        const double p_from = closed * pressure(along(e.s_from));
        const double p_to = closed * pressure(along(e.s_to));
        if (p_from > 0 || p_to > 0) wire::add_panel(load, e.block, e.edge, e.s_from, e.s_to, p_from, p_to);
      }
    }
  }
}

void EdgePressures::sample(wire::Load& load) {
  if (blocks_.poses() != last_poses_) {
    find_elements();
    last_poses_ = blocks_.poses();
  }
  // Every rank looks where its cells are; added up, all of them know all of it.
  std::vector<double> lines;
  std::vector<Point> openings;
  for (const Element& e : elements_) {
    if (e.openness > 0) look_along((e.from + e.to) / 2, outwards(e.normal), lines);
  }
  for (const Crack& crack : blocks_.interface().cracks) {
    for (const CrackOpening* o : {&crack.mouth, &crack.end}) {
      const auto b = static_cast<std::size_t>(o->block);
      const Point& centroid = blocks_.interface().blocks[b].centroid;
      const Point at = wire::place(centroid, blocks_.poses()[b], o->point);
      const Point beyond = wire::place(centroid, blocks_.poses()[b], o->point + o->direction);
      openings.push_back(at);
      look_along(at, (beyond - at).normalized(), lines);
    }
  }
  if (Foam::Pstream::parRun()) {
    Foam::UList<Foam::scalar> all(lines.data(), static_cast<Foam::label>(lines.size()));
    Foam::List<Foam::scalar> sum(all);
    Foam::Pstream::listCombineGather(sum, Foam::plusEqOp<Foam::scalar>());
    Foam::Pstream::listCombineScatter(sum);
    std::copy(sum.cbegin(), sum.cend(), lines.begin());
  }

  wire::clear_panels(load);
  wetted_.clear();
  const double* row = lines.data();
  for (const Element& e : elements_) {
    if (e.openness == 0) continue;
    add_open(e, row, load);
    row += looks * columns;
  }
  load.cracks_from = static_cast<std::uint32_t>(load.block.size());
  std::vector<CrackPressure> pressures(blocks_.interface().cracks.size());
  for (std::size_t o = 0; o < openings.size(); ++o, row += looks * columns) {
    int first = 0;
    while (first < looks && row[first * columns] == 0) ++first;
    if (first == looks) continue;
    const PressureLine line = load_line(row + first * columns);
    const double p = line.wet ? std::max(0.0, line.at_zero - line.slope * openings[o].y()) : 0;
    (o % 2 == 0 ? pressures[o / 2].mouth : pressures[o / 2].end) = p;
  }
  add_cracks(pressures, load);
}

}  // namespace blockweir::openfoam
