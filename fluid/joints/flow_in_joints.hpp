// SPDX-License-Identifier: GPL-3.0-or-later
// Flow through the joints of a scene: the network follows the blocks, its boundary values are those of open water, and
// its pressures become panels on both faces of each joint.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fluid/joints/joint_network.hpp"
#include "fluid/joints/network_flow.hpp"
#include "fluid/joints/transient_guard.hpp"
#include "fluid/joints/turbulence.hpp"

namespace blockweir::joints {

/// Inflows and outflows of a network [m2/s].
struct FlowBalance {
  double from_open_water = 0;
  double to_open_water = 0;
  double to_air = 0;
  std::vector<double> to_drain;  ///< for each drain of the scene
  double stored = 0;             ///< volume that the joints hold [m2]
  double largest = 0;            ///< largest flow in a channel
  std::size_t largest_channel = 0;
};

class FlowInJoints {
 public:
  /// `open_m`: faces farther apart are not a joint; none: [water] open_crack_width_m.
  FlowInJoints(const scene::Scene& scene, const GroundCut& ground, std::optional<double> open_m = {});

  [[nodiscard]] bool empty() const { return joints_.empty(); }
  /// Whether its pressures change by storage while nothing else does.
  [[nodiscard]] bool changes_by_itself() const;
  /// Solves for time `to_s` and appends the panels of the joints to `load`, whose first `open_panels` are open water.
  /// `moved`: blocks have moved since the last call. `ground_m`: displacement of their ground.
  void advance(const std::vector<std::vector<Point>>& outlines, const Point& ground_m, bool moved, double to_s,
               std::size_t open_panels, wire::Load& load);
  /// Appends the last solution again, to a load of the same time.
  void repeat(const std::vector<std::vector<Point>>& outlines, const Point& ground_m, std::size_t open_panels,
              wire::Load& load);

  [[nodiscard]] FlowBalance balance() const;
  [[nodiscard]] const JointNetwork& joints() const { return joints_; }
  [[nodiscard]] const Filling& filling() const { return filling_; }
  /// Levels of the open water in the last solution; NaN: no such pool.
  [[nodiscard]] double upstream_level_m() const { return upstream_level_m_; }
  [[nodiscard]] double downstream_level_m() const { return downstream_level_m_; }
  /// Pressure along a channel, as linear pieces with the force and moment of the exact curve.
  [[nodiscard]] Profile profile(std::size_t channel) const;
  /// Pressure at a share 0..1 of a channel.
  [[nodiscard]] double pressure(std::size_t channel, double share) const;
  /// Warnings for the user: the cubic law's limit exceeded, a network without an outlet. Empty: none.
  [[nodiscard]] std::vector<std::string> warnings() const;
  /// Its counts of factorizations made and reused.
  [[nodiscard]] const NetworkFlow& solver() const { return flow_; }

  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);

 private:
  [[nodiscard]] bool flows_full(std::size_t channel) const;
  OpenWater take_in(const std::vector<std::vector<Point>>& outlines, const Point& ground_m, bool moved,
                    std::size_t open_panels, const wire::Load& load);
  void note_dry_mouths(const std::vector<std::vector<Point>>& outlines, const wire::Load& load);
  void solve(double to_s, const wire::Load& load);
  void hold_drains();
  void solve_with_drains(const std::function<void()>& solve);
  [[nodiscard]] bool close_drains_that_supply();
  void carry_over();
  void add_panels(const OpenWater& open, wire::Load& load) const;

  const scene::Scene& scene_;
  WaterProperties water_;
  JointNetwork joints_;
  NetworkFlow flow_;
  Filling filling_;
  std::vector<double> stored_m2_;
  std::vector<Point> solved_at_;  ///< positions of the nodes in filling_
  double time_s_ = 0;
  bool fresh_ = true;
  double upstream_level_m_ = 0;
  double downstream_level_m_ = 0;
  Turbulence turbulence_;
  TransientGuard guard_;
  bool without_outlet_ = false;
  std::size_t dry_mouths_ = 0;  ///< the most at one time
  std::string dry_mouth_;       ///< the warning of them
};

}  // namespace blockweir::joints
