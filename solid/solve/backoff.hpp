// SPDX-License-Identifier: GPL-3.0-or-later
// Exponential backoff: after each failure of an expensive attempt, twice as many of the next attempts are skipped.
#pragma once

#include <algorithm>

namespace blockweir::solid {

class Backoff {
 public:
  /// Whether to skip this attempt.
  bool skips() { return left_ > 0 && left_-- > 0; }
  void failed() {
    constexpr int longest = 64;
    left_ = next_;
    next_ = std::min(longest, 2 * next_);
  }
  /// Whether there was a failure since the last success.
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
