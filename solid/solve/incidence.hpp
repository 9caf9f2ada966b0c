// SPDX-License-Identifier: GPL-3.0-or-later
// Lists the interactions of each block, so that each block can sum its own in a fixed order on any thread.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace blockweir::solid {

class Incidence {
 public:
  /// One of the two ends of an interaction.
  struct End {
    int interaction;
    bool second;
  };

  Incidence() = default;
  /// `ends[k]`: the two blocks of interaction k; -1: fixed.
  Incidence(std::size_t blocks, const std::vector<std::pair<int, int>>& ends) : first_(blocks + 1) {
    const auto each = [&](const auto& visit) {
      for (std::size_t k = 0; k < ends.size(); ++k) {
        if (ends[k].first >= 0) visit(static_cast<std::size_t>(ends[k].first), End{static_cast<int>(k), false});
        if (ends[k].second >= 0) visit(static_cast<std::size_t>(ends[k].second), End{static_cast<int>(k), true});
      }
    };
    each([&](std::size_t block, End) { ++first_[block + 1]; });
    for (std::size_t b = 0; b < blocks; ++b) first_[b + 1] += first_[b];
    ends_.resize(first_[blocks]);
    std::vector<std::size_t> next = first_;
    each([&](std::size_t block, End end) { ends_[next[block]++] = end; });
  }

  /// The ends of a block, by increasing interactions.
  [[nodiscard]] std::span<const End> of(std::size_t block) const {
    return {ends_.data() + first_[block], first_[block + 1] - first_[block]};
  }

 private:
  std::vector<std::size_t> first_;  ///< index of each block's first end
  std::vector<End> ends_;
};

}  // namespace blockweir::solid
