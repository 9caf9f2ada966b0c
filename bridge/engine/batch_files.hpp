// SPDX-License-Identifier: GPL-3.0-or-later
// What a queue's tasks read and leave: items in one file, answers in files that are whole or not there. An answer is
// known by the digest of its item, so that it counts once, whoever did it and how often.
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

/// Of what decides the answer of each item of the work.
std::vector<std::string> digests_of(const Work& work);

struct Answers {
  std::map<std::string, nlohmann::json> by_digest;
  Effort effort;      ///< of tasks that have come to their end
  Measured measured;  ///< the same
};

class BatchFiles {
 public:
  explicit BatchFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// Items in tasks of `batch`. Throws std::runtime_error where they cannot be written.
  void write(const nlohmann::json& common, std::size_t batch, const std::vector<std::string>& digests,
             const std::vector<nlohmann::json>& items) const;
  struct Task {
    nlohmann::json common;
    std::vector<std::string> digests;
    std::vector<nlohmann::json> items;
  };
  /// Throws std::runtime_error where there is no such task.
  [[nodiscard]] Task read(int task) const;

  /// Puts answers into a file of their own, in one go. `name`: of no other file.
  void leave(const std::string& name, const Answers& answers) const;
  /// Of the files that are not in `seen` yet, which grows by them. `prefix`: of their names.
  [[nodiscard]] Answers take(std::set<std::string>& seen, const std::string& prefix = "") const;

 private:
  std::filesystem::path folder_;
};

}  // namespace blockweir::engine
