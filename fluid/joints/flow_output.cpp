// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/flow_output.hpp"

#include <fmt/format.h>
#include <vtkCellType.h>

#include <algorithm>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/results/csv.hpp"
#include "bridge/results/is_due.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::joints {
namespace {

constexpr const char* rows_file = "flow.csv";
constexpr const char* along_file = "joint_water.csv";

}  // namespace

FlowOutput::FlowOutput(const scene::Scene& scene, std::filesystem::path folder)
    : scene_(scene), folder_(std::move(folder)), frames_(folder_, "flow.pvd") {}

void FlowOutput::record(double time_s, const FlowInJoints& flow) {
  if (results::is_due(time_s, scene_.output.history_every_s, next_row_s_)) add_row(time_s, flow);
  if (!results::is_due(time_s, scene_.output.frame_every_s, next_frame_s_)) return;
  add_pressures(time_s, flow);
  add_frame(time_s, flow);
}

std::string FlowOutput::header() const {
  std::string text = "time_s,from_open_water_m2_per_s,to_open_water_m2_per_s,to_air_m2_per_s";
  for (const scene::DrainLine& drain : scene_.joint_flow.drains) {
    text += "," + results::csv_cell("drain_" + drain.name + "_m2_per_s");
  }
  return text + ",stored_m2,largest_m2_per_s,largest_in_joint";
}

void FlowOutput::add_row(double time_s, const FlowInJoints& flow) {
  if (!rows_) {
    rows_.emplace(folder_ / rows_file);
    rows_->line(header());
  }
  const FlowBalance now = flow.balance();
  std::string row = fmt::format("{:.15g},{},{},{}", time_s, now.from_open_water, now.to_open_water, now.to_air);
  for (const double q : now.to_drain) row += fmt::format(",{}", q);
  const auto& parts = flow.joints().parts();
  const std::string joint =
      parts.empty() ? "" : flow.joints().name(flow.joints().stretches()[parts[now.largest_channel].stretch]);
  rows_->line(row + fmt::format(",{},{},{}", now.stored, now.largest, results::csv_cell(joint)));
}

void FlowOutput::add_pressures(double time_s, const FlowInJoints& flow) {
  if (!along_) {
    along_.emplace(folder_ / along_file);
    along_->line("time_s,joint,x_m,y_m,aperture_m,pressure_pa,flow_m2_per_s");
  }
  const JointNetwork& joints = flow.joints();
  const auto& channels = joints.network().channels;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const Part& part = joints.parts()[c];
    const Stretch& stretch = joints.stretches()[part.stretch];
    const std::array<double, 2> w = {channels[c].aperture(0, flow.pressure(c, 0)),
                                     channels[c].aperture(1, flow.pressure(c, 1))};
    constexpr double straight = 1.05;  // of apertures so alike the curve is a line to the eye
    const int pieces = std::max(w[0], w[1]) > straight * std::min(w[0], w[1]) ? 50 : 1;
    for (int k = 0; k <= pieces; ++k) {
      const double share = static_cast<double>(k) / pieces;
      const Point p = stretch.place(part.from + share * (part.to - part.from));
      along_->line(fmt::format("{:.15g},{},{:.8g},{:.8g},{:.6g},{:.8g},{:.6g}", time_s,
                               results::csv_cell(joints.name(stretch)), p.x(), p.y(), w[0] + share * (w[1] - w[0]),
                               flow.pressure(c, share), flow.filling().flow[c]));
    }
  }
}

void FlowOutput::add_frame(double time_s, const FlowInJoints& flow) {
  vtk::Grid grid;
  auto* pressure = grid.point_data("pressure_pa", 1);
  auto* saturation = grid.point_data("saturation", 1);
  auto* aperture = grid.point_data("aperture_m", 1);
  auto* discharge = grid.cell_data("flow_m2_per_s", 1);
  const JointNetwork& joints = flow.joints();
  const auto& channels = joints.network().channels;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const Stretch& stretch = joints.stretches()[joints.parts()[c].stretch];
    std::vector<vtkIdType> ids;
    for (const int end : {0, 1}) {
      const int node = end == 0 ? channels[c].from : channels[c].to;
      const double p = flow.filling().pressure_pa[at(node)];
      ids.push_back(grid.point(stretch.place(end == 0 ? joints.parts()[c].from : joints.parts()[c].to)));
      pressure->InsertNextValue(p);
      saturation->InsertNextValue(flow.filling().saturation[at(node)]);
      aperture->InsertNextValue(channels[c].aperture(end, p));
    }
    grid.cell(VTK_LINE, ids);
    discharge->InsertNextValue(std::abs(flow.filling().flow[c]));
  }
  frames_.add(grid, fmt::format("flow_{:06d}.vtu", frame_++), time_s, "joints");
  frames_.save();
}

std::string FlowOutput::state() const {
  const auto size = [](const auto& file) { return file ? file->size() : std::uintmax_t{0}; };
  return checkpoint::pack(frames_, next_row_s_, next_frame_s_, frame_, size(rows_), size(along_));
}

void FlowOutput::restore(const std::string& state) {
  std::uintmax_t rows = 0;
  std::uintmax_t along = 0;
  checkpoint::unpack(state, frames_, next_row_s_, next_frame_s_, frame_, rows, along);
  const auto go_on = [&](std::optional<results::ResultFile>& file, const char* name, std::uintmax_t size) {
    if (size == 0) return;
    file.emplace(folder_ / name, results::Begin::where_it_stopped);
    file->cut_to(size);
  };
  go_on(rows_, rows_file, rows);
  go_on(along_, along_file, along);
}

}  // namespace blockweir::joints
