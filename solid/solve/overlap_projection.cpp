// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/overlap_projection.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/solve/colouring.hpp"

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
  Colouring colouring(mass.size());
  std::vector<int> alone;
  for (std::size_t k = 0; k < overlaps.size(); ++k) {
    const Overlap& o = overlaps[k];
    if (o.gap > reach_m || (o.ends[0].body < 0 && o.ends[1].body < 0)) continue;
    std::array<Colouring::End, 2> ends;
    for (const std::size_t e : {0, 1}) ends[e] = {o.ends[e].body, o.ends[e].body < 0 ? 0 : 1};
    if (!colouring.add(static_cast<int>(k), ends)) alone.push_back(static_cast<int>(k));
  }
  for (const std::vector<int>& colour : colouring.rows()) {
    for (std::size_t i = 0; i < colour.size(); i += lanes) {
      add_batch(mass, overlaps, &colour[i], std::min<std::size_t>(lanes, colour.size() - i));
    }
  }
  for (const int& k : alone) add_batch(mass, overlaps, &k, 1);
}

void OverlapProjection::add_batch(const std::vector<Eigen::Vector3d>& mass, const std::vector<Overlap>& overlaps,
                                  const int* first, std::size_t count) {
  const int still = static_cast<int>(3 * mass.size());
  OverlapBatch& batch = batches_.emplace_back();
  batch.gap += never_closed_m;
  batch.flexibility += 1.0;
  for (OverlapBatch::End& end : batch.ends) end.first.fill(still);
  for (std::size_t lane = 0; lane < count; ++lane) {
    const Overlap& o = overlaps[at(first[lane])];
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
  return std::all_of(batches_.begin(), batches_.end(), [&](const OverlapBatch& batch) {
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
  acting_.clear();
  for (std::size_t k = 0; k < batches_.size(); ++k) {
    if (may_be_pushed(batches_[k], tolerance_m)) acting_.push_back(k);
  }
}

/// All pushes, and what they displace, by so much of what the last sweeps have changed.
void OverlapProjection::go_on(double beyond) {
  for (const std::size_t k : acting_) {
    OverlapBatch& batch = batches_[k];
    const Four now = batch.push;
    batch.push += beyond * (now - batch.push_before);
    batch.push_before = now;
  }
  for (std::size_t i = 0; i < moved_.size(); ++i) {
    const double now = moved_[i];
    moved_[i] += beyond * (now - moved_before_[i]);
    moved_before_[i] = now;
  }
}

void OverlapProjection::solve(double tolerance_m) {
  constexpr int most_sweeps = 300;  // each there and back; begun anew they would lose their momentum
  moved_before_ = moved_;
  double momentum = 1;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    const double next = (1 + std::sqrt(1 + 4 * momentum * momentum)) / 2;
    go_on((momentum - 1) / next);
    choose(tolerance_m);
    OverlapProgress progress;
    push_batches(batches_, acting_, /*back=*/false, tolerance_m / 2, moved_.data(), progress);
    last_m_ = largest(progress.largest);
    push_batches(batches_, acting_, /*back=*/true, tolerance_m / 2, moved_.data(), progress);
    if (saw_all_) {
      if (last_m_ <= tolerance_m / 2 || is_solved(tolerance_m)) return;
      std::erase_if(acting_, [&](std::size_t k) {
        const OverlapBatch& batch = batches_[k];
        return largest(batch.push) == 0 && largest(batch.push_before) == 0;
      });
    }
    momentum = progress.ahead[0] + progress.ahead[1] + progress.ahead[2] + progress.ahead[3] > 0 ? 1 : next;
  }
}

}  // namespace blockweir::solid
