// SPDX-License-Identifier: GPL-3.0-or-later
// What the processes that we have started leave behind.
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

/// Takes over what our children leave behind when they end: mpirun may be gone before its last rank is.
class Reaper {
 public:
  Reaper() {
    ::prctl(PR_GET_CHILD_SUBREAPER, &before_);
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  }
  ~Reaper() { ::prctl(PR_SET_CHILD_SUBREAPER, before_); }
  Reaper(const Reaper&) = delete;
  Reaper& operator=(const Reaper&) = delete;
  /// Returns when nothing is left; what has not ended by itself after `patience_s` is killed.
  static void reap(double patience_s) {
    for (const auto begin = std::chrono::steady_clock::now(); ::waitpid(-1, nullptr, WNOHANG) >= 0;) {
      if (seconds_since(begin) > patience_s) kill_children();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }

 private:
  static void kill_children() {
    std::ifstream children("/proc/self/task/" + std::to_string(::getpid()) + "/children");  // the leader gets them
    for (pid_t pid = 0; children >> pid;) ::kill(pid, SIGKILL);
  }
  int before_ = 0;
};

}  // namespace blockweir::process
