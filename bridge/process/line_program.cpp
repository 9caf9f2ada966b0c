// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/line_program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include "bridge/process/programs.hpp"

namespace blockweir::process {
namespace {

[[noreturn]] void cannot_start(const std::string& name) {
  throw std::runtime_error(
      fmt::format("cannot start {}: {}; end other programs, or raise the limit of processes (ulimit -u)", name,
                  std::strerror(errno)));
}

[[noreturn]] void become_program(std::vector<std::string>& words, int line, int log, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);  // gone before we said so
  // A stop is the parent's to hear, also where a queue tells all processes: this ends when its line does.
  for (const int stop : {SIGINT, SIGTERM}) std::signal(stop, SIG_IGN);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::dup2(line, STDIN_FILENO);
  ::dup2(line, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execv(arguments.front(), arguments.data());
  ::_exit(127);
}

}  // namespace

LineProgram::LineProgram(std::vector<std::string> words) : name_(words.front()) {
  words.front() = program_beside(name_).string();
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) cannot_start(name_);
  log_ = ::memfd_create("log", MFD_CLOEXEC);
  const pid_t parent = ::getpid();
  child_ = log_ < 0 ? -1 : ::fork();
  if (child_ == 0) become_program(words, ends[1], log_, parent);
  ::close(ends[1]);
  line_ = ends[0];
  if (child_ < 0) {
    const int why = errno;
    ::close(ends[0]);
    if (log_ >= 0) ::close(log_);
    errno = why;
    cannot_start(name_);
  }
}

LineProgram::~LineProgram() {
  ::close(line_);
  ::kill(child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
  ::close(log_);
}

void LineProgram::say(const nlohmann::json& line) {
  const std::string text = line.dump() + "\n";
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t more = ::send(line_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) has_ended();
    sent += static_cast<std::size_t>(more);
  }
}

nlohmann::json LineProgram::hear() {
  std::array<char, 65536> buffer{};
  std::size_t looked = 0;
  for (;;) {
    if (const auto end = heard_.find('\n', looked); end != std::string::npos) {
      const std::string line = heard_.substr(0, end);
      heard_.erase(0, end + 1);
      return nlohmann::json::parse(line);
    }
    looked = heard_.size();
    const ssize_t more = ::recv(line_, buffer.data(), buffer.size(), 0);
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) has_ended();
    heard_.append(buffer.data(), static_cast<std::size_t>(more));
  }
}

void LineProgram::has_ended() {
  std::string words;
  std::array<char, 4096> buffer{};
  ::lseek(log_, 0, SEEK_SET);
  for (ssize_t more = 0; (more = ::read(log_, buffer.data(), buffer.size())) > 0;) {
    words.append(buffer.data(), static_cast<std::size_t>(more));
  }
  while (words.ends_with('\n')) words.pop_back();
  words = words.substr(words.rfind('\n') + 1);
  throw std::runtime_error(
      fmt::format("{} has ended before it answered{}; reinstall it, or see whether memory is short", name_,
                  words.empty() ? "" : ": " + words));
}

}  // namespace blockweir::process
