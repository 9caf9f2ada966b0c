// SPDX-License-Identifier: GPL-3.0-or-later
// A short name for a text: FNV-1a, 64 bit (Fowler, Noll, Vo).
#include "bridge/scene/read/digest.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace blockweir::scene {

std::string digest(std::string_view text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return fmt::format("{:016x}", hash);
}

}  // namespace blockweir::scene
