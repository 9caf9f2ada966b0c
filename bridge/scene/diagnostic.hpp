// SPDX-License-Identifier: GPL-3.0-or-later
// One problem of a scene: its place, what was found, what is expected, and the remedy. Errors, warnings and notes.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace blockweir::scene {

struct Diagnostic {
  /// A warning marks what is allowed but probably a mistake; a note tells what was corrected, e.g. a clockwise polygon.
  enum class Severity { error, warning, note };
  Severity severity = Severity::error;
  std::string file;
  int line = 0;  ///< 1-based; 0: no line known
  std::string found;
  std::string expected;
  std::string remedy;

  /// "file:line: error: found; expected ...; remedy"
  [[nodiscard]] std::string text() const;
  /// "found; expected ...; remedy", without the place: a run's report refers to another file, or a copy.
  [[nodiscard]] std::string message() const;
};

/// All errors of a scene; what() has one line for each diagnostic.
class SceneError : public std::runtime_error {
 public:
  explicit SceneError(std::vector<Diagnostic> diagnostics);
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace blockweir::scene
