// SPDX-License-Identifier: GPL-3.0-or-later
// Files of a queue's tasks: all items in one file; answers in files that are complete or absent. An answer is
// identified by its item's digest, so that it counts once even if several tasks have worked on the item.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "bridge/engine/batch_size.hpp"
#include "bridge/engine/engine.hpp"

namespace blockweir::engine {

/// A digest of everything that decides the answer, for each item of the work.
std::vector<std::string> digests_of(const Work& work);

struct Answers {
  std::map<std::string, nlohmann::json> by_digest;
  Effort effort;      ///< of finished tasks
  Measured measured;  ///< of finished tasks
};

class BatchFiles {
 public:
  explicit BatchFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// Divides the items into tasks of `batch`. Throws std::runtime_error if they cannot be written.
  void write(const nlohmann::json& common, std::size_t batch, const std::vector<std::string>& digests,
             const std::vector<nlohmann::json>& items) const;
  struct Task {
    nlohmann::json common;
    std::vector<std::string> digests;
    std::vector<nlohmann::json> items;
  };
  /// Throws std::runtime_error if there is no such task.
  [[nodiscard]] Task read(int task) const;

  /// Writes answers into a new file `name` in one operation.
  void leave(const std::string& name, const Answers& answers) const;
  /// Reads the files whose names start with `prefix` and that are not in `seen`, and adds them there.
  [[nodiscard]] Answers take(std::set<std::string>& seen, const std::string& prefix = "") const;

 private:
  std::filesystem::path folder_;
};

}  // namespace blockweir::engine
