// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/overlap_batch.hpp"

#include "bridge/results/wide_vectors.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

// All is inlined into the function that pushes, to have its instructions.

[[gnu::always_inline]] inline Four taken(const OverlapBatch::End& end, const double* displacement, int i) {
  return Four{displacement[end.first[0] + i], displacement[end.first[1] + i], displacement[end.first[2] + i],
              displacement[end.first[3] + i]};
}

[[gnu::always_inline]] inline void push(OverlapBatch& b, double aim, double* displacement, OverlapProgress& progress) {
  Four left = b.gap + aim;
  std::array<std::array<Four, 3>, 2> moved;
  for (const std::size_t e : {0, 1}) {
    for (int i = 0; i < 3; ++i) {
      moved[e][at(i)] = taken(b.ends[e], displacement, i);
      left += b.ends[e].opens[at(i)] * moved[e][at(i)];
    }
  }
  const Four wanted = b.push - left / b.flexibility;
  const Four found = wanted > Four{} ? wanted : Four{};
  const Four more = found - b.push;
  b.push = found;
  const Four change = b.flexibility * (more > Four{} ? more : -more);
  progress.largest = progress.largest > change ? progress.largest : change;
  progress.ahead -= b.flexibility * more * (found - b.push_before);
  for (const std::size_t e : {0, 1}) {
    OverlapBatch::End& end = b.ends[e];
    for (int i = 0; i < 3; ++i) {
      const Four to = moved[e][at(i)] + more * end.opens[at(i)] * end.per_mass[i < 2 ? 0 : 1];
      for (int lane = 0; lane < lanes; ++lane) displacement[end.first[at(lane)] + i] = to[lane];
    }
  }
}

}  // namespace

BLOCKWEIR_WIDE_VECTORS void push_batches(std::vector<OverlapBatch>& batches, std::span<const std::size_t> acting,
                                         double beyond, double aim, double* displacement, OverlapProgress& progress) {
  OverlapProgress so_far = progress;
  for (const std::size_t k : acting) {
    OverlapBatch& batch = batches[k];
    const Four now = batch.push;
    batch.push += beyond * (now - batch.push_before);
    batch.push_before = now;
    push(batch, aim, displacement, so_far);
  }
  progress = so_far;
}

BLOCKWEIR_WIDE_VECTORS void push_batches_back(std::vector<OverlapBatch>& batches, std::span<const std::size_t> acting,
                                              double aim, double* displacement, OverlapProgress& progress) {
  OverlapProgress so_far = progress;
  for (std::size_t k = acting.size(); k-- > 0;) push(batches[acting[k]], aim, displacement, so_far);
  progress = so_far;
}

Four gap_of(const OverlapBatch& b, const double* displacement) {
  Four gap = b.gap;
  for (const OverlapBatch::End& end : b.ends) {
    for (int i = 0; i < 3; ++i) gap += end.opens[at(i)] * taken(end, displacement, i);
  }
  return gap;
}

}  // namespace blockweir::solid
