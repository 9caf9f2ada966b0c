// SPDX-License-Identifier: GPL-3.0-or-later
// Pressures of the flow through joints, on faces that the water of the mesh does not reach.
#pragma once

#include "fluid/joints/flow_beside_mesh.hpp"
#include "fluid/openfoam/edge_elements.hpp"
#include "fluid/openfoam/plugin/immersed_blocks.hpp"

namespace blockweir::openfoam {

/// The network ends where gaps are wider than three cells. Between two and three cells its pressure is blended with the
/// sampled one. At these widths the flow loses almost no head, so that neither the position of the end nor the blending
/// makes a force jump.
class JointFlow {
 public:
  /// Reads constant/blockweirJoints. Errors end the run.
  JointFlow(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks);

  /// Starts a sampling for blocks at `poses` and the load's time.
  void begin(const std::vector<Pose>& poses, const wire::Load& load);
  /// Takes the panels of `load` from `first` on as open water.
  void take_in(const wire::Load& load, std::size_t first);
  /// Solves, and adds the joints' panels, weighted by how far these elements are closed.
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
  wire::Load water_;  ///< open water, then the joints
};

}  // namespace blockweir::openfoam
