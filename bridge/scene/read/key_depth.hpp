// SPDX-License-Identifier: GPL-3.0-or-later
// Depth of the dotted keys of a TOML text, checked before parsing: the parser frees its tables recursively, so that a
// key of 100,000 parts would exhaust the stack.
#pragma once

#include <string_view>

namespace blockweir::scene {

struct DeepKey {
  int parts = 1;
  int line = 1;
};

/// The key with the most parts ("a.b.c" has three). Dots in strings, comments and numbers do not count.
DeepKey deepest_key(std::string_view toml);

}  // namespace blockweir::scene
