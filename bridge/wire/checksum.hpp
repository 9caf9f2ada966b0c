// SPDX-License-Identifier: GPL-3.0-or-later
// A sum over bytes: against damage on the way or on disk, not against forgery, which keys are for. C++17.
#pragma once

#include <cstddef>
#include <cstdint>

namespace blockweir::wire {

/// XXH3, 64 bit: the same number on every machine, at the speed of its memory.
std::uint64_t checksum(const void* data, std::size_t size);

}  // namespace blockweir::wire
