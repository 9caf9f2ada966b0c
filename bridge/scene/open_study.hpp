// SPDX-License-Identifier: GPL-3.0-or-later
// [[study]]: many runs of a scene whose result is not known beforehand. A single run does not need it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bridge/scene/distribution.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// kind = "critical": the value of a key at which the outcome changes.
struct CriticalValue {
  std::string key;
  double from = 0;
  double to = 0;
  double width = 1e-3;            ///< final width of the bracket, relative to its larger end
  std::string outcome = "fails";  ///< an outcome or mode that one end has and the other has not; or "factor"
  std::optional<double> target;   ///< for "factor": the factor of safety at which the bracket is divided
  bool operator==(const CriticalValue&) const = default;
};

/// kind = "map": the outcome over two keys.
struct OutcomeMap {
  std::array<Sweep, 2> axes;
  bool operator==(const OutcomeMap&) const = default;
};

/// A key of the scene that varies from run to run of a sample.
struct Variable {
  std::string key;
  std::optional<Distribution> distribution;  ///< none: its values are in a column of the sample's file
  std::string column;
  bool operator==(const Variable&) const = default;
};

/// kind = "sample": keys drawn at random or read from a file, one run for each row.
struct Sample {
  int runs = 0;      ///< 0: the number of rows in the file
  int seed = 1;      ///< the same seed draws the same values
  std::string file;  ///< CSV with a heading, relative to the scene
  std::vector<Variable> variables;
  bool operator==(const Sample&) const = default;
};

struct OpenStudy {
  std::string name;
  std::vector<std::string> set;  ///< keys set in all runs, as for --set
  int line = 0;                  ///< where the scene file states it
  std::variant<CriticalValue, OutcomeMap, Sample> question;
  bool operator==(const OpenStudy&) const = default;
};

}  // namespace blockweir::scene
