// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/diagnostic.hpp"

#include <fmt/format.h>

namespace blockweir::scene {
namespace {

const char* name(Diagnostic::Severity severity) {
  switch (severity) {
    case Diagnostic::Severity::error:
      return "error";
    case Diagnostic::Severity::warning:
      return "warning";
    case Diagnostic::Severity::note:
      break;
  }
  return "note";
}

std::string all(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& d : diagnostics) text += (text.empty() ? "" : "\n") + d.text();
  return text;
}

}  // namespace

std::string Diagnostic::text() const {
  std::string line_text = line > 0 ? fmt::format(":{}", line) : "";
  return fmt::format("{}{}: {}: {}", file, line_text, name(severity), message());
}

std::string Diagnostic::message() const {
  std::string text = found;
  if (!expected.empty()) text += "; expected " + expected;
  if (!remedy.empty()) text += "; " + remedy;
  return text;
}

SceneError::SceneError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(all(diagnostics)), diagnostics_(std::move(diagnostics)) {}

}  // namespace blockweir::scene
