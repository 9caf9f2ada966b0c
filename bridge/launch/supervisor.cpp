// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/supervisor.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace blockweir::launch {
namespace {

using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t stop_signals = 0;
extern "C" void count_stop(int /*signal*/) {
  stop_signals = stop_signals + 1;
}

struct Child {
  std::string name;
  pid_t pid = -1;
  std::filesystem::path log;
  bool running = true;
};

[[noreturn]] void become(const Command& command, const std::filesystem::path& log) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  ::setpgid(0, 0);  // Ctrl-C reaches us alone; we pass it on in order
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file >= 0) ::dup2(file, STDERR_FILENO);
  if (command.inherited_fd >= 0) ::fcntl(command.inherited_fd, F_SETFD, 0);
  std::vector<char*> words;
  for (const std::string& word : command.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  ::execvp(words[0], words.data());
  const std::string text = "cannot start " + command.words[0] + ": " + std::strerror(errno) + "\n";
  (void)!::write(STDERR_FILENO, text.data(), text.size());
  ::_exit(127);
}

std::string last_line(const std::filesystem::path& log) {
  std::ifstream stream(log);
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

int exit_code(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void signal_all(const std::vector<Child>& children, int signal) {
  for (const Child& child : children) {
    if (child.running) ::kill(child.pid, signal);
  }
}

/// Waits without blocking; true when a child has ended.
bool reap(std::vector<Child>& children, Supervised& result) {
  bool any = false;
  for (Child& child : children) {
    int status = 0;
    if (!child.running || ::waitpid(child.pid, &status, WNOHANG) != child.pid) continue;
    child.running = false;
    any = true;
    result.ends.push_back({child.name, exit_code(status), last_line(child.log)});
  }
  return any;
}

}  // namespace

bool Supervised::all_fine() const {
  return !interrupted && std::all_of(ends.begin(), ends.end(), [](const ChildEnd& end) { return end.exit_code == 0; });
}

Supervised supervise(const std::vector<Command>& commands, const std::filesystem::path& log_folder, double grace_s,
                     const std::function<void()>& tick) {
  struct sigaction action = {};
  action.sa_handler = count_stop;
  sigemptyset(&action.sa_mask);
  struct sigaction old_int = {};
  struct sigaction old_term = {};
  stop_signals = 0;
  sigaction(SIGINT, &action, &old_int);
  sigaction(SIGTERM, &action, &old_term);

  std::vector<Child> children;
  for (const Command& command : commands) {
    Child child{.name = command.name, .log = log_folder / (command.name + ".log")};
    child.pid = ::fork();
    if (child.pid == 0) become(command, child.log);
    if (child.pid < 0) {
      signal_all(children, SIGKILL);
      throw std::runtime_error("cannot start " + command.name + ": " + std::strerror(errno));
    }
    children.push_back(child);
  }

  Supervised result;
  const auto running = [&] {
    return std::any_of(children.begin(), children.end(), [](const Child& c) { return c.running; });
  };
  Clock::time_point trouble = Clock::time_point::max();
  int sent = 0;  // 0 nothing, 1 SIGTERM, 2 SIGKILL
  auto last_tick = Clock::now();
  while (running()) {
    const auto now = Clock::now();
    if (!reap(children, result)) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (now - last_tick > std::chrono::milliseconds(50)) {
      last_tick = now;
      tick();
    }
    if (stop_signals > 0 && !result.interrupted) {
      result.interrupted = true;
      signal_all(children, SIGTERM);
      trouble = now;
      sent = 1;
    }
    if (trouble == Clock::time_point::max() && !result.all_fine()) trouble = now;
    if (trouble == Clock::time_point::max()) continue;
    const double waited = std::chrono::duration<double>(now - trouble).count();
    if (sent < 1 && waited > grace_s) signal_all(children, SIGTERM), sent = 1;
    if (sent < 2 && waited > 2 * grace_s) signal_all(children, SIGKILL), sent = 2;
  }
  tick();
  sigaction(SIGINT, &old_int, nullptr);
  sigaction(SIGTERM, &old_term, nullptr);
  return result;
}

}  // namespace blockweir::launch
