// SPDX-License-Identifier: GPL-3.0-or-later
// Pressures of the water that flows through joints, on what of their faces the mesh does not carry water to.
#pragma once

#include "fluid/joints/flow_beside_mesh.hpp"
#include "fluid/openfoam/edge_elements.hpp"
#include "fluid/openfoam/plugin/immersed_blocks.hpp"

namespace blockweir::openfoam {

/// The network ends where gaps are wider than three cells. Between two and three cells its pressure fades out as that
/// of the sampled water fades in; there it loses next to no head, so that neither the place of its end nor the blend
/// makes a force jump.
class JointFlow {
 public:
  /// Reads constant/blockweirJoints. Trouble ends the run.
  JointFlow(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks);

  /// A sampling begins, of blocks at `poses` and at the load's time.
  void begin(const std::vector<Pose>& poses, const wire::Load& load);
  /// Takes in the panels of `load` from `first` on: they are open water.
  void take_in(const wire::Load& load, std::size_t first);
  /// Solves, and adds the joints' panels, by as much as these elements are closed.
  void add(const std::vector<EdgeElement>& elements, wire::Load& load);

  void record(double time_s);
  [[nodiscard]] bool changes_by_itself() const { return flow_->changes_by_itself(); }
  [[nodiscard]] std::vector<std::string> warnings() const { return flow_->warnings(); }
  [[nodiscard]] std::string state() const { return flow_->state(); }
  void restore(const std::string& state) { flow_->restore(state); }

 private:
  void add_on(const EdgeElement& element, std::size_t panel, wire::Load& load) const;

  const ImmersedBlocks& blocks_;
  std::unique_ptr<joints::FlowBesideMesh> flow_;
  joints::FlowBesideMesh::Outlines outlines_;
  wire::Load water_;  ///< open water, and behind it the joints
};

}  // namespace blockweir::openfoam
