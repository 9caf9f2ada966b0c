// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/flow_output.hpp"

#include <fmt/format.h>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/results/is_due.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::joints {

FlowOutput::FlowOutput(const scene::Scene& scene, const std::filesystem::path& folder)
    : scene_(scene), tables_(scene, folder), frames_(folder, "flow.pvd") {}

FlowOutput::~FlowOutput() {
  try {
    if (const FlowInJoints* flow = tables_.without_frame()) add_frame(tables_.last_time_s(), *flow);
  } catch (const std::exception&) {
    // A disk that is full has been told of by then.
  }
}

void FlowOutput::record(double time_s, const FlowInJoints& flow) {
  tables_.record(time_s, flow);
  if (results::is_due(time_s, scene_.output.frame_every_s, next_frame_s_)) add_frame(time_s, flow);
}

void FlowOutput::add_frame(double time_s, const FlowInJoints& flow) {
  vtk::Grid grid;
  vtk::Array& pressure = grid.point_data("pressure_pa", 1);
  vtk::Array& saturation = grid.point_data("saturation", 1);
  vtk::Array& aperture = grid.point_data("aperture_m", 1);
  vtk::Array& discharge = grid.cell_data("flow_m2_per_s", 1);
  const JointNetwork& joints = flow.joints();
  const auto& channels = joints.network().channels;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const Stretch& stretch = joints.stretches()[joints.parts()[c].stretch];
    std::vector<vtk::Id> ids;
    for (const int end : {0, 1}) {
      const int node = end == 0 ? channels[c].from : channels[c].to;
      const double p = flow.filling().pressure_pa[at(node)];
      ids.push_back(grid.point(stretch.place(end == 0 ? joints.parts()[c].from : joints.parts()[c].to)));
      pressure.add(p);
      saturation.add(flow.filling().saturation[at(node)]);
      aperture.add(channels[c].aperture(end, p));
    }
    grid.cell(vtk::Cell::line, ids);
    discharge.add(std::abs(flow.filling().flow[c]));
  }
  frames_.add(grid, fmt::format("flow_{:06d}.vtu", frame_++), time_s, "joints");
  frames_.save();
}

std::string FlowOutput::state() const {
  return checkpoint::pack(tables_.state(), frames_, next_frame_s_, frame_);
}

void FlowOutput::restore(const std::string& state) {
  std::string tables;
  checkpoint::unpack(state, tables, frames_, next_frame_s_, frame_);
  tables_.restore(tables);
}

}  // namespace blockweir::joints
