// SPDX-License-Identifier: GPL-3.0-or-later
// The materials, blocks or joints of a scene by name, in the order of the file.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

namespace blockweir::scene {

class Names {
 public:
  /// `kind` is how messages call one of them: "block".
  explicit Names(std::string kind) : kind_(std::move(kind)) {}

  /// False when the name was there before; it still takes the next index, which then cannot be found by name.
  bool add(const std::string& name) {
    list_.push_back(name);
    return index_.emplace(name, static_cast<int>(list_.size()) - 1).second;
  }
  /// -1 where there is none.
  [[nodiscard]] int find(const std::string& name) const {
    const auto found = index_.find(name);
    return found == index_.end() ? -1 : found->second;
  }
  [[nodiscard]] const std::vector<std::string>& list() const { return list_; }
  [[nodiscard]] const std::string& kind() const { return kind_; }

 private:
  std::string kind_;
  std::vector<std::string> list_;
  std::unordered_map<std::string, int> index_;
};

}  // namespace blockweir::scene
