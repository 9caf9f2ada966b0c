// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene says of its answers, and of runs of it with keys set otherwise, whose answers it states.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bridge/geometry/point.hpp"

namespace blockweir::scene {

using geometry::Point;

/// One figure that the case states, to be compared after the run; exactly one of value, word and formula.
struct Expectation {
  std::string quantity;  ///< see solid/expect/quantities
  std::optional<double> value;
  std::string word;           ///< of a quantity that is no number, as the mode of failure
  std::string formula;        ///< see solid/expect/formulas
  std::string of;             ///< the block or joint that quantity and formula speak of; may be empty
  std::optional<Point> at_m;  ///< the point of that block, as in the scene's outline
  double tolerance = 1e-3;    ///< relative
  std::string source;
  bool operator==(const Expectation&) const = default;
};

/// The scene with some keys set otherwise: another case with the same geometry.
struct Variant {
  std::string name;
  std::vector<std::string> set;  ///< "dotted.key=value", as --set takes them
  int line = 0;                  ///< where the scene file states it
  bool operator==(const Variant&) const = default;
};

/// Many runs of the scene with one or two keys set otherwise: what all kinds of studies state.
struct Study {
  std::string name;
  std::vector<std::string> set;  ///< holds in all runs of the study, as --set takes it
  Expectation expected;          ///< the answer; what it speaks of and what its tolerance means depends on the kind
  int line = 0;                  ///< where the scene file states it
  bool operator==(const Study&) const = default;
};

/// Between which values of a key does the outcome change? Found by bisection over whole runs.
struct LimitStudy : Study {
  std::string key;
  double from = 0;
  double to = 0;
  double width = 1e-3;            ///< of the bracket at the end, over its middle
  std::string outcome = "fails";  ///< that one end has and the other has not; or a mode of failure
  bool operator==(const LimitStudy&) const = default;
};

/// With which power of a key does the error of a quantity vanish?
struct OrderStudy : Study {
  std::string key;
  std::vector<double> values;
  double order = 0;
  double order_tolerance = 0.1;  ///< absolute
  bool operator==(const OrderStudy&) const = default;
};

/// A key and what it is set to, one run after the other: numbers or words, as --set takes them.
struct Sweep {
  std::string key;
  std::vector<std::string> values;
  bool operator==(const Sweep&) const = default;
};

/// A quantity over two keys, a word or a number, each cell against that of a formula.
struct MapStudy : Study {
  std::array<Sweep, 2> axes;
  int may_refuse = 0;      ///< cells that may be refused with a reason
  double longest_s = 120;  ///< of wall time: a cell that takes longer hangs
  bool operator==(const MapStudy&) const = default;
};

/// A curve of wall time against the error of the scene's first figure, or of its motion.
struct Bench {
  std::string name;
  std::vector<std::string> set;  ///< holds in all its runs, as --set takes it
  Sweep sweep;
  int line = 0;  ///< where the scene file states it
  bool operator==(const Bench&) const = default;
};

/// A bench whose error is that of the motion: runs end at `until_s`, and are held against one with finer steps.
struct BenchMotion {
  double until_s = 0;
  int finer = 16;  ///< its steps are so many times smaller than the scene's
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
