// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a frame from the solid's state.
#pragma once

#include "bridge/wire/message.hpp"
#include "solid/step/solid.hpp"
#include "solid/watch/frame.hpp"

namespace blockweir::solid {

/// Converts a load message to the solid's panels. Throws std::runtime_error for an edge that the scene does not have.
std::vector<Panel> panels_of(const wire::Load& load, const Solid& solid);

/// Fills `frame` for `time_s` under a load and its panels; its storage is reused.
void make_frame(const Solid& solid, const wire::Load& load, const std::vector<Panel>& panels, double time_s,
                Frame& frame);

}  // namespace blockweir::solid
