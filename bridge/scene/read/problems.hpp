// SPDX-License-Identifier: GPL-3.0-or-later
// Collects what is wrong with a scene, so that all of it is reported at once.
#pragma once

#include <toml++/toml.h>
#include <cstddef>
#include <string>
#include <vector>

#include "bridge/scene/diagnostic.hpp"

namespace blockweir::scene {

/// Where a value stands: in the file, or in a `--set` of the command line (line 0 then).
struct Place {
  std::string file;
  int line = 0;
};

class Problems {
 public:
  explicit Problems(std::string file) : file_(std::move(file)) {}

  [[nodiscard]] Place at(int line) const { return {file_, line}; }
  [[nodiscard]] Place at(const toml::source_region& source) const;

  /// What comes after `largest_count` errors is not kept: it would not be read either.
  void error(const Place& place, const std::string& found, const std::string& expected, const std::string& remedy);
  /// What may be meant, and is likely a slip or has no effect.
  void warning(const Place& place, const std::string& found, const std::string& expected, const std::string& remedy);
  void note(const Place& place, const std::string& found, const std::string& remedy);

  [[nodiscard]] std::size_t count() const { return errors_.size(); }
  [[nodiscard]] bool full() const { return errors_.size() >= largest_count; }
  /// By line; what has none comes first. So are the warnings.
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
