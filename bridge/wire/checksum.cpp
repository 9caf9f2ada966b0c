// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/wire/checksum.hpp"

#ifdef __x86_64__
#include <xxh_x86dispatch.h>  // its widest vectors are found when the program runs
#else
#include <xxhash.h>
#endif

namespace blockweir::wire {

std::uint64_t checksum(const void* data, std::size_t size, std::uint64_t seed) {
  return XXH3_64bits_withSeed(data, size, seed);
}

Checksum::Checksum() : state_(XXH3_createState()) {
  XXH3_64bits_reset(state_.get());
}

void Checksum::add(const void* data, std::size_t size) {
  XXH3_64bits_update(state_.get(), data, size);
}

std::uint64_t Checksum::value() const {
  return XXH3_64bits_digest(state_.get());
}

void Checksum::Free::operator()(XXH3_state_s* state) const {
  XXH3_freeState(state);
}

}  // namespace blockweir::wire
