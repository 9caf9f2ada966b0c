// SPDX-License-Identifier: GPL-3.0-or-later
// One thing wrong (or doubtful, or mended) in a scene: where, what was found, what is expected, what to do.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace blockweir::scene {

struct Diagnostic {
  /// A warning says what may be meant and is likely not; a note what was mended, e.g. a clockwise polygon.
  enum class Severity { error, warning, note };
  Severity severity = Severity::error;
  std::string file;
  int line = 0;  ///< 1-based; 0 where no line can be named
  std::string found;
  std::string expected;
  std::string remedy;

  /// "file:line: error: found; expected ...; remedy"
  [[nodiscard]] std::string text() const;
  /// "found; expected ...; remedy", for a report of a run: its file is another, or a copy.
  [[nodiscard]] std::string message() const;
};

/// All that is wrong with a scene; what() holds one line a diagnostic.
class SceneError : public std::runtime_error {
 public:
  explicit SceneError(std::vector<Diagnostic> diagnostics);
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace blockweir::scene
