// SPDX-License-Identifier: GPL-3.0-or-later
// One bar with level and largest displacement on a terminal, plain lines in a pipe.
#pragma once

#include <string>

namespace blockweir::launch {

class Progress {
 public:
  /// Reads lines "time_s level_m largest_displacement_m" from `fd`, which does not block.
  Progress(int fd, double duration_s, bool quiet);
  /// Shows what has come since the last call; true once anything has.
  bool update();
  /// Clears the bar.
  void finish() const;

 private:
  void show(double time_s, double level_m, double displacement_m);

  int fd_;
  double duration_s_;
  bool quiet_;
  bool terminal_;
  int shown_tenths_ = 0;
  bool begun_ = false;
  std::string pending_;
};

}  // namespace blockweir::launch
