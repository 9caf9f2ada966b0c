// SPDX-License-Identifier: GPL-3.0-or-later
// Index of the scene's materials, blocks or joints by name, in the order of the file.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

namespace blockweir::scene {

class Names {
 public:
  /// `kind`: the word for one of them in messages, e.g. "block".
  explicit Names(std::string kind) : kind_(std::move(kind)) {}

  /// False if the name exists already; the entry still takes the next index, but cannot be found by name.
  bool add(const std::string& name) {
    list_.push_back(name);
    return index_.emplace(name, static_cast<int>(list_.size()) - 1).second;
  }
  /// -1 if there is none.
  [[nodiscard]] int find(const std::string& name) const {
    const auto found = index_.find(name);
    return found == index_.end() ? -1 : found->second;
  }
  [[nodiscard]] const std::vector<std::string>& list() const { return list_; }
  /// Some names are missing because what makes them is wrong: a name that is not found may be one of them.
  void set_incomplete() { complete_ = false; }
  [[nodiscard]] bool complete() const { return complete_; }
  [[nodiscard]] const std::string& kind() const { return kind_; }

 private:
  std::string kind_;
  std::vector<std::string> list_;
  std::unordered_map<std::string, int> index_;
  bool complete_ = true;
};

}  // namespace blockweir::scene
