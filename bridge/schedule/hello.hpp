// SPDX-License-Identifier: GPL-3.0-or-later
// The handshake message of a scene.
#pragma once

#include "bridge/scene/scene.hpp"
#include "bridge/wire/message.hpp"

namespace blockweir::schedule {

/// `first_window`: number of the first motion, above 0 in a resumed run.
wire::Hello hello(const scene::Scene& scene, const std::string& role, std::uint64_t first_window = 0);

}  // namespace blockweir::schedule
