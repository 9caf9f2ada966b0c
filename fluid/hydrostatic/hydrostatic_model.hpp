// SPDX-License-Identifier: GPL-3.0-or-later
// The reference fluid: still water in two pools and in the cracks that the scene fills, at the blocks' positions.
#pragma once

#include <algorithm>
#include <limits>
#include <map>

#include "bridge/schedule/sides.hpp"
#include "fluid/hydrostatic/crack_ends.hpp"
#include "fluid/hydrostatic/crack_meetings.hpp"
#include "fluid/hydrostatic/crack_pools.hpp"
#include "fluid/hydrostatic/nodal_pressures.hpp"
#include "fluid/hydrostatic/pools.hpp"
#include "fluid/hydrostatic/reservoir_mesh.hpp"
#include "fluid/joints/crack_length.hpp"
#include "fluid/joints/flow_in_joints.hpp"

namespace blockweir::hydrostatic {

/// Elements of the reservoir mesh over its depth and along a fully wet edge: those of the load, or more.
inline int elements_drawn(const scene::Water& water) {
  return std::max(water.elements_per_face, 20);
}

/// The section of a body of water, meshed with nodes on the blocks.
struct PoolSection {
  scene::Hydrostatics water;
  std::vector<Ring> region;
  std::vector<InterfaceElement> interface;
};

class HydrostaticModel final : public schedule::FluidSide {
 public:
  explicit HydrostaticModel(const scene::Scene& scene);

  /// Pressures at the levels of time `to_s` for the positions in `motion`. Throws std::runtime_error if `motion` does
  /// not fit the scene.
  void advance(const wire::Motion& motion, double to_s, wire::Load& load) override;
  [[nodiscard]] bool remembers() const override { return !flow_.empty(); }
  [[nodiscard]] std::string state() const override;
  void restore(const std::string& state) override;

  /// The bodies of water of the last advance().
  [[nodiscard]] const std::vector<PoolSection>& sections() const { return sections_; }
  [[nodiscard]] const std::vector<WaterBody>& bodies() const { return bodies_; }
  /// Outlines at the positions received last.
  [[nodiscard]] const std::vector<std::vector<Point>>& outlines() const { return structure_.outlines; }
  /// Of ground that moves as a support, at the positions received last.
  [[nodiscard]] Point ground_displacement() const;
  [[nodiscard]] const joints::FlowInJoints& flow_in_joints() const { return flow_; }
  [[nodiscard]] long updates() const { return updates_; }  ///< windows whose pressures were computed
  [[nodiscard]] schedule::FluidReport report() const override;

 private:
  enum class Flow { solve, repeat };
  void press(double to_s, bool moved, Flow flow, wire::Load& load);
  void place(const wire::Motion& motion);
  void add_body(const WaterBody& body, wire::Load& load);
  /// Whether no block has moved, but with the ground: what has slid or fallen shuts ends of cracks off from their
  /// water.
  [[nodiscard]] bool stands_as_drawn() const;
  void add_cracks(const std::vector<WaterBody>& open, double to_s, wire::Load& load);
  /// The same joint with the open length that its crack's law gives under these forces of open water.
  [[nodiscard]] joints::Joint opened(std::size_t crack, const joints::Joint& joint, double to_s,
                                     const statics::Wrenches& open_water) const;

  const scene::Scene& scene_;
  std::vector<Point> centroids_;
  std::vector<scene::Crack> cracks_;
  std::map<std::size_t, joints::Parted> parted_;  ///< for cracks whose length depends on the forces
  CrackPools crack_pools_;
  CrackEnds crack_ends_;
  CrackMeetings crack_meetings_;
  joints::FlowInJoints flow_;
  Structure structure_;  ///< current
  double crest_drawn_m_ = 0;
  Pools pools_;
  std::vector<WaterBody> bodies_;
  std::vector<PoolSection> sections_;
  wire::Motion last_motion_;
  double last_upstream_m_ = 0;
  double last_downstream_m_ = 0;
  double last_s_ = 0;
  /// Until this time open joints have no uplift; minus infinity: they always have it.
  double shaking_ends_s_ = -std::numeric_limits<double>::infinity();
  bool fresh_ = true;
  long updates_ = 0;
  long unchanged_ = 0;  ///< windows in which neither level nor block moved
  double placing_s_ = 0;
  double update_s_ = 0;
};

}  // namespace blockweir::hydrostatic
