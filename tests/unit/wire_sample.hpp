// SPDX-License-Identifier: GPL-3.0-or-later
// A load, and a message as it goes over the line.
#pragma once

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "bridge/wire/codec.hpp"

namespace blockweir::wire {

/// What goes over the line.
template <class Message>
struct Sent {
  explicit Sent(const Message& message) { encode(message, builder, parts); }
  [[nodiscard]] Part frame(Keeper keeper = nullptr) const {
    return {builder.GetBufferPointer(), builder.GetSize(), std::move(keeper)};
  }
  flatbuffers::FlatBufferBuilder builder;
  std::vector<Part> parts;
};

inline Load sample_load() {
  return {.window = 17,
          .time_s = 0.17,
          .holds_until_s = std::numeric_limits<double>::infinity(),
          .upstream_level_m = 22,
          .downstream_level_m = std::nan(""),
          .block = {1, 2},
          .edge = {3, 0},
          .s_from = {0, 0.25},
          .s_to = {0.5, 1},
          .pressure_from_pa = {1e4, 2e4},
          .pressure_to_pa = {3e4, 0},
          .cracks_from = 1,
          .breached = true,
          .added_mass = {{}, {4e4, -1, 2e5, 3e3, 0.5, 1e6}}};
}

}  // namespace blockweir::wire
