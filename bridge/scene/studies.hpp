// SPDX-License-Identifier: GPL-3.0-or-later
// Expected values of a scene, and studies: runs with changed keys whose result the scene states.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bridge/geometry/point.hpp"

namespace blockweir::scene {

using geometry::Point;

/// One expected figure, compared after the run; it has exactly one of value, word and formula.
struct Expectation {
  std::string quantity;  ///< see solid/expect/quantities
  std::optional<double> value;
  std::string word;           ///< for a quantity that is not a number, such as the mode of failure
  std::string formula;        ///< see solid/expect/formulas
  std::string of;             ///< the block or joint that it refers to; may be empty
  std::optional<Point> at_m;  ///< a point of that block, as drawn
  double tolerance = 1e-3;    ///< relative
  std::string source;
  bool operator==(const Expectation&) const = default;
};

/// The scene with some keys changed: another case with the same geometry.
struct Variant {
  std::string name;
  std::vector<std::string> set;  ///< "dotted.key=value", as for --set
  int line = 0;                  ///< where the scene file states it
  bool operator==(const Variant&) const = default;
};

/// Many runs of the scene with one or two keys changed: the members common to all kinds of studies.
struct Study {
  std::string name;
  std::vector<std::string> set;  ///< keys set in all runs of the study, as for --set
  Expectation expected;          ///< the stated result; what it refers to and its tolerance depend on the kind of study
  int line = 0;                  ///< where the scene file states it
  bool operator==(const Study&) const = default;
};

/// The values of a key between which the outcome changes, found by bisection over whole runs.
struct LimitStudy : Study {
  std::string key;
  double from = 0;
  double to = 0;
  double width = 1e-3;            ///< final width of the bracket over its middle
  std::string outcome = "fails";  ///< that one end has and the other has not; or a mode of failure
  bool operator==(const LimitStudy&) const = default;
};

/// The order of convergence: the power of a key with which the error of a quantity vanishes.
struct OrderStudy : Study {
  std::string key;
  std::vector<double> values;
  double order = 0;
  double order_tolerance = 0.1;  ///< absolute
  bool operator==(const OrderStudy&) const = default;
};

/// The values of a key, one run each: numbers or words, as for --set.
struct Sweep {
  std::string key;
  std::vector<std::string> values;
  bool operator==(const Sweep&) const = default;
};

/// A quantity over two keys, a word or a number; each cell is compared with a formula.
struct MapStudy : Study {
  std::array<Sweep, 2> axes;
  int may_refuse = 0;      ///< number of cells that may be refused with a reason
  double longest_s = 120;  ///< of wall time; a cell that takes longer counts as hanging
  bool operator==(const MapStudy&) const = default;
};

/// Wall time against the error of the scene's first figure, or of its motion.
struct Bench {
  std::string name;
  std::vector<std::string> set;  ///< keys set in all its runs, as for --set
  Sweep sweep;
  int line = 0;  ///< where the scene file states it
  bool operator==(const Bench&) const = default;
};

/// A bench whose error is that of the motion: runs end at `until_s` and are compared with one of finer steps.
struct BenchMotion {
  double until_s = 0;
  int finer = 16;  ///< the reference's steps are smaller by this factor
  bool operator==(const BenchMotion&) const = default;
};

struct Studies {
  std::vector<LimitStudy> limits;
  std::vector<OrderStudy> orders;
  std::vector<MapStudy> maps;
  std::vector<Bench> benches;
  std::optional<BenchMotion> bench_motion;
  bool operator==(const Studies&) const = default;
};

}  // namespace blockweir::scene
