// SPDX-License-Identifier: GPL-3.0-or-later
// A text file that grows by whole lines and says so when it cannot.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace blockweir::results {

/// Whether a run writes its files anew or goes on with those that are there.
enum class Begin { anew, where_it_stopped };

class ResultFile {
 public:
  /// Throws std::runtime_error when the file cannot be written.
  explicit ResultFile(std::filesystem::path path, Begin begin = Begin::anew);

  /// Adds a line and hands it to the system, so that a killed run leaves whole lines. Throws std::runtime_error when
  /// the disk takes no more.
  void line(const std::string& text);

  [[nodiscard]] std::uintmax_t size() const { return size_; }  ///< bytes
  /// Takes back what was written beyond `size`. Throws std::runtime_error when the file is shorter.
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

/// Puts `text` in place of the file in one go: a reader sees the old one or the new one. Throws std::runtime_error
/// and leaves the old one when that fails. A device is written to.
void replace_file(const std::filesystem::path& path, const std::string& text);

/// Writes a file that nobody reads yet: whole, or not at all when it throws std::runtime_error.
void write_file(const std::filesystem::path& path, const std::string& text);

/// Throws the error that says so.
[[noreturn]] void cannot_write(const std::filesystem::path& path);

}  // namespace blockweir::results
