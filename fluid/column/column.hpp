// SPDX-License-Identifier: GPL-3.0-or-later
// Water in a pipe that ends at the edge of a block: the smallest fluid, with an exact solution.
#pragma once

#include "bridge/scene/scene.hpp"
#include "bridge/schedule/sides.hpp"

namespace blockweir::column {

using scene::Point;

/// Per square metre of edge; x is the edge's displacement into the pipe and xi the water's, both from time 0:
///
///     p = p0 + K (x - xi),   rho L xi'' = p - p0 - rho g r xi,   p0 = rho g head,
///
/// with a cushion of stiffness K between edge and water, and r the rise of the far end for unit displacement. Without a
/// cushion xi = x, and p = p0 + rho L x'' + rho g r x. Displacements are measured along the edge's first normal.
class Column final : public schedule::FluidSide {
 public:
  explicit Column(const scene::Scene& scene);

  void advance(const wire::Motion& motion, double to_s, wire::Load& load) override;
  [[nodiscard]] std::string state() const override;
  void restore(const std::string& state) override;

 private:
  /// Displacement of the edge into the pipe, and its rate.
  struct Way {
    double x = 0;
    double v = 0;
    template <class Archive>
    void serialize(Archive& archive) {
      archive(x, v);
    }
  };
  [[nodiscard]] Way way(const wire::Motion& motion) const;
  [[nodiscard]] double without_cushion(const Way& end, double window_s) const;
  double with_cushion(const Way& end, double window_s);

  const scene::Column& column_;
  double inertia_;    ///< rho L [kg/m2]
  double restoring_;  ///< rho g r [Pa/m]
  double head_pa_;
  std::size_t blocks_;
  Point centroid_;
  Point middle_;  ///< of the edge, as drawn
  Point into_;    ///< direction into the pipe, of length 1
  double width_m_;

  Way edge_;   ///< at the last exchange
  Way water_;  ///< xi and its rate
  double time_s_ = 0;
};

}  // namespace blockweir::column
