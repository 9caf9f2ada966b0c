// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that fall from the start, whatever the water does: nothing holds them where the scene draws them.
#pragma once

#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// By what is no block: by being fixed, by a support, a bolt to the ground, a viscous boundary, or by water that is
/// heavier.
std::vector<bool> held_by_themselves(const Scene& scene);

/// Those that neither touch a held block, directly or through others, nor are held themselves: by being fixed, by a
/// support, a bolt to the ground, a viscous boundary, or by water that is heavier. Blocks touch within the failure
/// displacement, but over a gap beside them, which does not hold them. Empty without gravity.
std::vector<int> blocks_not_held(const Scene& scene);

/// The same, but empty where nothing that can move is held: a scene that only falls is judged.
std::vector<int> loose_blocks(const Scene& scene);

/// "2 blocks ("a" and "b") fall from the start"; of many the first few.
std::string loose_text(const Scene& scene, const std::vector<int>& loose);

/// Holds the scene's loose blocks where they are drawn, so that what is asked of a scene at rest is asked of the
/// others. Returns a warning that names them; empty where there are none.
std::string hold_loose_blocks(Scene& scene);

}  // namespace blockweir::scene
