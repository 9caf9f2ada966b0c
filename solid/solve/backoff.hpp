// SPDX-License-Identifier: GPL-3.0-or-later
// Tries that cost time and fail in rows: after one that fails the next ones are left out, each time twice as many.
#pragma once

#include <algorithm>

namespace blockweir::solid {

class Backoff {
 public:
  /// Is the try at hand left out?
  bool skips() { return left_ > 0 && left_-- > 0; }
  void failed() {
    constexpr int longest = 64;
    left_ = next_;
    next_ = std::min(longest, 2 * next_);
  }
  /// Since the last success.
  [[nodiscard]] bool after_failure() const { return next_ > 1; }
  void succeeded() { *this = {}; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(left_, next_);
  }

 private:
  int left_ = 0;
  int next_ = 1;
};

}  // namespace blockweir::solid
