// SPDX-License-Identifier: GPL-3.0-or-later
// Progress of a run: one bar with level and largest displacement on a terminal, lines in a pipe.
#pragma once

#include <string>

namespace blockweir::process {

class Progress {
 public:
  /// Reads lines "settling SOLUTIONS", then "time_s level_m largest_displacement_m" and, in windows that take long,
  /// "solving WINDOW time_s SOLUTIONS" from `fd`, which must not block.
  Progress(int fd, double duration_s, bool quiet);
  /// Shows what has arrived since the last call; true once the structure has settled.
  bool update();
  /// Clears the bar.
  void finish() const;

 private:
  void show(double time_s, double level_m, double displacement_m);
  /// Shows the progress of work that has solved so many linear systems, described by `words`.
  void show_solutions(const std::string& words, long solutions);

  int fd_;
  double duration_s_;
  bool quiet_;
  bool terminal_;
  int shown_tenths_ = 0;
  static constexpr long first_solutions = 100;
  long next_solutions_ = first_solutions;  ///< solutions at which the next line is printed in a pipe, doubled each time
  unsigned long window_ = 0;               ///< the window that they belong to
  bool begun_ = false;
  std::string pending_;
};

}  // namespace blockweir::process
