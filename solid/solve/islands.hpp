// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of blocks connected by contacts (islands); each is solved separately.
#pragma once

#include <utility>
#include <vector>

namespace blockweir::solid {

struct Island {
  std::vector<int> blocks;                   ///< global indices, increasing
  std::vector<int> contacts;                 ///< indices into the step's contacts
  std::vector<int> supports;                 ///< indices into the model's supports
  std::vector<std::pair<int, int>> couples;  ///< local indices of block pairs in contact, lower first, each once

  /// Does nothing touch or hold its blocks?
  [[nodiscard]] bool is_free() const { return contacts.empty() && supports.empty(); }
  [[nodiscard]] bool is_one_free() const { return is_free() && blocks.size() == 1; }
};

/// `links[k]` = the two blocks of contact k; `support_blocks[k]` the block of support k. `joined`: pairs of moving
/// blocks that are connected without a contact. Fixed blocks connect nothing. Every moving block is in exactly one
/// island. Islands are ordered by their first block.
std::vector<Island> find_islands(const std::vector<bool>& fixed, const std::vector<std::pair<int, int>>& links,
                                 const std::vector<int>& support_blocks,
                                 const std::vector<std::pair<int, int>>& joined = {});

/// All islands as one, to be solved together.
Island join(const std::vector<Island>& islands);

}  // namespace blockweir::solid
