// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/side_by_side.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <map>
#include <stdexcept>
#include <thread>

namespace blockweir::process {
namespace {

/// SIGINT, SIGTERM and SIGCHLD wait until they are asked for.
class WaitingSignals {
 public:
  WaitingSignals() {
    sigemptyset(&awaited_);
    for (const int signal : {SIGINT, SIGTERM, SIGCHLD}) sigaddset(&awaited_, signal);
    ::sigprocmask(SIG_BLOCK, &awaited_, &before_);
  }
  ~WaitingSignals() { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }
  WaitingSignals(const WaitingSignals&) = delete;
  WaitingSignals& operator=(const WaitingSignals&) = delete;
  [[nodiscard]] int next() const { return ::sigwaitinfo(&awaited_, nullptr); }
  void restore() const { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t awaited_{};
  sigset_t before_{};
};

[[noreturn]] void become_worker(std::size_t index, const std::function<void(std::size_t)>& work, pid_t parent,
                                const WaitingSignals& signals) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);  // gone before we said so
  ::setpgid(0, 0);                          // Ctrl-C reaches the parent alone, which passes it on
  signals.restore();
  int status = 0;
  try {
    work(index);
  } catch (...) {
    status = 1;
  }
  std::fflush(nullptr);
  ::_exit(status);
}

}  // namespace

int processors() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

bool side_by_side(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t)>& ended) {
  const WaitingSignals signals;
  std::map<pid_t, std::size_t> running;
  bool stopped = false;
  for (std::size_t next = 0; !running.empty() || (next < count && !stopped);) {
    if (next < count && !stopped && running.size() < static_cast<std::size_t>(jobs)) {
      std::fflush(nullptr);  // else both would write it
      const pid_t parent = ::getpid();
      const pid_t worker = ::fork();
      if (worker == 0) become_worker(next, work, parent, signals);
      if (worker < 0 && running.empty()) {
        throw std::runtime_error(
            fmt::format("cannot start a run of the study: {}; end other programs, or raise the limit of processes "
                        "(ulimit -u)",
                        std::strerror(errno)));
      }
      if (worker > 0) running.emplace(worker, next++);
      if (worker > 0) continue;
    }
    const int signal = signals.next();
    if (signal == SIGINT || signal == SIGTERM) {
      for (const auto& [worker, index] : running) ::kill(worker, signal);
      stopped = true;
    }
    for (auto worker = running.begin(); worker != running.end();) {
      if (::waitpid(worker->first, nullptr, WNOHANG) != worker->first) {
        ++worker;
        continue;
      }
      const std::size_t index = worker->second;
      worker = running.erase(worker);
      ended(index);
    }
  }
  return !stopped;
}

}  // namespace blockweir::process
