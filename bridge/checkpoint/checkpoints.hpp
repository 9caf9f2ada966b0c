// SPDX-License-Identifier: GPL-3.0-or-later
// One process's checkpoints as files. C++17: the OpenFOAM plugin includes this.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::checkpoint {

/// Files `folder`/checkpoint/ROLE-WINDOW: a line that says of what, then the state. Each is written beside the old ones
/// and then put in place, so that a crash in between leaves those; the last two are kept, since a partner may have
/// fewer. Reading checks the digest of scene and content.
class Checkpoints {
 public:
  /// `every_s` of wall time; 0: never unasked.
  Checkpoints(const std::filesystem::path& folder, std::string role, std::string scene_digest, double every_s);

  /// The period has passed since the last one, or since the start.
  [[nodiscard]] bool due() const;
  /// The state before exchange `window`. Throws std::runtime_error when it cannot be written.
  void write(std::uint64_t window, const std::string& state);
  [[nodiscard]] bool has(std::uint64_t window) const;
  /// Throws std::runtime_error, with what is wrong with the file.
  [[nodiscard]] std::string read(std::uint64_t window) const;

 private:
  [[nodiscard]] std::filesystem::path file(std::uint64_t window) const;

  std::filesystem::path folder_;
  std::string role_;
  std::string digest_;
  double every_s_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Windows that a role has checkpoints of, increasing.
std::vector<std::uint64_t> windows(const std::filesystem::path& folder, const std::string& role);

/// Removes all of a former run's.
void forget(const std::filesystem::path& folder);

}  // namespace blockweir::checkpoint
