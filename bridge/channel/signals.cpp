// SPDX-License-Identifier: GPL-3.0-or-later
// SIGINT and SIGTERM as a count that whoever waits looks at; a pipe that nobody reads ends nothing.
#include <csignal>

#include "bridge/channel/channel.hpp"

namespace blockweir::channel {
namespace {

volatile std::sig_atomic_t stop_count = 0;

extern "C" void count_signal(int /*signal*/) {
  stop_count = stop_count + 1;
}

}  // namespace

void catch_stop_signals() {
  struct sigaction action = {};
  action.sa_handler = count_signal;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);  // whoever read our progress may be gone before we are asked to stop
}

bool stop_requested() {
  return stop_count > 0;
}

bool stop_requested_twice() {
  return stop_count > 1;
}

}  // namespace blockweir::channel
