// SPDX-License-Identifier: GPL-3.0-or-later
// A sum over bytes: against damage on the way or on disk, not against forgery, which keys are for. C++17.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

struct XXH3_state_s;

namespace blockweir::wire {

/// XXH3, 64 bit: the same number on every machine, at the speed of its memory. Of the bytes, and of `seed`.
std::uint64_t checksum(const void* data, std::size_t size, std::uint64_t seed = 0);

/// The same of bytes that are added piece by piece, with seed 0.
class Checksum {
 public:
  Checksum();
  void add(const void* data, std::size_t size);
  [[nodiscard]] std::uint64_t value() const;

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, Free> state_;
};

}  // namespace blockweir::wire
