// SPDX-License-Identifier: GPL-3.0-or-later
// Names that become files beside each other: those of load cases, variants or studies.
#pragma once

#include <map>
#include <string>

#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

class UniqueFileNames {
 public:
  /// `kind` is how messages call one of them: "load case".
  explicit UniqueFileNames(const char* kind) : kind_(kind) {}

  /// The program's own name among them.
  void reserve(const std::string& name);
  /// Reports a name that is taken, or whose file is that of another. An empty one is left out.
  void add(Reading& reading, const TableReader& table, const std::string& name);
  /// The same of a name that is sound, stated in this line.
  void take(const std::string& name, int line);

 private:
  struct Owner {
    std::string name;  ///< empty: the program itself
    int line = 0;
  };
  const char* kind_;
  std::map<std::string, Owner> owners_;  ///< by the name of the file
};

}  // namespace blockweir::scene
