// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of several readings of a scene, told at once.
#pragma once

#include <algorithm>
#include <vector>

#include "bridge/scene/diagnostic.hpp"

namespace blockweir::scene {

class Gathered {
 public:
  /// Calls read() and keeps what is wrong, each text once.
  template <class Read>
  void from(Read read) {
    try {
      read();
    } catch (const SceneError& error) {
      for (const Diagnostic& d : error.diagnostics()) {
        if (d.severity == Diagnostic::Severity::error) add(d);  // the scene's own warnings are told once
      }
    }
  }

  void add(const Diagnostic& error) {
    const auto same = [&](const Diagnostic& other) { return other.text() == error.text(); };
    if (std::none_of(errors_.begin(), errors_.end(), same)) errors_.push_back(error);
  }

  /// Throws SceneError where something is wrong.
  void report() const {
    if (!errors_.empty()) throw SceneError(errors_);
  }

 private:
  std::vector<Diagnostic> errors_;
};

}  // namespace blockweir::scene
