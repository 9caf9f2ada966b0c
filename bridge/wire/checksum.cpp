// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/wire/checksum.hpp"

#ifdef __x86_64__
#include <xxh_x86dispatch.h>  // its widest vectors are found when the program runs
#else
#include <xxhash.h>
#endif

namespace blockweir::wire {

std::uint64_t checksum(const void* data, std::size_t size) {
  return XXH3_64bits(data, size);
}

}  // namespace blockweir::wire
