// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/block_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/scene/at.hpp"

namespace blockweir::solid::output {

std::string block_names(const Solid& solid, const std::vector<int>& blocks) {
  constexpr std::size_t most = 4;
  const auto name = [&](std::size_t i) { return fmt::format("\"{}\"", solid.blocks()[at(blocks[i])].name); };
  if (blocks.size() == 1) return "block " + name(0);
  std::string text = "blocks " + name(0);
  const std::size_t shown = std::min(most, blocks.size());
  for (std::size_t i = 1; i < shown; ++i) text += (i + 1 == blocks.size() ? " and " : ", ") + name(i);
  return shown == blocks.size() ? text : fmt::format("{} and {} more", text, blocks.size() - shown);
}

}  // namespace blockweir::solid::output
