// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says when Ctrl-C (or SIGTERM) ends it.
#pragma once

#include <csignal>
#include <string>

namespace blockweir::picture {

/// During its lifetime a stop prints the text on standard error and ends the program at once, with exit status 130.
class StopMessage {
 public:
  explicit StopMessage(const std::string& text);
  ~StopMessage();
  StopMessage(const StopMessage&) = delete;
  StopMessage& operator=(const StopMessage&) = delete;

 private:
  struct sigaction interrupt_before_ {};
  struct sigaction terminate_before_ {};
};

/// During its lifetime, of milliseconds, a stop comes too late and has no effect.
class TooLateToStop {
 public:
  TooLateToStop();
  ~TooLateToStop();
  TooLateToStop(const TooLateToStop&) = delete;
  TooLateToStop& operator=(const TooLateToStop&) = delete;

 private:
  struct sigaction interrupt_before_ {};
  struct sigaction terminate_before_ {};
};

}  // namespace blockweir::picture
