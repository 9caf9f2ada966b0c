// SPDX-License-Identifier: GPL-3.0-or-later
// Collects what is wrong with a scene, so that all of it is reported at once.
#include "bridge/scene/read/problems.hpp"

#include <algorithm>
#include <utility>

namespace blockweir::scene {
namespace {

std::vector<Diagnostic> by_line(std::vector<Diagnostic> diagnostics) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
  return diagnostics;
}

}  // namespace

Place Problems::at(const toml::source_region& source) const {
  // A value of --set carries that as its path and was parsed on its own: its line says nothing.
  if (source.path && *source.path != file_) return {*source.path, 0};
  return at(static_cast<int>(source.begin.line));
}

void Problems::error(const Place& place, std::string found, std::string expected, std::string remedy) {
  if (full()) return;
  errors_.push_back(
      {Diagnostic::Severity::error, place.file, place.line, std::move(found), std::move(expected), std::move(remedy)});
}

void Problems::warning(const Place& place, std::string found, std::string expected, std::string remedy) {
  if (warnings_.size() >= largest_count) return;
  warnings_.push_back({Diagnostic::Severity::warning, place.file, place.line, std::move(found), std::move(expected),
                       std::move(remedy)});
}

void Problems::note(const Place& place, std::string found, std::string remedy) {
  notes_.push_back({Diagnostic::Severity::note, place.file, place.line, std::move(found), "", std::move(remedy)});
}

std::vector<Diagnostic> Problems::errors() const {
  return by_line(errors_);
}

std::vector<Diagnostic> Problems::warnings() const {
  return by_line(warnings_);
}

}  // namespace blockweir::scene
