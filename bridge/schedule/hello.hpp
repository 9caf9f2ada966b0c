// SPDX-License-Identifier: GPL-3.0-or-later
// What either process says of the scene at the handshake.
#pragma once

#include "bridge/scene/scene.hpp"
#include "bridge/wire/message.hpp"

namespace blockweir::schedule {

/// `first_window`: the motion that a run is resumed with.
wire::Hello hello(const scene::Scene& scene, const std::string& role, std::uint64_t first_window = 0);

}  // namespace blockweir::schedule
