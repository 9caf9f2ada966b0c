// SPDX-License-Identifier: GPL-3.0-or-later
// A text file that grows by whole lines and reports write errors.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace blockweir::results {

/// Whether a run starts its files anew or continues existing ones.
enum class Begin { anew, where_it_stopped };

class ResultFile {
 public:
  /// Throws std::runtime_error if the file cannot be written.
  explicit ResultFile(std::filesystem::path path, Begin begin = Begin::anew);

  /// Appends a line and hands it to the system, so that a killed run leaves whole lines. Throws std::runtime_error if
  /// the disk is full.
  void line(const std::string& text);

  [[nodiscard]] std::uintmax_t size() const { return size_; }  ///< bytes
  /// Truncates the file to `size`. Throws std::runtime_error if the file is shorter.
  void cut_to(std::uintmax_t size);

  template <class Archive>
  void save(Archive& archive) const {
    archive(size_);
  }
  template <class Archive>
  void load(Archive& archive) {
    std::uintmax_t size = 0;
    archive(size);
    cut_to(size);
  }

 private:
  std::filesystem::path path_;
  std::ofstream stream_;
  std::uintmax_t size_ = 0;
};

/// Replaces the file by `text` in one operation: a reader sees the old or the new file. Throws std::runtime_error and
/// keeps the old file if that fails. A device is written to.
void replace_file(const std::filesystem::path& path, const std::string& text);

/// Writes a new file that nobody reads yet: complete, or not at all if it throws std::runtime_error.
void write_file(const std::filesystem::path& path, const std::string& text);

/// Throws the error of a file that cannot be written.
[[noreturn]] void cannot_write(const std::filesystem::path& path);

}  // namespace blockweir::results
