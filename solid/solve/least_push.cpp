// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/least_push.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

LeastPush::LeastPush(const std::vector<Eigen::Vector3d>& mass, const std::vector<Overlap>& overlaps)
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

double LeastPush::gap(const Row& row) const {
  return row.gap + row.opens[0].dot(moved_[at(row.body[0])]) + row.opens[1].dot(moved_[at(row.body[1])]);
}

double LeastPush::deepest() const {
  double deepest = 0;
  for (const Row& row : rows_) deepest = std::max(deepest, -gap(row));
  return deepest;
}

/// The push that leaves half of the tolerance.
void LeastPush::visit(Row& row, double tolerance_m, Progress& progress) {
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

/// Far from all that overlaps nothing is to be pushed, however often that is asked.
bool LeastPush::acts(std::size_t row) {
  if (acts_[row] == 0) {
    const auto moved = [&](int body) { return at(body) + 1 < touched_.size() && touched_[at(body)] != 0; };
    if (!moved(rows_[row].body[0]) && !moved(rows_[row].body[1])) return false;
    acts_[row] = 1;
  }
  return true;
}

/// All pushes, and what they displace, by so much of what the last sweeps have changed.
void LeastPush::go_on(double beyond) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (acts_[i] == 0) continue;
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

void LeastPush::solve(double tolerance_m) {
  constexpr int most_sweeps = 100;  // each there and back
  moved_before_ = moved_;
  touched_.assign(moved_.size(), 0);
  acts_.clear();
  for (const Row& row : rows_) acts_.push_back(row.gap < -tolerance_m / 2);
  double momentum = 1;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    const double next = (1 + std::sqrt(1 + 4 * momentum * momentum)) / 2;
    go_on((momentum - 1) / next);
    Progress progress;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (acts(i)) visit(rows_[i], tolerance_m, progress);
    }
    if (progress.largest_m <= tolerance_m / 2) return;
    for (std::size_t i = rows_.size(); i-- > 0;) {
      if (acts(i)) visit(rows_[i], tolerance_m, progress);
    }
    momentum = progress.ahead > 0 ? 1 : next;
  }
}

}  // namespace blockweir::solid
