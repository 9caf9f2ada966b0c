// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/flow_beside_mesh.hpp"

#include <optional>

#include "bridge/checkpoint/archive.hpp"
#include "fluid/joints/flow_scene.hpp"
#include "fluid/joints/flow_tables.hpp"

namespace blockweir::joints {

struct FlowBesideMesh::Parts {
  Parts(FlowScene packed, double open_m, const std::string& folder)
      : scene(std::move(packed)), flow(scene.scene, scene.ground, open_m) {
    if (!folder.empty()) tables.emplace(scene.scene, folder);
  }
  FlowScene scene;
  FlowInJoints flow;
  std::optional<FlowTables> tables;
  Outlines last;
};

FlowBesideMesh::FlowBesideMesh(const std::string& scene, double open_m, const std::string& folder)
    : parts_(std::make_unique<Parts>(unpack_flow_scene(scene), open_m, folder)) {}

FlowBesideMesh::~FlowBesideMesh() = default;

void FlowBesideMesh::advance(const Outlines& outlines, double to_s, wire::Load& load) {
  const bool moved = outlines != parts_->last;
  if (moved) parts_->last = outlines;
  parts_->flow.advance(outlines, Point::Zero(), moved, to_s, load.block.size(), load);
}

void FlowBesideMesh::record(double time_s) {
  if (parts_->tables) parts_->tables->record(time_s, parts_->flow);
}

bool FlowBesideMesh::changes_by_itself() const {
  return parts_->flow.changes_by_itself();
}

std::vector<std::string> FlowBesideMesh::warnings() const {
  return parts_->flow.warnings();
}

std::string FlowBesideMesh::state() const {
  return checkpoint::pack(parts_->flow.state(), parts_->tables ? parts_->tables->state() : std::string());
}

void FlowBesideMesh::restore(const std::string& state) {
  std::string flow;
  std::string tables;
  checkpoint::unpack(state, flow, tables);
  parts_->flow.restore(flow);
  if (parts_->tables && !tables.empty()) parts_->tables->restore(tables);
}

}  // namespace blockweir::joints
