// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that names used as file names differ: those of load cases, variants or studies.
#pragma once

#include <map>
#include <string>

#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

class UniqueFileNames {
 public:
  /// `kind`: the word for one of them in messages, e.g. "load case".
  explicit UniqueFileNames(const char* kind) : kind_(kind) {}

  /// Reserves a name for the program itself.
  void reserve(const std::string& name);
  /// Reports a name that is taken, or that gives the same file name as another. An empty name is ignored.
  void add(Reading& reading, const TableReader& table, const std::string& name);
  /// The same for a valid name, stated in this line.
  void take(const std::string& name, int line);

 private:
  struct Owner {
    std::string name;  ///< empty: the program itself
    int line = 0;
  };
  const char* kind_;
  std::map<std::string, Owner> owners_;  ///< by file name
};

}  // namespace blockweir::scene
