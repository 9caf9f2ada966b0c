// SPDX-License-Identifier: GPL-3.0-or-later
// Joints that state a key themselves, so that the value of [joint] does not apply to them.
#pragma once

#include <string>
#include <vector>

namespace blockweir::scene {

/// The entries of [[joints]], [[cut]] and [[joint_set]] that state `key`, written as in settings: "joints.base",
/// "cut.lift 18", ... `text` is that of a valid scene.
std::vector<std::string> laws_that_state(const std::string& text, const std::string& key);

}  // namespace blockweir::scene
