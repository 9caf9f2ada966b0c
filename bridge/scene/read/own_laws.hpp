// SPDX-License-Identifier: GPL-3.0-or-later
// Which joints state a key themselves, so that [joint] does not decide it for them.
#pragma once

#include <string>
#include <vector>

namespace blockweir::scene {

/// "joints.base", "cut.lift 18", ...: the entries of [[joints]], [[cut]] and [[joint_set]] that state `key`, as
/// settings name them. `text` is a sound scene's.
std::vector<std::string> laws_that_state(const std::string& text, const std::string& key);

}  // namespace blockweir::scene
