// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/row_batch.hpp"

#include "bridge/results/wide_vectors.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

// All is inlined into the function that sweeps, to have its instructions.

[[gnu::always_inline]] inline Four magnitude(const Four& x) {
  return x < Four{} ? -x : x;
}

[[gnu::always_inline]] inline Four larger(const Four& a, const Four& b) {
  return a > b ? a : b;
}

[[gnu::always_inline]] inline Four taken(const BatchEnd& end, const double* displacement, int i) {
  return Four{displacement[end.first[0] + i], displacement[end.first[1] + i], displacement[end.first[2] + i],
              displacement[end.first[3] + i]};
}

/// What displacements add to gaps and slips. `count`: unknowns of the end, or 0 where they are to be looked up.
template <int count>
[[gnu::always_inline]] inline void look(const BatchEnd& end, const BatchEntry* entries, const double* displacement,
                                        Four* moved, Four& gap, Four& slip) {
  const int n = count > 0 ? count : end.count;
  for (int i = 0; i < n; ++i) {
    moved[i] = taken(end, displacement, i);
    gap += entries[i].of * moved[i];
    slip += entries[n + i].of * moved[i];
  }
}

template <int count>
[[gnu::always_inline]] inline void act(const BatchEnd& end, const BatchEntry* entries, const Four& normal,
                                       const Four& shear, Four* moved, double* displacement) {
  const int n = count > 0 ? count : end.count;
  for (int i = 0; i < n; ++i) {
    moved[i] += normal * entries[2 * n + i].of + shear * entries[3 * n + i].of;
    for (int lane = 0; lane < lanes; ++lane) displacement[end.first[at(lane)] + i] = moved[i][lane];
  }
}

template <int first, int second, bool dry>
[[gnu::always_inline]] inline void visit(RowBatch& b, const BatchEntry* entries, double by, double part,
                                         double* displacement, BatchProgress& progress) {
  const BatchEntry* of_first = entries + b.ends[0].first_entry;
  const BatchEntry* of_second = entries + b.ends[1].first_entry;
  const Four normal = b.normal + by * (b.normal - b.normal_before);
  const Four shear = b.shear + by * (b.shear - b.shear_before);
  Four gap = b.gap - (b.gap_by_normal * normal + b.gap_by_shear * shear);
  Four slip = b.slip - (b.gap_by_shear * normal + b.slip_by_shear * shear);
  Four moved_first[most_unknowns];
  Four moved_second[most_unknowns];
  look<first>(b.ends[0], of_first, displacement, moved_first, gap, slip);
  look<second>(b.ends[1], of_second, displacement, moved_second, gap, slip);
  const auto found = b.forces.at<dry>(gap, slip);
  const Four more_normal = part * (found.normal - normal);
  const Four more_shear = part * (found.shear - shear);
  act<first>(b.ends[0], of_first, more_normal, more_shear, moved_first, displacement);
  act<second>(b.ends[1], of_second, more_normal, more_shear, moved_second, displacement);
  if (part == 1) {
    b.normal_before = b.normal;
    b.shear_before = b.shear;
  }
  b.normal = normal + more_normal;
  b.shear = shear + more_shear;
  b.slips = found.slips;
  progress.ahead -= b.gap_by_normal * more_normal * (b.normal - b.normal_before) +
                    b.slip_by_shear * more_shear * (b.shear - b.shear_before);
  progress.largest =
      larger(progress.largest, larger(magnitude(b.gap_by_normal * more_normal + b.gap_by_shear * more_shear),
                                      magnitude(b.gap_by_shear * more_normal + b.slip_by_shear * more_shear)));
}

/// Of rigid blocks that have come loose, most of what is swept.
[[gnu::always_inline]] inline bool is_loose(const RowBatch& b) {
  return b.ends[0].count == 3 && b.ends[1].count == 3 && b.dry;
}

}  // namespace

// A loop for each kind: what both would keep in registers are too many for one.
BLOCKWEIR_WIDE_VECTORS void sweep_batches(std::span<RowBatch> batches, const std::vector<BatchEntry>& entries,
                                          double by, double part, double* displacement, BatchProgress& progress) {
  const BatchEntry* const all = entries.data();
  const auto end = batches.end();
  BatchProgress so_far;
  for (auto b = batches.begin(); b != end;) {
    for (; b != end && is_loose(*b); ++b) visit<3, 3, true>(*b, all, by, part, displacement, so_far);
    for (; b != end && !is_loose(*b); ++b) visit<0, 0, false>(*b, all, by, part, displacement, so_far);
  }
  progress = so_far;
}

}  // namespace blockweir::solid
