// SPDX-License-Identifier: GPL-3.0-or-later
// What either process says of the scene at the handshake.
#pragma once

#include "bridge/scene/scene.hpp"
#include "bridge/wire/message.hpp"

namespace blockweir::schedule {

wire::Hello hello(const scene::Scene& scene, const std::string& role);

}  // namespace blockweir::schedule
