// SPDX-License-Identifier: GPL-3.0-or-later
// Counts SIGINT and SIGTERM for waiting loops to check; ignores SIGPIPE.
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>

#include "bridge/channel/channel.hpp"

namespace blockweir::channel {
namespace {

volatile std::sig_atomic_t stop_count = 0;

/// The process that had the kernel signal us when it ends; 0: none.
volatile pid_t launcher = 0;
constexpr unsigned patience_s = 5;

/// A launcher asks a second time, and kills who does not hear that either. One that is gone does neither: then alarms
/// do.
extern "C" void count_signal(int signal) {
  stop_count = stop_count + 1;
  if (launcher == 0 || ::getppid() == launcher) return;
  if (signal == SIGALRM) std::signal(SIGALRM, SIG_DFL);
  ::alarm(patience_s);
}

}  // namespace

void catch_stop_signals() {
  struct sigaction action = {};
  action.sa_handler = count_signal;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  int at_its_end = 0;
  ::prctl(PR_GET_PDEATHSIG, &at_its_end);
  if (at_its_end != 0) {
    launcher = ::getppid();
    sigaction(SIGALRM, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN);  // whoever read our progress may be gone before we are asked to stop
}

bool stop_requested() {
  return stop_count > 0;
}

bool stop_requested_twice() {
  return stop_count > 1;
}

}  // namespace blockweir::channel
