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

/// Names and keys of a thousand letters are shortened: a message is to be read.
std::string readable(const std::string& text) {
  constexpr std::size_t longest_word = 300;
  constexpr std::size_t kept = 40;
  const auto within_a_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };  // UTF-8
  std::string shown;
  std::string word;
  const auto take = [&] {
    if (word.size() > longest_word) {
      std::size_t end = kept;
      std::size_t begin = word.size() - kept;
      while (within_a_letter(word[end])) ++end;
      while (within_a_letter(word[begin])) ++begin;
      word = word.substr(0, end) + "..." + word.substr(begin);
    }
    shown += word;
    word.clear();
  };
  for (const char c : text) {
    if (c != ' ') {
      word += c;
      continue;
    }
    take();
    shown += c;
  }
  take();
  return shown;
}

}  // namespace

Place Problems::at(const toml::source_region& source) const {
  // A value of --set carries that as its path and was parsed on its own: its line says nothing.
  if (source.path && *source.path != file_) return {*source.path, 0};
  return at(static_cast<int>(source.begin.line));
}

void Problems::error(const Place& place, const std::string& found, const std::string& expected,
                     const std::string& remedy) {
  if (full()) return;
  errors_.push_back(
      {Diagnostic::Severity::error, place.file, place.line, readable(found), readable(expected), readable(remedy)});
}

void Problems::warning(const Place& place, const std::string& found, const std::string& expected,
                       const std::string& remedy) {
  if (warnings_.size() >= largest_count) return;
  warnings_.push_back(
      {Diagnostic::Severity::warning, place.file, place.line, readable(found), readable(expected), readable(remedy)});
}

void Problems::note(const Place& place, const std::string& found, const std::string& remedy) {
  notes_.push_back({Diagnostic::Severity::note, place.file, place.line, readable(found), "", readable(remedy)});
}

std::vector<Diagnostic> Problems::errors() const {
  return by_line(errors_);
}

std::vector<Diagnostic> Problems::warnings() const {
  return by_line(warnings_);
}

}  // namespace blockweir::scene
