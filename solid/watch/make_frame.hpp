// SPDX-License-Identifier: GPL-3.0-or-later
// A frame from the solid's state.
#pragma once

#include "bridge/wire/message.hpp"
#include "solid/step/solid.hpp"
#include "solid/watch/frame.hpp"

namespace blockweir::solid {

/// Panels of a load message as the solid's own. Throws std::runtime_error for an edge that the scene does not describe.
std::vector<Panel> panels_of(const wire::Load& load, const Solid& solid);

/// The moment `time_s` under a load and its panels; storage of `frame` is reused.
void make_frame(const Solid& solid, const wire::Load& load, const std::vector<Panel>& panels, double time_s,
                Frame& frame);

}  // namespace blockweir::solid
