// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/results/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <stdexcept>
#include <string>

#include "bridge/results/result_file.hpp"

namespace blockweir::results {
namespace {

/// Number of the process that took the lock; 0 where it has not said so yet.
pid_t holder_of(const std::filesystem::path& path) {
  pid_t holder = 0;
  std::ifstream(path) >> holder;
  return holder;
}

/// The lock on `folder` is held by another process.
[[noreturn]] void refuse(const std::filesystem::path& folder, pid_t holder, const char* remedy) {
  throw std::invalid_argument(
      fmt::format("{}: another run writes there, that of process {}{}; {}", folder.string(), holder,
                  ::kill(holder, 0) == 0 ? "" : ", which has ended and left others running", remedy));
}

}  // namespace

void FolderLock::refuse_in_use(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / file;
  const int lock = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (lock < 0) return;
  const bool held = ::flock(lock, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(lock);
  if (held) refuse(folder, holder_of(path), "wait until it has ended");
}

FolderLock::FolderLock(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / file;
  // Children inherit it: while one of them still writes, the folder is in use, even if we are gone.
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT, 0644);
  if (descriptor_ < 0) cannot_write(path);
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    const bool held = errno == EWOULDBLOCK;
    ::close(descriptor_);
    descriptor_ = -1;
    if (!held) return;  // a file system without locks
    const pid_t holder = holder_of(path);
    if (holder == ::getppid() || holder == ::getpid()) return;
    refuse(folder, holder, "choose another --out, or wait until it has ended");
  }
  const std::string text = fmt::format("{}\n", ::getpid());
  (void)!::ftruncate(descriptor_, 0);
  const ssize_t written = ::write(descriptor_, text.data(), text.size());
  if (written == static_cast<ssize_t>(text.size())) return;
  const int why = written < 0 ? errno : ENOSPC;
  ::close(descriptor_);
  errno = why;
  cannot_write(path);
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace blockweir::results
