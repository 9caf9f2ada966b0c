// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/flow_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/results/csv.hpp"
#include "bridge/results/is_due.hpp"
#include "bridge/scene/at.hpp"
#include "fluid/joints/uplift_table.hpp"

namespace blockweir::joints {
namespace {

constexpr const char* rows_file = "flow.csv";
constexpr const char* along_file = "joint_water.csv";
constexpr const char* uplifts_file = "joint_uplift.csv";

}  // namespace

FlowTables::FlowTables(const scene::Scene& scene, std::filesystem::path folder)
    : scene_(scene), folder_(std::move(folder)) {}

void FlowTables::record(double time_s, const FlowInJoints& flow) {
  last_ = &flow;
  last_time_s_ = time_s;
  last_row_ = row(time_s, flow);
  has_row_ = results::is_due(time_s, scene_.output.history_every_s, next_row_s_);
  if (has_row_) {
    if (!rows_) {
      rows_.emplace(folder_ / rows_file);
      rows_->line(header());
    }
    rows_->line(last_row_);
  }
  has_frame_ = results::is_due(time_s, scene_.output.frame_every_s, next_frame_s_);
  if (!has_frame_) return;
  add_frame(pressures(time_s, flow), uplifts(time_s, flow));
}

const FlowInJoints* FlowTables::without_frame() const {
  return last_ != nullptr && !has_frame_ && row(last_time_s_, *last_) == last_row_ ? last_ : nullptr;
}

FlowTables::~FlowTables() {
  try {
    if (rows_ && !last_row_.empty() && !has_row_) rows_->line(last_row_);
    if (const FlowInJoints* flow = without_frame()) {
      add_frame(pressures(last_time_s_, *flow), uplifts(last_time_s_, *flow));
    } else if (last_ == nullptr && !kept_pressures_.empty()) {
      add_frame(kept_pressures_, kept_uplifts_);
    }
  } catch (const std::exception&) {
    // A disk that is full has been told of by then.
  }
}

std::string FlowTables::header() const {
  std::string text = "time_s,from_open_water_m2_per_s,to_open_water_m2_per_s,to_air_m2_per_s";
  for (const scene::DrainLine& drain : scene_.joint_flow.drains) {
    text += "," + results::csv_cell("drain_" + drain.name + "_m2_per_s");
  }
  return text + ",stored_m2,largest_m2_per_s,largest_in_joint";
}

std::string FlowTables::row(double time_s, const FlowInJoints& flow) const {
  const FlowBalance now = flow.balance();
  std::string row = fmt::format("{:.15g},{},{},{}", time_s, now.from_open_water, now.to_open_water, now.to_air);
  for (const double q : now.to_drain) row += fmt::format(",{}", q);
  const auto& parts = flow.joints().parts();
  const std::string joint =
      parts.empty() ? "" : flow.joints().name(flow.joints().stretches()[parts[now.largest_channel].stretch]);
  return row + fmt::format(",{},{},{}", now.stored, now.largest, results::csv_cell(joint));
}

void FlowTables::add_frame(const std::string& pressures, const std::string& uplifts) {
  if (!along_) {
    along_.emplace(folder_ / along_file);
    along_->line("time_s,joint,x_m,y_m,aperture_m,pressure_pa,flow_m2_per_s");
  }
  if (!uplifts_) {
    uplifts_.emplace(folder_ / uplifts_file);
    uplifts_->line(
        "time_s,joint,length_m,flow_m2_per_s,reynolds_number,uplift_n_per_m,triangular_n_per_m,drained_n_per_m,"
        "full_n_per_m");
  }
  if (!pressures.empty()) along_->line(pressures);
  if (!uplifts.empty()) uplifts_->line(uplifts);
}

std::string FlowTables::pressures(double time_s, const FlowInJoints& flow) const {
  std::string rows;
  const JointNetwork& joints = flow.joints();
  const auto& channels = joints.network().channels;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const Part& part = joints.parts()[c];
    const Stretch& stretch = joints.stretches()[part.stretch];
    const std::array<double, 2> w = {channels[c].aperture(0, flow.pressure(c, 0)),
                                     channels[c].aperture(1, flow.pressure(c, 1))};
    constexpr double straight = 1.05;  // of apertures so alike the curve is a line to the eye
    constexpr double of_joint = 50;    // between two blocks, of how many channels soever
    const bool curved = std::max(w[0], w[1]) > straight * std::min(w[0], w[1]);
    const int pieces = curved ? static_cast<int>(std::ceil(of_joint * (part.to - part.from) - 1e-9)) : 1;
    for (int k = 0; k <= pieces; ++k) {
      const double share = static_cast<double>(k) / pieces;
      const Point p = stretch.place(part.from + share * (part.to - part.from));
      if (!rows.empty()) rows += "\n";
      rows +=
          fmt::format("{:.15g},{},{:.8g},{:.8g},{:.6g},{:.8g},{:.6g}", time_s, results::csv_cell(joints.name(stretch)),
                      p.x(), p.y(), w[0] + share * (w[1] - w[0]), flow.pressure(c, share), flow.filling().flow[c]);
    }
  }
  return rows;
}

std::string FlowTables::uplifts(double time_s, const FlowInJoints& flow) const {
  std::string rows;
  for (const JointUplift& j : joint_uplifts(scene_, flow)) {
    if (!rows.empty()) rows += "\n";
    rows += fmt::format("{:.15g},{},{:.8g},{:.6g},{:.6g},{:.8g},{:.8g},{},{:.8g}", time_s, results::csv_cell(j.name),
                        j.length_m, j.flow_m2_per_s, j.reynolds, j.uplift_n_per_m, j.triangular_n_per_m,
                        j.drained_n_per_m ? fmt::format("{:.8g}", *j.drained_n_per_m) : "", j.full_n_per_m);
  }
  return rows;
}

std::string FlowTables::state() const {
  const auto size = [](const auto& file) { return file ? file->size() : std::uintmax_t{0}; };
  const FlowInJoints* flow = without_frame();
  const std::string kept_pressures = flow != nullptr ? pressures(last_time_s_, *flow) : "";
  const std::string kept_uplifts = flow != nullptr ? uplifts(last_time_s_, *flow) : "";
  return checkpoint::pack(next_row_s_, next_frame_s_, last_time_s_, last_row_, has_row_, has_frame_, kept_pressures,
                          kept_uplifts, size(rows_), size(along_), size(uplifts_));
}

void FlowTables::restore(const std::string& state) {
  std::uintmax_t rows = 0;
  std::uintmax_t along = 0;
  std::uintmax_t uplifts = 0;
  checkpoint::unpack(state, next_row_s_, next_frame_s_, last_time_s_, last_row_, has_row_, has_frame_, kept_pressures_,
                     kept_uplifts_, rows, along, uplifts);
  const auto go_on = [&](std::optional<results::ResultFile>& file, const char* name, std::uintmax_t size) {
    if (size == 0) return;
    file.emplace(folder_ / name, results::Begin::where_it_stopped);
    file->cut_to(size);
  };
  go_on(rows_, rows_file, rows);
  go_on(along_, along_file, along);
  go_on(uplifts_, uplifts_file, uplifts);
}

}  // namespace blockweir::joints
