// SPDX-License-Identifier: GPL-3.0-or-later
// How many samples a random test takes.
#pragma once

namespace blockweir::test {

/// All; a tenth under sanitizers, which find a fault of memory in any of them and take thirty times as long.
constexpr int samples(int all) {
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
  return all < 20 ? 2 : all / 10;
#endif
#endif
  return all;
}

}  // namespace blockweir::test
