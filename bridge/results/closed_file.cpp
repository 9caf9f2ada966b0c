// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/results/closed_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include "bridge/results/result_file.hpp"

namespace blockweir::results {
namespace {

bool write_at(int file, std::size_t offset, const std::string& text) {
  return ::pwrite(file, text.data(), text.size(), static_cast<off_t>(offset)) == static_cast<ssize_t>(text.size());
}

}  // namespace

ClosedFile::ClosedFile(std::filesystem::path path, std::string head, std::string tail)
    : path_(std::move(path)), head_(std::move(head)), tail_(std::move(tail)) {}

ClosedFile::~ClosedFile() {
  if (file_ >= 0) ::close(file_);
}

void ClosedFile::put(const std::string& middle) {
  if (file_ < 0) {
    replace_file(path_, head_ + middle + tail_);
    file_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) cannot_write(path_);
  } else {
    const std::size_t end = head_.size() + written_;
    if (!write_at(file_, end, middle.substr(written_) + tail_)) {
      const bool closed = write_at(file_, end, tail_);  // there was room for it before
      if (!closed || ::ftruncate(file_, static_cast<off_t>(end + tail_.size())) != 0) std::filesystem::remove(path_);
      cannot_write(path_);
    }
  }
  written_ = middle.size();
}

}  // namespace blockweir::results
