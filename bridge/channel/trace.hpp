// SPDX-License-Identifier: GPL-3.0-or-later
// When a side waited for the other and when it sent, for "blockweir trace". C++17: the OpenFOAM plugin includes this.
#pragma once

#include <chrono>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>

namespace blockweir::channel {

/// Lines "what,window,from_ns,to_ns" of a file ROLE.csv in the folder that the environment names in BLOCKWEIR_TRACE.
/// The clock is that of the machine since its start (CLOCK_MONOTONIC), which its processes share.
class Trace {
 public:
  using Clock = std::chrono::steady_clock;

  /// Null where the environment has no such folder, or the file cannot be written: a run does without.
  static std::unique_ptr<Trace> of(const std::string& role);

  explicit Trace(std::ofstream stream) : stream_(std::move(stream)) {}

  /// What was done for the message of `window`: "wait", "send".
  void add(const char* what, std::uint64_t window, Clock::time_point from, Clock::time_point to);

 private:
  std::ofstream stream_;
};

}  // namespace blockweir::channel
