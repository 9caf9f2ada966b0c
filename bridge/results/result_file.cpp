// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/results/result_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace blockweir::results {

namespace {

/// A device or a pipe: a file may not take its place.
bool is_no_file(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
}

void write_through(const std::filesystem::path& path, const std::string& text) {
  std::ofstream stream(path);
  if (!(stream << text << std::flush)) cannot_write(path);
}

}  // namespace

void cannot_write(const std::filesystem::path& path) {
  const int why = errno;
  const bool told = why == ENOSPC || why == EDQUOT || why == EACCES || why == EROFS || why == EFBIG || why == EIO;
  throw std::runtime_error(
      fmt::format("cannot write {}: is the disk full, or the folder not writable?{}; make room, or "
                  "choose another folder",
                  path.string(), told ? fmt::format(" ({})", std::strerror(why)) : ""));
}

ResultFile::ResultFile(std::filesystem::path path, Begin begin)
    : path_(std::move(path)), stream_(path_, begin == Begin::anew ? std::ios::trunc : std::ios::app) {
  if (!stream_) cannot_write(path_);
  if (begin == Begin::where_it_stopped) size_ = std::filesystem::file_size(path_);
}

void ResultFile::cut_to(std::uintmax_t size) {
  if (std::filesystem::file_size(path_) < size) {
    throw std::runtime_error(
        fmt::format("{} is shorter than it was at the checkpoint; expected the file as the run left it; put it back, "
                    "or run the scene anew",
                    path_.string()));
  }
  std::filesystem::resize_file(path_, size);
  size_ = size;
}

void ResultFile::line(const std::string& text) {
  if (!(stream_ << text << '\n' << std::flush)) {
    stream_.close();
    std::error_code error;
    std::filesystem::resize_file(path_, size_, error);  // takes back the part of the line that the disk still took
    cannot_write(path_);
  }
  size_ += text.size() + 1;
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream stream(path, std::ios::trunc);
  if (stream << text << std::flush) return;
  stream.close();
  std::error_code ignored;
  if (!is_no_file(path)) std::filesystem::remove(path, ignored);
  cannot_write(path);
}

void replace_file(const std::filesystem::path& path, const std::string& text) {
  if (is_no_file(path)) return write_through(path, text);
  std::filesystem::path fresh = path;
  fresh += ".new";
  std::error_code error;
  std::ofstream stream(fresh, std::ios::trunc);
  const bool whole = static_cast<bool>(stream << text << std::flush);
  int why = errno;
  stream.close();
  if (whole) std::filesystem::rename(fresh, path, error);
  if (whole && !error) return;
  if (whole) why = error.value();
  std::filesystem::remove(fresh, error);
  errno = why;
  cannot_write(path);
}

}  // namespace blockweir::results
