// SPDX-License-Identifier: GPL-3.0-or-later
// Which keys two scenes have otherwise.
#pragma once

#include <string>
#include <vector>

namespace blockweir::scene {

/// A key as --set takes it, and its value in either scene; "none" where it is absent.
struct Difference {
  std::string key;
  std::string before;
  std::string now;
};

/// In the order of the keys; empty if the texts differ in comments and layout alone. Texts that are not TOML differ in
/// one key without a name.
std::vector<Difference> differences(const std::string& before, const std::string& now);

/// The first of them in words, those that `overrides` (--set) state marked: "joint.cohesion_pa is 0 there and 1e5 here
/// (--set)".
std::string differences_text(const std::string& before, const std::string& now,
                             const std::vector<std::string>& overrides);

}  // namespace blockweir::scene
