// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel loops over many blocks or contacts. Each index writes its own data and reductions do not depend on the
// order, so that any number of threads gives the same bits.
#pragma once

#include <atomic>
#include <cmath>
#include <cstddef>

namespace blockweir::solid {

/// Shorter loops are not worth waking other threads, and leave the other cores to the fluid.
constexpr std::size_t many = 4000;

/// Largest number of threads in a loop, including the caller's: OMP_NUM_THREADS, which linear algebra libraries use,
/// too; otherwise one for each core.
[[nodiscard]] std::size_t threads();
void set_threads(std::size_t count);

/// Calls work(context, first, end) for pieces of [0, count), of `piece` indices or more. TBB's threads steal pieces:
/// the caller does what no other thread has started, so that a busy core costs no time.
void share(std::size_t count, std::size_t piece, void (*work)(const void* context, std::size_t first, std::size_t end),
           const void* context);
/// The same of a few long pieces, each by the same thread in every call where cores are free: what it has written is in
/// that core's cache.
void share_by_place(std::size_t count, void (*work)(const void* context, std::size_t first, std::size_t end),
                    const void* context);

/// Calls range(first, end) for pieces of [0, count), or once for all if there are fewer than `enough`.
template <class Range>
void in_pieces(std::size_t count, const Range& range, std::size_t enough = many) {
  constexpr std::size_t pieces = 8;
  if (count < enough) return range(std::size_t{0}, count);
  const auto call = [](const void* of, std::size_t first, std::size_t end) {
    (*static_cast<const Range*>(of))(first, end);
  };
  share(count, enough / pieces, call, &range);
}

/// Calls work(i) for each i of [0, count), which are few and take long; work must not throw.
template <class Work>
void share_by_place(std::size_t count, const Work& work) {
  const auto call = [](const void* of, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) (*static_cast<const Work*>(of))(i);
  };
  share_by_place(count, call, &work);
}

/// Calls work(i) for each i of [0, count); work must not throw.
template <class Work>
void for_each(std::size_t count, const Work& work) {
  in_pieces(count, [&work](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) work(i);
  });
}

/// The same for batches of four, which take as long as four.
template <class Work>
void for_each_batch(std::size_t count, const Work& work) {
  const auto range = [&work](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) work(i);
  };
  in_pieces(count, range, many / 4);
}

/// Largest value(i), at least 0; not finite if one of them is not. Each is evaluated once.
template <class Value>
double largest(std::size_t count, const Value& value) {
  const auto exceeds = [](double a, double b) { return a > b || std::isnan(a); };
  std::atomic<double> all = 0;
  in_pieces(count, [&](std::size_t first, std::size_t end) {
    double of_piece = 0;
    for (std::size_t i = first; i < end; ++i) {
      const double v = value(i);
      if (exceeds(v, of_piece)) of_piece = v;
    }
    double so_far = all;
    while (exceeds(of_piece, so_far) && !all.compare_exchange_weak(so_far, of_piece)) {
    }
  });
  return all;
}

template <class Predicate>
bool all_of(std::size_t count, const Predicate& predicate) {
  std::atomic<bool> all = true;
  in_pieces(count, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end && all.load(std::memory_order_relaxed); ++i) {
      if (!predicate(i)) all.store(false, std::memory_order_relaxed);
    }
  });
  return all;
}

}  // namespace blockweir::solid
