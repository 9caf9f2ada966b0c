// SPDX-License-Identifier: GPL-3.0-or-later
// SIGINT and SIGTERM as a flag that whoever waits looks at.
#include <csignal>

#include "bridge/channel/channel.hpp"

namespace blockweir::channel {
namespace {

volatile std::sig_atomic_t stop_flag = 0;

extern "C" void raise_flag(int /*signal*/) {
  stop_flag = 1;
}

}  // namespace

void catch_stop_signals() {
  struct sigaction action = {};
  action.sa_handler = raise_flag;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool stop_requested() {
  return stop_flag != 0;
}

}  // namespace blockweir::channel
