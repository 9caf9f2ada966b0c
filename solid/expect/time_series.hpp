// SPDX-License-Identifier: GPL-3.0-or-later
// Time histories of the blocks whose motion an expectation needs.
#pragma once

#include <map>
#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid::expect {

struct Sample {
  double time_s = 0;
  Vector6 displacement;
  Vector6 velocity;
  Point water_force;  ///< N per metre, over the window that ended at this time

  template <class Archive>
  void serialize(Archive& archive) {
    archive(time_s, displacement, velocity, water_force);
  }
};
using Course = std::vector<Sample>;

class TimeSeries {
 public:
  explicit TimeSeries(const Solid& solid);
  void look(const Solid& solid, const std::vector<Panel>& water, double time_s);
  /// Empty for a block that is not recorded.
  [[nodiscard]] const Course& of(std::size_t block) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(courses_);
  }

 private:
  std::map<std::size_t, Course> courses_;
};

}  // namespace blockweir::solid::expect
