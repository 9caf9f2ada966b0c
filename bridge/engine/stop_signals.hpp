// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks SIGINT and SIGTERM and delivers them through a file descriptor.
#pragma once

#include <sys/signalfd.h>
#include <unistd.h>

#include <csignal>

namespace blockweir::engine {

class StopSignals {
 public:
  StopSignals() {
    sigemptyset(&awaited_);
    for (const int signal : {SIGINT, SIGTERM}) sigaddset(&awaited_, signal);
    ::sigprocmask(SIG_BLOCK, &awaited_, &before_);
    descriptor_ = ::signalfd(-1, &awaited_, SFD_CLOEXEC | SFD_NONBLOCK);
  }
  ~StopSignals() {
    ::close(descriptor_);
    restore();
  }
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// The next signal; 0: none.
  [[nodiscard]] int next() const {
    signalfd_siginfo info{};
    return ::read(descriptor_, &info, sizeof info) == sizeof info ? static_cast<int>(info.ssi_signo) : 0;
  }
  /// Restores the previous signal mask.
  void restore() const { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t awaited_{};
  sigset_t before_{};
  int descriptor_ = -1;
};

}  // namespace blockweir::engine
