// SPDX-License-Identifier: GPL-3.0-or-later
// A key of a scene as words at the axis of a picture.
#pragma once

#include <string>

namespace blockweir::study {

/// "joint_set.bedding.friction_angle_deg" is "joint set bedding: friction angle (deg)". What is no unit at a key's end
/// stays a word.
std::string key_label(const std::string& key);

}  // namespace blockweir::study
