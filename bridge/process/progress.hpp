// SPDX-License-Identifier: GPL-3.0-or-later
// One bar with level and largest displacement on a terminal, plain lines in a pipe.
#pragma once

#include <string>

namespace blockweir::process {

class Progress {
 public:
  /// Reads lines "settling SOLUTIONS", then "time_s level_m largest_displacement_m" and, within windows that take long,
  /// "solving WINDOW time_s SOLUTIONS" from `fd`, which does not block.
  Progress(int fd, double duration_s, bool quiet);
  /// Shows what has come since the last call; true once the structure has settled.
  bool update();
  /// Clears the bar.
  void finish() const;

 private:
  void show(double time_s, double level_m, double displacement_m);
  /// How far something has come that takes `solutions` of linear systems so far, told of in `words`.
  void show_solutions(const std::string& words, long solutions);

  int fd_;
  double duration_s_;
  bool quiet_;
  bool terminal_;
  int shown_tenths_ = 0;
  static constexpr long first_solutions = 100;
  long next_solutions_ = first_solutions;  ///< that a line in a pipe tells, twice as many each time
  unsigned long window_ = 0;               ///< that they are of
  bool begun_ = false;
  std::string pending_;
};

}  // namespace blockweir::process
