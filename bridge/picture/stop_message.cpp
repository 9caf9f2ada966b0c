// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/stop_message.hpp"

#include <unistd.h>

#include "bridge/process/stopped.hpp"
#include "bridge/results/wrapped.hpp"

namespace blockweir::picture {

namespace {

std::string said_at_once;  // of the one StopMessage; the handler may not allocate

extern "C" void say_and_end(int /*signal*/) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, said_at_once.data(), said_at_once.size());
  ::_exit(process::stopped_status);
}

void handle_stops(void (*handler)(int), struct sigaction& interrupt_before, struct sigaction& terminate_before) {
  struct sigaction action = {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  ::sigaction(SIGINT, &action, &interrupt_before);
  ::sigaction(SIGTERM, &action, &terminate_before);
}

void restore_stops(const struct sigaction& interrupt_before, const struct sigaction& terminate_before) {
  ::sigaction(SIGINT, &interrupt_before, nullptr);
  ::sigaction(SIGTERM, &terminate_before, nullptr);
}

}  // namespace

StopMessage::StopMessage(const std::string& text) {
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  said_at_once = (terminal ? "\r\033[K" : "") + results::for_stderr(text + "\n");  // takes the place of a progress bar
  handle_stops(say_and_end, interrupt_before_, terminate_before_);
}

StopMessage::~StopMessage() {
  restore_stops(interrupt_before_, terminate_before_);
}

TooLateToStop::TooLateToStop() {
  handle_stops(SIG_IGN, interrupt_before_, terminate_before_);
}

TooLateToStop::~TooLateToStop() {
  restore_stops(interrupt_before_, terminate_before_);
}

}  // namespace blockweir::picture
