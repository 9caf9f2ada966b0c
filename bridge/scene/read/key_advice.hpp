// SPDX-License-Identifier: GPL-3.0-or-later
// Advice on an unknown key: the nearest known key, and its unit if only the unit is wrong.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace blockweir::scene {

struct KeyAdvice {
  std::string expected;
  std::string remedy;
};

/// `word`: the unknown key; `keys`: the known ones.
KeyAdvice key_advice(std::string_view word, const std::vector<std::string>& keys);

}  // namespace blockweir::scene
