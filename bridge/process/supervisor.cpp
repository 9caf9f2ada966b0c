// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/supervisor.hpp"

extern "C" {  // glibc 2.36 forgets to say so itself
#include <sys/pidfd.h>
}

#include <fcntl.h>
#include <poll.h>
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
#include <utility>

#include "bridge/process/process_state.hpp"
#include "bridge/process/reaper.hpp"
#include "bridge/results/seconds.hpp"

namespace blockweir::process {
namespace {

using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t stop_signals = 0;
extern "C" void count_stop(int /*signal*/) {
  stop_signals = stop_signals + 1;
}

sigset_t stop_set() {
  sigset_t both;
  sigemptyset(&both);
  sigaddset(&both, SIGINT);
  sigaddset(&both, SIGTERM);
  return both;
}

/// Counts SIGINT and SIGTERM during its lifetime. They are delivered only during a wait with the mask `outside()`, so
/// that none is missed between a check of the count and the wait.
class StopSignals {
 public:
  StopSignals() {
    stop_signals = 0;
    const sigset_t ours = stop_set();
    ::sigprocmask(SIG_BLOCK, &ours, &before_);
    outside_ = before_;
    sigdelset(&outside_, SIGINT);
    sigdelset(&outside_, SIGTERM);
    struct sigaction action = {};
    action.sa_handler = count_stop;
    sigemptyset(&action.sa_mask);
    ::sigaction(SIGINT, &action, &old_int_);
    ::sigaction(SIGTERM, &action, &old_term_);
  }
  ~StopSignals() {
    ::sigaction(SIGINT, &old_int_, nullptr);
    ::sigaction(SIGTERM, &old_term_, nullptr);
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
  }
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  [[nodiscard]] const sigset_t& outside() const { return outside_; }

 private:
  sigset_t before_{};
  sigset_t outside_{};
  struct sigaction old_int_ {};
  struct sigaction old_term_ {};
};

[[noreturn]] void become(const Command& command, const std::filesystem::path& log, const StopSignals& signals,
                         pid_t parent) {
  ::sigprocmask(SIG_SETMASK, &signals.outside(), nullptr);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);  // gone before we said so
  ::setpgid(0, 0);                          // Ctrl-C reaches us alone; we pass it on in order
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file >= 0) ::dup2(file, STDERR_FILENO);
  if (file >= 0 && !command.output.empty()) ::dup2(file, STDOUT_FILENO);
  if (command.aside) (void)!::nice(10);  // the others have the processors first
  if (command.inherited_fd >= 0) ::fcntl(command.inherited_fd, F_SETFD, 0);
  for (const std::string& setting : command.environment) ::putenv(const_cast<char*>(setting.c_str()));
  std::vector<char*> words;
  for (const std::string& word : command.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  if (command.folder.empty() || ::chdir(command.folder.c_str()) == 0) ::execvp(words[0], words.data());
  const std::string text = "cannot start " + command.words[0] + ": " + std::strerror(errno) +
                           "; expected a program that can be run; " + command.remedy + "\n";
  (void)!::write(STDERR_FILENO, text.data(), text.size());
  ::_exit(127);
}

int exit_code(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

struct Child {
  std::string name;
  std::filesystem::path log;
  pid_t pid = -1;
  int end = -1;  ///< a descriptor that becomes readable when the process has ended
  bool running = false;
  bool aside = false;
  bool external = false;
  std::vector<std::string> words{};  ///< of an external one
  bool told = false;                 ///< by a signal of ours
  bool stopped = false;              ///< when another failed
};

struct Children {
  std::vector<Child> all{};

  Children() = default;
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;
  ~Children() {
    for (const Child& child : all) {
      if (child.end >= 0) ::close(child.end);
    }
  }
  /// All are ended where this one cannot be started.
  void start(const Command& command, const std::filesystem::path& log_folder, const StopSignals& signals) {
    const pid_t we = ::getpid();
    Child& child = all.emplace_back();
    child.name = command.name;
    child.aside = command.aside;
    child.external = command.external;
    if (command.external) child.words = command.words;
    child.log = command.output.empty() ? log_folder / (command.name + ".log") : command.output;
    child.pid = ::fork();
    if (child.pid == 0) become(command, child.log, signals, we);
    if (child.pid > 0) child.end = ::pidfd_open(child.pid, 0);
    child.running = child.pid > 0;
    if (child.end >= 0) return;
    const std::string reason = std::strerror(errno);
    signal(SIGKILL);
    throw std::runtime_error("cannot start " + command.name + ": " + reason +
                             "; end other programs, or raise the limits of processes and open files (ulimit -u, -n)");
  }
  [[nodiscard]] bool running() const {
    return std::any_of(all.begin(), all.end(), [](const Child& c) { return c.running; });
  }
  /// Do all that run do so aside?
  [[nodiscard]] bool only_aside() const {
    return std::all_of(all.begin(), all.end(), [](const Child& c) { return c.aside || !c.running; });
  }
  void signal(int number) {
    for (Child& child : all) signal(child, number);
  }
  /// The one that leads; it tells the others.
  void signal_first(int number) { signal(all.front(), number); }
  /// Is none left to notice that the others answer no more?
  [[nodiscard]] bool all_stopped() const {
    return std::all_of(all.begin(), all.end(),
                       [](const Child& c) { return !c.running || c.stopped || is_stopped(family_of(c.pid)); });
  }
  /// Those that are stopped are asked to end and woken, so that they can.
  void wake() {
    for (Child& child : all) {
      if (!child.running || child.stopped) continue;
      const std::vector<pid_t> family = family_of(child.pid);
      if (!is_stopped(family)) continue;
      child.stopped = true;
      signal(child, SIGTERM);
      for (const pid_t pid : family) ::kill(pid, SIGCONT);
    }
  }
  /// Until a child ends, a signal arrives, or 50 ms have passed; adds ended children to `result`.
  void wait(const StopSignals& signals, Supervised& result) {
    std::vector<pollfd> watched;
    for (const Child& child : all) {
      if (child.running) watched.push_back({child.end, POLLIN, 0});
    }
    const timespec longest{0, 50'000'000};
    ::ppoll(watched.data(), watched.size(), &longest, &signals.outside());
    for (Child& child : all) {
      int status = 0;
      if (!child.running || ::waitpid(child.pid, &status, WNOHANG) != child.pid) continue;
      child.running = false;
      if (child.aside) continue;
      result.ends.push_back({child.name, exit_code(status), child.told, child.stopped, child.external, child.words,
                             false, last_line(child.log)});
      if (child.external && !child.told) external_end_ = result.ends.size();
    }
  }

  /// An external one has ended since the last call, and the first, not `in_touch`, would wait for it in vain.
  bool ended_early(bool in_touch, Supervised& result) {
    const std::size_t end = std::exchange(external_end_, 0);
    if (end == 0 || in_touch || !all.front().running) return false;
    result.ends[end - 1].early = true;
    return true;
  }

 private:
  static void signal(Child& child, int number) {
    if (!child.running) return;
    child.told = true;
    ::kill(child.pid, number);
  }
  std::size_t external_end_ = 0;  ///< how many ends there were with it; 0: none has ended
};

}  // namespace

std::string last_line(const std::filesystem::path& log) {
  std::ifstream stream(log);
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

StopsLater::StopsLater() {
  const sigset_t both = stop_set();
  ::sigprocmask(SIG_BLOCK, &both, &before_);
}

StopsLater::~StopsLater() {
  ::sigprocmask(SIG_SETMASK, &before_, nullptr);
}

bool Supervised::all_fine() const {
  return !interrupted &&
         std::all_of(ends.begin(), ends.end(), [](const ChildEnd& end) { return end.exit_code == 0 && !end.early; });
}

Supervised supervise(const std::vector<Command>& commands, const std::filesystem::path& log_folder, double grace_s,
                     const std::function<bool()>& tick, double longest_s) {
  constexpr double longest_wait_s = 0.1;
  constexpr double apart_grace_s = 1;  // to end by themselves: not connected, they cannot notice another's end
  const auto begin = Clock::now();
  auto looked = begin;
  const StopSignals signals;
  const Reaper reaper;
  const pid_t parent = ::getppid();
  Children children;
  for (const Command& command : commands) children.start(command, log_folder, signals);

  Supervised result;
  Clock::time_point trouble = Clock::time_point::max();
  double all_stopped_s = 0;  // while we were not: a suspended job stops us, too
  int sent = 0;              // 0 nothing, 1 SIGTERM, 2 SIGKILL
  int heard = 0;             // of the stop signals to us
  while (children.running()) {
    children.wait(signals, result);
    const bool in_touch = tick();
    const auto now = Clock::now();
    if (children.ended_early(in_touch, result)) {
      children.signal(SIGTERM);
      trouble = now;
      sent = 1;
    }
    if (const int asked = stop_signals; asked > heard) {
      const bool once = std::exchange(heard, asked) == 0 && asked == 1;
      const bool alone = ::getppid() != parent;  // nobody will ask a second time
      result.interrupted = result.asked_to_stop = true;
      if (once && in_touch && !alone) {
        children.signal_first(SIGTERM);
      } else {
        children.signal(SIGTERM);
        trouble = now;
        sent = 1;
      }
    }
    if (children.only_aside() && !result.all_fine()) children.signal(SIGKILL);
    if (longest_s > 0 && !result.overdue && seconds_since(begin) > longest_s) {
      result.overdue = true;
      children.signal(SIGKILL);
    }
    if (trouble == Clock::time_point::max() && !result.ends.empty() && !result.all_fine()) trouble = now;
    all_stopped_s = children.all_stopped() ? all_stopped_s + std::min(seconds_since(looked), longest_wait_s) : 0;
    looked = now;
    if (trouble == Clock::time_point::max() && all_stopped_s > grace_s) trouble = now;
    if (trouble == Clock::time_point::max()) continue;
    children.wake();
    const double waited = seconds_since(trouble);
    if (sent < 1 && waited > (in_touch ? grace_s : std::min(grace_s, apart_grace_s)))
      children.signal(SIGTERM), sent = 1;
    if (sent < 2 && waited > 2 * grace_s) children.signal(SIGKILL), sent = 2;
  }
  Reaper::reap(grace_s);
  const auto done = [](const ChildEnd& end) { return end.exit_code == 0; };
  if (std::all_of(result.ends.begin(), result.ends.end(), done)) result.interrupted = false;  // asked too late
  return result;
}

}  // namespace blockweir::process
