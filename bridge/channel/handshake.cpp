// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/channel/handshake.hpp"

#include <fmt/format.h>

namespace blockweir::channel {
namespace {

const char* remedy(const wire::Hello& ours, const wire::Hello& theirs) {
  if (ours.protocol != theirs.protocol) return "; use the same version of blockweir on both sides";
  if (ours.scene_digest != theirs.scene_digest) {
    return "; the two have read different scenes: give both the same scene file and the same --set";
  }
  return ours.first_window == theirs.first_window ? "" : "; give both the same --resume";
}

}  // namespace

std::string compare(const wire::Hello& ours, const wire::Hello& theirs) {
  std::string text;
  const std::string partner = printable(theirs.role);
  const auto differ = [&](const char* what, const auto& a, const auto& b) {
    if (a == b) return;
    text += fmt::format("{}{}: {} has {}, {} has {}", text.empty() ? "" : "; ", what, ours.role, a, partner, b);
  };
  differ("protocol", ours.protocol, theirs.protocol);
  differ("units", ours.units, theirs.units);
  differ("scene digest", ours.scene_digest, theirs.scene_digest);
  differ("schedule", ours.schedule, theirs.schedule);
  differ("window_s", ours.window_s, theirs.window_s);
  differ("duration_s", ours.duration_s, theirs.duration_s);
  differ("first window", ours.first_window, theirs.first_window);
  differ("number of blocks", ours.block_names.size(), theirs.block_names.size());
  if (ours.block_names.size() != theirs.block_names.size()) return text + remedy(ours, theirs);
  for (std::size_t b = 0; b < ours.block_names.size(); ++b)
    differ("block name", ours.block_names[b], theirs.block_names[b]);
  if (ours.vertex_counts != theirs.vertex_counts || ours.vertices_m != theirs.vertices_m) {
    text += std::string(text.empty() ? "" : "; ") + "outlines of the blocks differ";
  }
  return text.empty() ? text : text + remedy(ours, theirs);
}

std::string printable(std::string name) {
  constexpr std::size_t longest = 40;
  if (name.size() > longest) name.resize(longest);
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < 0x20 || c == '"') c = '?';
  }
  return name;
}

}  // namespace blockweir::channel
