// SPDX-License-Identifier: GPL-3.0-or-later
// One bar with level and largest displacement on a terminal, plain lines in a pipe.
#pragma once

#include <string>

namespace blockweir::launch {

class Progress {
 public:
  /// Reads lines "settling SOLUTIONS", then "time_s level_m largest_displacement_m" from `fd`, which does not block.
  Progress(int fd, double duration_s, bool quiet);
  /// Shows what has come since the last call; true once the structure has settled.
  bool update();
  /// Clears the bar.
  void finish() const;

 private:
  void show(double time_s, double level_m, double displacement_m);
  void show_settling(long solutions);

  int fd_;
  double duration_s_;
  bool quiet_;
  bool terminal_;
  int shown_tenths_ = 0;
  long next_solutions_ = 100;  ///< of linear systems, that a line in a pipe tells
  bool begun_ = false;
  std::string pending_;
};

}  // namespace blockweir::launch
