// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/gnuplot_program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace blockweir::picture {

namespace {

constexpr int no_program = 127;

[[noreturn]] void cannot_start_gnuplot() {
  throw std::runtime_error(fmt::format("cannot start gnuplot: {}; end other programs", std::strerror(errno)));
}

/// The script is a file, since gnuplot reads a pipe character by character.
[[noreturn]] void become_gnuplot(const MemoryFile& script, int lines, int words, const std::vector<MemoryFile>& outputs,
                                 pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(no_program);  // gone before we said so
  ::setpgid(0, 0);                                 // Ctrl-C reaches us alone
  for (const MemoryFile& output : outputs) ::fcntl(output.number(), F_SETFD, 0);
  ::fcntl(script.number(), F_SETFD, 0);
  ::dup2(::open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);
  ::dup2(lines, STDOUT_FILENO);
  ::dup2(words, STDERR_FILENO);
  ::execlp("gnuplot", "gnuplot", "--default-settings", script.path().c_str(),
           nullptr);  // no start-up file of the user's
  ::_exit(errno == ENOENT ? no_program : no_program - 1);
}

std::string last_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  text.erase(0, text.rfind('\n') + 1);
  return text.substr(std::min(text.size(), text.find_first_not_of(' ')));
}

}  // namespace

MemoryFile::MemoryFile() : file_(::memfd_create("picture", MFD_CLOEXEC)) {
  if (file_ < 0) throw std::runtime_error(fmt::format("no memory for a picture: {}", std::strerror(errno)));
}

MemoryFile::~MemoryFile() {
  if (file_ >= 0) ::close(file_);
}

MemoryFile::MemoryFile(MemoryFile&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

std::string MemoryFile::text() const {
  std::string all;
  std::array<char, 65536> buffer{};
  for (ssize_t more = 0; (more = ::pread(file_, buffer.data(), buffer.size(), static_cast<off_t>(all.size()))) > 0;) {
    all.append(buffer.data(), static_cast<std::size_t>(more));
  }
  return all;
}

void MemoryFile::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t taken = ::write(file_, text.data(), text.size());
    if (taken < 0 && errno == EINTR) continue;
    if (taken <= 0) throw std::runtime_error(fmt::format("no memory for a picture: {}", std::strerror(errno)));
    text.remove_prefix(static_cast<std::size_t>(taken));
  }
}

GnuplotProgram::GnuplotProgram(const std::string& script, const std::vector<MemoryFile>& outputs) {
  script_.write(script);
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) cannot_start_gnuplot();
  const pid_t parent = ::getpid();
  child_ = ::fork();
  if (child_ == 0) become_gnuplot(script_, ends[1], words_.number(), outputs, parent);
  const int why = errno;
  ::close(ends[1]);
  lines_ = ends[0];
  if (child_ > 0) return;
  ::close(lines_);
  errno = why;
  cannot_start_gnuplot();
}

GnuplotProgram::~GnuplotProgram() {
  if (lines_ >= 0) ::close(lines_);
  if (child_ <= 0) return;
  ::kill(child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
}

bool GnuplotProgram::printed() {
  for (char letter = 0;;) {
    const ssize_t more = ::read(lines_, &letter, 1);
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) return false;
    if (letter == '\n') return true;
  }
}

void GnuplotProgram::end() {
  ::close(std::exchange(lines_, -1));
  int status = 0;
  while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) continue;
  child_ = -1;
  if (status == 0) return;
  if (WIFEXITED(status) && WEXITSTATUS(status) == no_program)
    throw std::runtime_error("the program gnuplot is missing: install the package gnuplot-nox");
  const std::string how =
      WIFSIGNALED(status) ? fmt::format("signal {}", WTERMSIG(status)) : fmt::format("status {}", WEXITSTATUS(status));
  const std::string last = last_line(words_.text());
  throw std::runtime_error(
      fmt::format("gnuplot drew no figure: it ended with {}{}; no file was changed; try again with "
                  "more memory; if that does not help, report gnuplot's message",
                  how, last.empty() ? "" : ": " + last));
}

}  // namespace blockweir::picture
