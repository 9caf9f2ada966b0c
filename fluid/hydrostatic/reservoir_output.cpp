// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/reservoir_output.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/results/is_due.hpp"
#include "bridge/results/saving.hpp"
#include "bridge/results/stopwatch.hpp"

namespace blockweir::hydrostatic {
namespace {

constexpr const char* part_name = "reservoir";

/// Height of the water over its lowest point [m].
double depth(const PoolSection& pool) {
  double lowest = pool.water.level_m;
  for (const Ring& ring : pool.region) {
    for (const Point& p : ring) lowest = std::min(lowest, p.y());
  }
  return pool.water.level_m - lowest;
}

void add(const ReservoirMesh& mesh, const scene::Hydrostatics& water, vtk::Grid& grid, vtk::Array& pressure) {
  std::vector<vtk::Id> ids;
  for (const Point& p : mesh.node) {
    ids.push_back(grid.point(p));
    pressure.add(water.pressure(std::min(p.y(), water.level_m)));
  }
  for (const auto& t : mesh.triangle) grid.cell(vtk::Cell::triangle, {ids[t[0]], ids[t[1]], ids[t[2]]});
}

}  // namespace

void require_folder_of_pictures(const scene::Scene& scene, const std::filesystem::path& folder) {
  if (!scene.output.reservoir || !folder.empty()) return;
  throw std::invalid_argument(
      "[output] reservoir = true, and no --out: say with --out where the files of the reservoir go");
}

RecordedModel::RecordedModel(const scene::Scene& scene, const std::filesystem::path& folder)
    : model_(scene),
      draws_(scene.output.reservoir),
      files_(folder, "reservoir.pvd"),
      frame_every_s_(scene.output.frame_every_s),
      elements_per_depth_(elements_drawn(scene.water)) {
  if (scene::flows_in_joints(scene)) flow_.emplace(scene, folder);
}

void RecordedModel::advance(const wire::Motion& motion, double to_s, wire::Load& load) {
  model_.advance(motion, to_s, load);
  if (draws_) load.holds_until_s = to_s;  // there is a picture to take
}

void RecordedModel::record(double time_s) {
  if (flow_) flow_->record(time_s, model_.flow_in_joints());
  if (draws_ && results::is_due(time_s, frame_every_s_, next_s_)) write(time_s);
}

schedule::FluidReport RecordedModel::report() const {
  schedule::FluidReport report = model_.report();
  if (!draws_) return report;
  report.counts["meshes"] = meshes_;
  if (repeats_ > 0) {
    report.skips.push_back(fmt::format("{} of {} meshes of the reservoir: neither a level nor a block had moved{}",
                                       repeats_, repeats_ + meshes_, results::saved(meshing_s_, meshes_, repeats_)));
  }
  return report;
}

std::string RecordedModel::state() const {
  return checkpoint::pack(model_.state(), flow_ ? flow_->state() : "", files_, next_s_, last_file_, written_update_,
                          meshes_, repeats_);
}

void RecordedModel::restore(const std::string& state) {
  std::string of_model;
  std::string of_flow;
  checkpoint::unpack(state, of_model, of_flow, files_, next_s_, last_file_, written_update_, meshes_, repeats_);
  model_.restore(of_model);
  if (flow_) flow_->restore(of_flow);
}

void RecordedModel::write(double time_s) {
  if (model_.updates() == written_update_) {
    files_.repeat(last_file_, time_s, part_name);
    ++repeats_;
  } else {
    const Stopwatch watch(meshing_s_);
    vtk::Grid grid;
    vtk::Array& pressure = grid.point_data("pressure_pa", 1);
    for (const PoolSection& pool : model_.sections()) {
      const double near_m = 1e-6 * depth(pool);
      add(mesh_reservoir(pool.region, pool.interface, depth(pool) / elements_per_depth_, near_m), pool.water, grid,
          pressure);
    }
    last_file_ = fmt::format("reservoir_{:06d}.vtu", meshes_++);
    files_.add(grid, last_file_, time_s, part_name);
    written_update_ = model_.updates();
  }
  files_.save();
}

}  // namespace blockweir::hydrostatic
