// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/overlap_projection.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/solve/colouring.hpp"
#include "solid/solve/visit_parts.hpp"

namespace blockweir::solid {
namespace {

constexpr double never_closed_m = 1e9;  // of a lane without an overlap

double largest(const Four& x) {
  return std::max({x[0], x[1], x[2], x[3]});
}

}  // namespace

OverlapProjection::OverlapProjection(const std::vector<Eigen::Vector3d>& mass, const std::vector<Overlap>& overlaps)
    : moved_(3 * (mass.size() + 1)) {
  constexpr double far = 10;  // times the deepest overlap: what is pushed moves by some of that
  double reach_m = 0;
  for (const Overlap& o : overlaps) reach_m = std::max(reach_m, -far * o.gap);
  std::vector<std::array<int, 2>> bodies;  // of each overlap that takes part
  std::vector<int> numbers;
  for (std::size_t k = 0; k < overlaps.size(); ++k) {
    const auto& ends = overlaps[k].ends;
    if (overlaps[k].gap > reach_m || (ends[0].body < 0 && ends[1].body < 0)) continue;
    bodies.push_back({ends[0].body, ends[1].body});
    numbers.push_back(static_cast<int>(k));
  }
  const std::vector<int> part = parts_of_rows(bodies, mass.size());
  std::vector<std::array<int, lanes>> of_batch;  // -1: no overlap
  for (std::size_t p = 0; p <= sweep_parts; ++p) {
    if (p == 0 || !part.empty()) add_part(static_cast<int>(p), part, bodies, numbers, of_batch);
    ends_of_parts_[p] = of_batch.size();
  }
  batches_.resize(of_batch.size());
  for_each_batch(batches_.size(), [&](std::size_t k) { fill(batches_[k], mass, overlaps, of_batch[k]); });
}

/// Overlaps of one part in batches by colour.
void OverlapProjection::add_part(int p, const std::vector<int>& part, const std::vector<std::array<int, 2>>& bodies,
                                 const std::vector<int>& numbers, std::vector<std::array<int, lanes>>& of_batch) const {
  Colouring colouring(moved_.size() / 3);
  std::vector<int> alone;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!part.empty() && part[i] != p) continue;
    std::array<Colouring::End, 2> ends;
    for (const std::size_t e : {0, 1}) ends[e] = {bodies[i][e], bodies[i][e] < 0 ? 0 : 1};
    if (!colouring.add(numbers[i], ends)) alone.push_back(numbers[i]);
  }
  for (const std::vector<int>& colour : colouring.rows()) {
    for (std::size_t i = 0; i < colour.size(); ++i) {
      if (i % lanes == 0) of_batch.push_back({-1, -1, -1, -1});
      of_batch.back()[i % lanes] = colour[i];
    }
  }
  for (const int k : alone) of_batch.push_back({k, -1, -1, -1});
}

void OverlapProjection::fill(OverlapBatch& batch, const std::vector<Eigen::Vector3d>& mass,
                             const std::vector<Overlap>& overlaps, const std::array<int, lanes>& numbers) const {
  batch.gap += never_closed_m;
  batch.flexibility += 1.0;
  for (OverlapBatch::End& end : batch.ends) end.first.fill(static_cast<int>(moved_.size()) - 3);
  for (std::size_t lane = 0; lane < numbers.size() && numbers[lane] >= 0; ++lane) {
    const Overlap& o = overlaps[at(numbers[lane])];
    const auto l = static_cast<int>(lane);
    batch.gap[l] = o.gap;
    batch.flexibility[l] = 0;
    for (const std::size_t e : {0, 1}) {
      if (o.ends[e].body < 0) continue;
      const Eigen::Vector3d& of_body = mass[at(o.ends[e].body)];
      OverlapBatch::End& end = batch.ends[e];
      end.first[lane] = 3 * o.ends[e].body;
      for (int i = 0; i < 3; ++i) end.opens[at(i)][l] = o.ends[e].opens[i];
      end.per_mass[0][l] = 1 / of_body[0];
      end.per_mass[1][l] = 1 / of_body[2];
      batch.flexibility[l] += o.ends[e].opens.dot(o.ends[e].opens.cwiseQuotient(of_body));
    }
  }
}

double OverlapProjection::deepest() const {
  double deepest = 0;
  for (const OverlapBatch& batch : batches_) deepest = std::max(deepest, largest(-gap_of(batch, moved_.data())));
  return deepest;
}

/// Is no gap farther than the tolerance below zero, nor one that is pushed farther than that above?
bool OverlapProjection::is_solved(double tolerance_m) const {
  return all_of(batches_.size(), [&](std::size_t k) {
    const OverlapBatch& batch = batches_[k];
    const Four gap = gap_of(batch, moved_.data());
    const Four off = batch.push > Four{} ? (gap > Four{} ? gap : -gap) : -gap;
    return largest(off) <= tolerance_m;
  });
}

bool OverlapProjection::may_be_pushed(const OverlapBatch& batch, double tolerance_m) const {
  if (largest(-batch.gap) > tolerance_m / 2) return true;
  const auto has_moved = [&](int first) {
    return std::any_of(&moved_[at(first)], &moved_[at(first)] + 3, [](double by) { return by != 0; });
  };
  return std::any_of(batch.ends.begin(), batch.ends.end(), [&](const OverlapBatch::End& end) {
    return std::any_of(end.first.begin(), end.first.end(), has_moved);
  });
}

/// Far from all that overlaps nothing is to be pushed. Half of what is near is pushed by none: that is looked at in
/// every fifth sweep, and before the last.
void OverlapProjection::choose(double tolerance_m) {
  constexpr int between = 5;
  saw_all_ = sweeps_++ % between == 0 || last_m_ <= tolerance_m / 2;
  if (!saw_all_) return;
  may_act_.resize(batches_.size());
  for_each_batch(batches_.size(), [&](std::size_t k) { may_act_[k] = may_be_pushed(batches_[k], tolerance_m); });
  acting_.clear();
  for (std::size_t k = 0; k < batches_.size(); ++k) {
    if (may_act_[k] != 0) acting_.push_back(k);
  }
  find_acting_parts();
}

void OverlapProjection::find_acting_parts() {
  for (std::size_t p = 0; p <= sweep_parts; ++p) {
    const auto end = std::lower_bound(acting_.begin(), acting_.end(), ends_of_parts_[p]);
    ends_of_acting_[p] = static_cast<std::size_t>(end - acting_.begin());
  }
}

/// From pushes, and what they displace, that go on by so much of what the last sweeps have changed.
void OverlapProjection::push_there(double beyond, double aim, OverlapProgress& progress) {
  for_each(moved_.size(), [&](std::size_t i) {
    const double now = moved_[i];
    moved_[i] += beyond * (now - moved_before_[i]);
    moved_before_[i] = now;
  });
  const auto visit = [&](std::size_t first, std::size_t end, OverlapProgress& so_far) {
    push_batches(batches_, std::span(acting_).subspan(first, end - first), beyond, aim, moved_.data(), so_far);
  };
  visit_parts(ends_of_acting_, visit, progress);
}

void OverlapProjection::push_back(double aim, OverlapProgress& progress) {
  const auto visit = [&](std::size_t first, std::size_t end, OverlapProgress& so_far) {
    push_batches_back(batches_, std::span(acting_).subspan(first, end - first), aim, moved_.data(), so_far);
  };
  visit_parts(ends_of_acting_, visit, progress, /*back=*/true);
}

void OverlapProjection::solve(double tolerance_m) {
  constexpr int most_sweeps = 300;  // each there and back; begun anew they would lose their momentum
  moved_before_ = moved_;
  double momentum = 1;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    const double next = (1 + std::sqrt(1 + 4 * momentum * momentum)) / 2;
    choose(tolerance_m);
    OverlapProgress progress;
    push_there((momentum - 1) / next, tolerance_m / 2, progress);
    last_m_ = largest(progress.largest);
    push_back(tolerance_m / 2, progress);
    if (saw_all_) {
      if (last_m_ <= tolerance_m / 2 || is_solved(tolerance_m)) return;
      std::erase_if(acting_, [&](std::size_t k) {
        const OverlapBatch& batch = batches_[k];
        return largest(batch.push) == 0 && largest(batch.push_before) == 0;
      });
      find_acting_parts();
    }
    momentum = progress.ahead[0] + progress.ahead[1] + progress.ahead[2] + progress.ahead[3] > 0 ? 1 : next;
  }
}

}  // namespace blockweir::solid
