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

constexpr int retries = 2;  // half cells further, where the first open cell is dry
constexpr int columns = 8;  // of a PressureLine as numbers
constexpr std::size_t row_length = SamplePoints::most * columns;

void store(const PressureLine& line, double* row) {
  if (!line.found) return;
  row[0] = 1;
  row[1] = line.wet ? 1 : 0;
  row[2] = line.whole ? 1 : 0;
  row[3] = line.at_zero;
  row[4] = line.slope;
  row[5] = line.centre.x();
  row[6] = line.centre.y();
  row[7] = line.enclosed ? 1 : 0;
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
  line.enclosed = row[7] > 0;
  return line;
}

/// Water in a pocket, which seeps there, has a pressure in the middle half of those of the water that is not enclosed.
void bound_pockets(std::vector<double>& lines) {
  std::vector<double> open;
  bool any = false;
  for (std::size_t i = 0; i + columns <= lines.size(); i += columns) {
    const PressureLine line = load_line(&lines[i]);
    any = any || line.enclosed;
    if (line.found && line.wet && !line.enclosed) open.push_back(line.at_zero);
  }
  if (!any || open.empty()) return;
  std::sort(open.begin(), open.end());
  const double low = open[open.size() / 4];
  const double high = open[open.size() - 1 - open.size() / 4];
  for (std::size_t i = 0; i + columns <= lines.size(); i += columns) {
    PressureLine line = load_line(&lines[i]);
    if (!line.found || !line.enclosed) continue;
    line.at_zero = std::clamp(line.at_zero, low, std::max(low, high));
    store(line, &lines[i]);
  }
}

/// Sums the samples of all ranks, each with its own cells; every rank gets the result.
template <class Operation>
void combine(std::vector<double>& values, Operation operation) {
  if (!Foam::Pstream::parRun()) return;
  Foam::UList<Foam::scalar> own(values.data(), static_cast<Foam::label>(values.size()));
  Foam::List<Foam::scalar> all(own);
  Foam::Pstream::listCombineGather(all, operation);
  Foam::Pstream::listCombineScatter(all);
  std::copy(all.cbegin(), all.cend(), values.begin());
}

/// The part under the surface: pressures are positive there.
void add_pressed(const EdgeElement& e, double share, double p_from, double p_to, wire::Load& load) {
  if (p_from <= 0 && p_to <= 0) return;
  double s_from = e.s_from;
  double s_to = e.s_to;
  if (p_from * p_to < 0) {
    const double surface = s_from + (s_to - s_from) * p_from / (p_from - p_to);
    (p_from < 0 ? s_from : s_to) = surface;
    (p_from < 0 ? p_from : p_to) = 0;
  }
  if (s_from < s_to) wire::add_panel(load, e.block, e.edge, s_from, s_to, share * p_from, share * p_to);
}

}  // namespace

EdgePressures::EdgePressures(const ImmersedBlocks& blocks, const WaterState& water)
    : blocks_(blocks), water_(water), pockets_(water.mesh(), blocks) {
  const Interface& scene = blocks.interface();
  rules_.cell_m = blocks.cell_m();
  rules_.open_crack_width_m = scene.open_crack_width_m;
  std::vector<Polygon> start;
  for (const InterfaceBlock& block : scene.blocks) {
    rules_.loaded.push_back(block.loaded);
    start.push_back(block.outline);
  }
  for (const Crack& crack : scene.cracks) {
    for (const CrackPanel& p : crack.panels) rules_.cuts.push_back({p.block, p.edge, p.s_from, p.s_to});
  }
  rules_.closed = closed_intervals(start, rules_);
}

void EdgePressures::find_targets() {
  openings_.clear();
  std::vector<SampleRay> rays;
  for (const Crack& crack : blocks_.interface().cracks) {
    for (const CrackOpening* o : {&crack.mouth, &crack.end}) {
      const auto b = static_cast<std::size_t>(o->block);
      const Point& centroid = blocks_.interface().blocks[b].centroid;
      const Point at = wire::place(centroid, blocks_.poses()[b], o->point);
      const Point beyond = wire::place(centroid, blocks_.poses()[b], o->point + o->direction);
      openings_.push_back(at);
      rays.push_back(ray_at(at, (beyond - at).normalized()));
    }
  }
  targets_ = openfoam::find_targets(Faces(blocks_.outlines()), rules_, rays,
                                    [&](const std::vector<Point>& points) { return fills_at(points); });
}

std::vector<double> EdgePressures::fills_at(const std::vector<Point>& points) const {
  std::vector<double> fills(points.size(), 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int cell = blocks_.locator().find(points[i]);
    if (cell >= 0) fills[i] = blocks_.filled()[cell];
  }
  combine(fills, Foam::minEqOp<Foam::scalar>());
  return fills;
}

/// Pressure lines at all sample points.
std::vector<double> EdgePressures::look() const {
  std::vector<double> lines(targets_.samples.size() * row_length, 0.0);
  double* row = lines.data();
  for (const SamplePoints& samples : targets_.samples) {
    for (int k = 0; k < samples.count; ++k) {
      const Point& at = samples.at[static_cast<std::size_t>(k)];
      PressureLine line = water_.line_at(at, samples.cut);
      line.enclosed = line.found && pockets_.hold(blocks_.locator().find(at));
      store(line, row + k * columns);
    }
    row += row_length;
  }
  combine(lines, Foam::plusEqOp<Foam::scalar>());
  return lines;
}

PressureLine EdgePressures::first_line(std::size_t samples, const std::vector<double>& lines) const {
  const double* row = &lines[samples * row_length];
  int first = 0;
  while (first < targets_.samples[samples].count && row[first * columns] == 0) ++first;
  return first < targets_.samples[samples].count ? load_line(row + first * columns) : PressureLine{};
}

/// Pressure at the edge from the first open cell outwards. Where water fills that and the next one, the part that is
/// not weight goes on linearly to the edge: water that a wall pushes has its largest pressure there.
void EdgePressures::add_open(const EdgeElement& element, std::size_t samples, const std::vector<double>& lines,
                             wire::Load& load) {
  const double h = blocks_.cell_m();
  const double* rows = &lines[samples * row_length];
  const int count = targets_.samples[samples].count;
  int first = 0;
  while (first < count && rows[first * columns] == 0) ++first;
  PressureLine near;
  for (int last = std::min(first + retries, count - 1); first <= last; ++first) {
    near = load_line(rows + first * columns);
    if (near.wet) break;
  }
  if (!near.wet || near.slope <= 0) return;
  const double length = (element.to - element.from).norm();
  if (!near.enclosed)
    wetted_.push_back({element.block, element.middle(), element.openness * length * element.normal,
                       targets_.samples[samples].at[static_cast<std::size_t>(first)]});
  double at_zero = near.at_zero;
  if (near.whole && !near.enclosed && first + 2 < count) {
    const PressureLine next = load_line(rows + (first + 2) * columns);
    const double d_near = element.normal.dot(near.centre - element.from);
    const double d_next = element.normal.dot(next.centre - element.from);
    if (next.whole && d_next - d_near > 0.5 * h) at_zero += (near.at_zero - next.at_zero) * d_near / (d_next - d_near);
  }
  const double p_from = at_zero - near.slope * element.from.y();
  const double p_to = at_zero - near.slope * element.to.y();
  const double suction = -1.5 * h * near.slope;  // more than what a line drawn above the surface can give
  if (near.whole && std::min(p_from, p_to) <= suction) {
    wire::add_panel(load, element.block, element.edge, element.s_from, element.s_to, element.openness * p_from,
                    element.openness * p_to);
  } else {
    add_pressed(element, element.openness, p_from, p_to, load);
  }
}

/// Water enters through the mouths that it covers. Between two mouths its pressure changes linearly; it flows out
/// towards a dry mouth below its level.
void EdgePressures::add_slot(const EdgeElement& element, const std::vector<Mouth>& mouths,
                             const std::vector<double>& lines, wire::Load& load) const {
  const auto pressure = [](const PressureLine& line, const Point& at) { return line.at_zero - line.slope * at.y(); };
  std::vector<PressureLine> entering;
  for (const Mouth& m : mouths) {
    PressureLine& line = entering.emplace_back(first_line(m.samples, lines));
    line.wet = line.wet && pressure(line, m.place.lip) > 0;
  }
  double at_zero = 0;
  double slope = 0;
  for (std::size_t m = 0; m < mouths.size(); ++m) {
    if (!entering[m].wet) continue;
    double share = 1;
    if (mouths.size() == 2) {
      const SlotMouth& other = mouths[1 - m].place;
      const bool runs_out = pressure(entering[m], other.lip) > 0;
      if (entering[1 - m].wet || runs_out) share = other.distance_m / (other.distance_m + mouths[m].place.distance_m);
    }
    at_zero += share * entering[m].at_zero;
    slope += share * entering[m].slope;
  }
  if (slope > 0) {
    add_pressed(element, 1 - element.openness, at_zero - slope * element.from.y(), at_zero - slope * element.to.y(),
                load);
  }
}

/// `ends`: mouth and end of each crack.
void EdgePressures::add_cracks(const std::vector<std::array<joints::End, 2>>& ends, wire::Load& load) const {
  const Interface& scene = blocks_.interface();
  const auto& cracks = scene.cracks;
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    joints::Joint joint;
    joint.mouth = ends[c][0];
    joint.end = ends[c][1];
    joint.length_m = cracks[c].length_m;
    joint.bends = cracks[c].bends;
    joint.water_n_per_m3 = scene.water_density * scene.gravity;
    const joints::Profile profile = joints::uplift(cracks[c].law, cracks[c].known, joint);
    const auto pressure = [&](double t) { return profile.pressure(t * joint.length_m); };
    for (const CrackPanel& panel : cracks[c].panels) {
      const double length = panel.s_to - panel.s_from;
      for (const EdgeElement& e : targets_.elements) {
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

void EdgePressures::sample(JointFlow* flow, wire::Load& load) {
  if (blocks_.poses() != last_poses_) {
    find_targets();
    last_poses_ = blocks_.poses();
  }
  pockets_.find();
  std::vector<double> lines = look();
  bound_pockets(lines);
  wire::clear_panels(load);
  wetted_.clear();
  for (std::size_t i = 0; i < targets_.elements.size(); ++i) {
    const EdgeElement& e = targets_.elements[i];
    const std::size_t first = load.block.size();
    if (e.openness > 0) add_open(e, targets_.samples_of[i], lines, load);
    if (flow != nullptr && e.openness >= 1) flow->take_in(load, first);
    if (e.slot) add_slot(e, targets_.mouths[i], lines, load);
  }
  load.cracks_from = static_cast<std::uint32_t>(load.block.size());
  std::vector<std::array<joints::End, 2>> ends(blocks_.interface().cracks.size());
  for (std::size_t o = 0; o < openings_.size(); ++o) {
    const PressureLine line = first_line(targets_.openings_from + o, lines);
    const double p = line.wet ? std::max(0.0, line.at_zero - line.slope * openings_[o].y()) : 0;
    ends[o / 2][o % 2] = {p, openings_[o].y()};
  }
  add_cracks(ends, load);
  if (flow != nullptr) flow->add(targets_.elements, load);
}

}  // namespace blockweir::openfoam
