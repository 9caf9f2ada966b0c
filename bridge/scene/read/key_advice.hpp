// SPDX-License-Identifier: GPL-3.0-or-later
// What to say of a key that does not exist: the nearest one, and its unit where only the unit is wrong.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace blockweir::scene {

struct KeyAdvice {
  std::string expected;
  std::string remedy;
};

/// `word` is what was found, `keys` what may stand there.
KeyAdvice key_advice(std::string_view word, const std::vector<std::string>& keys);

}  // namespace blockweir::scene
