// SPDX-License-Identifier: GPL-3.0-or-later
// Records when a side waited and when it sent, for "blockweir trace". C++17: the OpenFOAM plugin includes this.
#pragma once

#include <chrono>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>

namespace blockweir::channel {

/// Lines "what,window,from_ns,to_ns" in a file ROLE.csv, in the folder of the environment variable BLOCKWEIR_TRACE. The
/// clock is CLOCK_MONOTONIC, which all processes of a machine share.
class Trace {
 public:
  using Clock = std::chrono::steady_clock;

  /// Null without such a folder, or if the file cannot be written: the run continues without it.
  static std::unique_ptr<Trace> of(const std::string& role);

  explicit Trace(std::ofstream stream) : stream_(std::move(stream)) {}

  /// Records "wait" or "send" for the message of `window`.
  void add(const char* what, std::uint64_t window, Clock::time_point from, Clock::time_point to);

 private:
  std::ofstream stream_;
};

}  // namespace blockweir::channel
