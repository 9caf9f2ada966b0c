// SPDX-License-Identifier: GPL-3.0-or-later
// The checkpoint files of one process. C++17: the OpenFOAM plugin includes this.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::checkpoint {

/// Files `folder`/checkpoint/ROLE-WINDOW: a line that identifies the run, then the state. Each file is written under
/// another name and then renamed, so that a crash leaves the old ones. The last two are kept, since the partner may
/// have fewer. Reading checks the digests of scene and content.
class Checkpoints {
 public:
  /// `every_s` of wall time; 0: on request only.
  Checkpoints(const std::filesystem::path& folder, std::string role, std::string scene_digest, double every_s);

  /// Whether the period has passed since the last checkpoint or the start.
  [[nodiscard]] bool due() const;
  /// Writes the state before exchange `window`. Throws std::runtime_error if it cannot be written.
  void write(std::uint64_t window, const std::string& state);
  [[nodiscard]] bool has(std::uint64_t window) const;
  /// Throws std::runtime_error that says what is wrong with the file.
  [[nodiscard]] std::string read(std::uint64_t window) const;

 private:
  [[nodiscard]] std::filesystem::path file(std::uint64_t window) const;

  std::filesystem::path folder_;
  std::string role_;
  std::string digest_;
  double every_s_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Windows for which a role has checkpoints, increasing.
std::vector<std::uint64_t> windows(const std::filesystem::path& folder, const std::string& role);

/// Removes all checkpoints of a previous run.
void forget(const std::filesystem::path& folder);

}  // namespace blockweir::checkpoint
