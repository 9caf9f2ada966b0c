// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of a fluid that uses the C interface, for the run's profile. C++17.
#pragma once

#include "bridge/channel/channel.hpp"

#include <chrono>

namespace blockweir::kit {

class FluidReport {
 public:
  void begin_step() { since_ = std::chrono::steady_clock::now(); }
  void end_step() {
    step_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - since_).count();
    ++answers_;
  }
  /// Writes the file named by BLOCKWEIR_REPORT, if that is set. Throws std::runtime_error if it cannot be written.
  void write(const channel::Channel& line) const;

 private:
  std::chrono::steady_clock::time_point since_;
  double step_s_ = 0;
  long answers_ = 0;
};

}  // namespace blockweir::kit
