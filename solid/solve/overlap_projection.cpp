// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/overlap_projection.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

OverlapProjection::OverlapProjection(const std::vector<Eigen::Vector3d>& mass, const std::vector<Overlap>& overlaps)
    : moved_(mass.size() + 1, Eigen::Vector3d::Zero()) {
  constexpr double far = 10;  // times the deepest overlap: what is pushed moves by some of that
  double reach_m = 0;
  for (const Overlap& o : overlaps) reach_m = std::max(reach_m, -far * o.gap);
  const int still = static_cast<int>(mass.size());
  for (const Overlap& o : overlaps) {
    if (o.gap > reach_m || (o.ends[0].body < 0 && o.ends[1].body < 0)) continue;
    Row& row = rows_.emplace_back();
    row.gap = o.gap;
    for (std::size_t i = 0; i < 2; ++i) {
      if (o.ends[i].body < 0) {
        row.body[i] = still;
        continue;
      }
      row.body[i] = o.ends[i].body;
      row.opens[i] = o.ends[i].opens;
      row.moves[i] = row.opens[i].cwiseQuotient(mass[at(row.body[i])]);
    }
    row.flexibility = row.opens[0].dot(row.moves[0]) + row.opens[1].dot(row.moves[1]);
  }
}

double OverlapProjection::gap(const Row& row) const {
  return row.gap + row.opens[0].dot(moved_[at(row.body[0])]) + row.opens[1].dot(moved_[at(row.body[1])]);
}

double OverlapProjection::deepest() const {
  double deepest = 0;
  for (const Row& row : rows_) deepest = std::max(deepest, -gap(row));
  return deepest;
}

/// The push that leaves half of the tolerance.
void OverlapProjection::visit(Row& row, double tolerance_m, Progress& progress) {
  const double left = gap(row);
  const double found = std::max(0.0, row.push - (left + tolerance_m / 2) / row.flexibility);
  const double more = found - row.push;
  if (more == 0) return;
  progress.largest_m = std::max(progress.largest_m, row.flexibility * std::abs(more));
  progress.ahead -= row.flexibility * more * (found - row.push_before);
  row.push = found;
  for (std::size_t i = 0; i < 2; ++i) {
    moved_[at(row.body[i])] += more * row.moves[i];
    touched_[at(row.body[i])] = 1;
  }
}

/// Far from all that overlaps nothing is to be pushed. Half of what is near is pushed by none: that is looked at in
/// every fifth sweep, and before the last.
void OverlapProjection::choose_rows(double tolerance_m) {
  constexpr int between = 5;
  saw_all_ = sweeps_++ % between == 0 || last_m_ <= tolerance_m / 2;
  if (!saw_all_) return;
  acting_.clear();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    if (row.gap < -tolerance_m / 2 || touched_[at(row.body[0])] != 0 || touched_[at(row.body[1])] != 0) {
      acting_.push_back(i);
    }
  }
}

/// All pushes, and what they displace, by so much of what the last sweeps have changed.
void OverlapProjection::go_on(double beyond) {
  for (const std::size_t i : acting_) {
    Row& row = rows_[i];
    const double now = row.push;
    row.push += beyond * (now - row.push_before);
    row.push_before = now;
  }
  for (std::size_t b = 0; b < moved_.size(); ++b) {
    const Eigen::Vector3d now = moved_[b];
    moved_[b] += beyond * (now - moved_before_[b]);
    moved_before_[b] = now;
  }
}

void OverlapProjection::solve(double tolerance_m) {
  constexpr int most_sweeps = 100;  // each there and back
  moved_before_ = moved_;
  touched_.assign(moved_.size(), 0);
  double momentum = 1;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    const double next = (1 + std::sqrt(1 + 4 * momentum * momentum)) / 2;
    go_on((momentum - 1) / next);
    choose_rows(tolerance_m);
    Progress progress;
    for (const std::size_t i : acting_) visit(rows_[i], tolerance_m, progress);
    last_m_ = progress.largest_m;
    if (saw_all_ && last_m_ <= tolerance_m / 2) return;
    for (std::size_t i = acting_.size(); i-- > 0;) visit(rows_[acting_[i]], tolerance_m, progress);
    if (saw_all_) {
      std::erase_if(acting_, [&](std::size_t i) { return rows_[i].push == 0 && rows_[i].push_before == 0; });
    }
    momentum = progress.ahead > 0 ? 1 : next;
  }
}

}  // namespace blockweir::solid
