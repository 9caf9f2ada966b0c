// SPDX-License-Identifier: GPL-3.0-or-later
// Ends processes that our children leave behind.
#pragma once

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>

#include "bridge/results/seconds.hpp"

namespace blockweir::process {

/// Adopts the processes that our children leave behind when they end: mpirun may end before its last rank.
class Reaper {
 public:
  Reaper() {
    ::prctl(PR_GET_CHILD_SUBREAPER, &before_);
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  }
  ~Reaper() { ::prctl(PR_SET_CHILD_SUBREAPER, before_); }
  Reaper(const Reaper&) = delete;
  Reaper& operator=(const Reaper&) = delete;
  /// Returns when none is left; those that do not end by themselves within `patience_s` are killed.
  static void reap(double patience_s) {
    for (const auto begin = std::chrono::steady_clock::now(); ::waitpid(-1, nullptr, WNOHANG) >= 0;) {
      if (seconds_since(begin) > patience_s) kill_children();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }

 private:
  static void kill_children() {
    std::ifstream children("/proc/self/task/" + std::to_string(::getpid()) + "/children");  // orphans, too
    for (pid_t pid = 0; children >> pid;) ::kill(pid, SIGKILL);
  }
  int before_ = 0;
};

}  // namespace blockweir::process
