// SPDX-License-Identifier: GPL-3.0-or-later
// A sum over a message's bytes: against damage on the way, not against forgery, which keys are for. C++17.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace blockweir::wire {

/// Eight lanes, so that a processor multiplies them at once. Each step is one-to-one: a change of one word always
/// shows.
inline std::uint64_t checksum(const void* data, std::size_t size) {
  constexpr std::uint64_t odd = 0x9e3779b185ebca87U;
  const auto mix = [](std::uint64_t lane, std::uint64_t word) {
    const std::uint64_t x = lane ^ word;
    return ((x << 31U) | (x >> 33U)) * odd;
  };
  std::array<std::uint64_t, 8> lanes = {1, 2, 3, 4, 5, 6, 7, 8};
  const auto* at = static_cast<const unsigned char*>(data);
  std::size_t left = size;
  for (; left >= 64; at += 64, left -= 64) {
    std::array<std::uint64_t, 8> words;
    std::memcpy(words.data(), at, 64);
    for (std::size_t i = 0; i < 8; ++i) lanes[i] = mix(lanes[i], words[i]);
  }
  std::array<std::uint64_t, 8> rest = {};
  if (left > 0) std::memcpy(rest.data(), at, left);
  std::uint64_t sum = size;
  for (std::size_t i = 0; i < 8; ++i) sum = mix(sum, mix(lanes[i], rest[i]));
  return sum;
}

}  // namespace blockweir::wire
