// SPDX-License-Identifier: GPL-3.0-or-later
// One thing wrong (or mended) in a scene: where, what was found, what is expected, what to do.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace blockweir::scene {

struct Diagnostic {
  enum class Severity { error, note };  ///< a note says what was mended, e.g. a clockwise polygon
  Severity severity = Severity::error;
  std::string file;
  int line = 0;  ///< 1-based; 0 where no line can be named
  std::string found;
  std::string expected;
  std::string remedy;

  /// "file:line: error: found; expected ...; remedy"
  [[nodiscard]] std::string text() const;
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
