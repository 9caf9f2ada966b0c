// SPDX-License-Identifier: GPL-3.0-or-later
// Collects errors of several readings of a scene and reports them together.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "bridge/scene/diagnostic.hpp"

namespace blockweir::scene {

class CollectedErrors {
 public:
  /// Calls read() and keeps its errors, each text once.
  template <class Read>
  void from(Read read) {
    try {
      read();
    } catch (const SceneError& error) {
      for (const Diagnostic& d : error.diagnostics()) {
        if (d.severity == Diagnostic::Severity::error) add(d);  // the scene's own warnings are reported once, elsewhere
      }
    }
  }

  void add(Diagnostic error) {
    const auto same = [&](const Diagnostic& other) { return without_value(other) == without_value(error); };
    if (std::none_of(errors_.begin(), errors_.end(), same)) errors_.push_back(std::move(error));
  }

  /// Throws SceneError if there is any error.
  void report() const {
    if (!errors_.empty()) throw SceneError(errors_);
  }

 private:
  /// The text of an error "... sets KEY=VALUE: ...", without the value, so that a wrong key is reported once.
  static std::string without_value(Diagnostic error) {
    std::string& found = error.found;
    const std::size_t setting = found.find(" sets ");
    const std::size_t value = setting == std::string::npos ? setting : found.find('=', setting);
    const std::size_t end = value == std::string::npos ? value : found.find(": ", value);
    if (end != std::string::npos) found.erase(value, end - value);
    return error.text();
  }

  std::vector<Diagnostic> errors_;
};

}  // namespace blockweir::scene
