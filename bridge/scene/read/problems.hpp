// SPDX-License-Identifier: GPL-3.0-or-later
// Collects all errors of a scene, so that they are reported together.
#pragma once

#include <toml++/toml.h>
#include <cstddef>
#include <string>
#include <vector>

#include "bridge/scene/diagnostic.hpp"

namespace blockweir::scene {

/// Place of a value: a line of the file, or a `--set` of the command line (line 0 then).
struct Place {
  std::string file;
  int line = 0;
};

class Problems {
 public:
  explicit Problems(std::string file) : file_(std::move(file)) {}

  [[nodiscard]] Place at(int line) const { return {file_, line}; }
  [[nodiscard]] Place at(const toml::source_region& source) const;

  /// Errors after the first `largest_count` are dropped: nobody would read them.
  void error(const Place& place, const std::string& found, const std::string& expected, const std::string& remedy);
  /// Something that is allowed, but is probably a mistake or has no effect.
  void warning(const Place& place, const std::string& found, const std::string& expected, const std::string& remedy);
  void note(const Place& place, const std::string& found, const std::string& remedy);

  [[nodiscard]] std::size_t count() const { return errors_.size(); }
  [[nodiscard]] bool full() const { return errors_.size() >= largest_count; }
  /// Sorted by line, those without a line first. Warnings likewise.
  [[nodiscard]] std::vector<Diagnostic> errors() const;
  [[nodiscard]] std::vector<Diagnostic> warnings() const;
  [[nodiscard]] const std::vector<Diagnostic>& notes() const { return notes_; }

  static constexpr std::size_t largest_count = 200;

 private:
  std::string file_;
  std::vector<Diagnostic> errors_;
  std::vector<Diagnostic> warnings_;
  std::vector<Diagnostic> notes_;
};

}  // namespace blockweir::scene
