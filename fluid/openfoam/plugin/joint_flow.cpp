// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/joint_flow.hpp"

#include <algorithm>
#include <cfenv>
#include <fstream>
#include <sstream>
#include <tuple>

#include "bridge/wire/panels.hpp"
#include "bridge/wire/placement.hpp"

namespace blockweir::openfoam {
namespace {

/// OpenFOAM ends a program that divides by zero; what ours does with infinities is meant.
class WithoutTraps {
 public:
  WithoutTraps() { std::feholdexcept(&before_); }
  ~WithoutTraps() { std::fesetenv(&before_); }
  WithoutTraps(const WithoutTraps&) = delete;
  WithoutTraps& operator=(const WithoutTraps&) = delete;

 private:
  std::fenv_t before_;
};

/// Runs `action`; what it throws ends the run.
template <class Action>
void or_end(Action action) {
  try {
    const WithoutTraps none;
    action();
  } catch (const std::exception& error) {
    FatalErrorInFunction << error.what() << Foam::exit(Foam::FatalError);
  }
}

std::string bytes_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    FatalErrorInFunction << file.c_str()
                         << ": cannot be read, and water flows through joints; write the case anew with blockweir"
                         << Foam::exit(Foam::FatalError);
  }
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return std::move(bytes).str();
}

bool before(const EdgeElement& element, const std::tuple<int, int, double>& place) {
  return std::tuple(element.block, element.edge, element.s_to) < place;
}

}  // namespace

JointFlow::JointFlow(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks) : blocks_(blocks) {
  const std::string folder = mesh.time().globalPath();
  const double open_m = std::max(open_cells * blocks.cell_m(), blocks.interface().open_crack_width_m);
  or_end([&] {
    flow_ = std::make_unique<joints::FlowBesideMesh>(bytes_of(folder + "/constant/blockweirJoints"), open_m,
                                                     Foam::Pstream::master() ? folder : std::string());
  });
  for (const InterfaceBlock& block : blocks.interface().blocks) outlines_.push_back(block.vertices);
}

/// Where the solid said that they are: blocks in the mesh may lag behind by the tolerance of their cut.
void JointFlow::begin(const std::vector<Pose>& poses, const wire::Load& load) {
  for (std::size_t b = 0; b < outlines_.size(); ++b) {
    const InterfaceBlock& block = blocks_.interface().blocks[b];
    for (std::size_t v = 0; v < outlines_[b].size(); ++v) {
      outlines_[b][v] = wire::place(block.centroid, poses[b], block.vertices[v]);
    }
  }
  wire::clear_panels(water_);
  water_.time_s = load.time_s;
  water_.upstream_level_m = load.upstream_level_m;
  water_.downstream_level_m = load.downstream_level_m;
}

void JointFlow::take_in(const wire::Load& load, std::size_t first) {
  for (std::size_t i = first; i < load.block.size(); ++i) {
    wire::add_panel(water_, static_cast<int>(load.block[i]), static_cast<int>(load.edge[i]), load.s_from[i],
                    load.s_to[i], load.pressure_from_pa[i], load.pressure_to_pa[i]);
  }
}

void JointFlow::add(const std::vector<EdgeElement>& elements, wire::Load& load) {
  const std::size_t open = water_.block.size();
  or_end([&] { flow_->advance(outlines_, water_.time_s, water_); });
  for (std::size_t i = open; i < water_.block.size(); ++i) {
    const std::tuple place(static_cast<int>(water_.block[i]), static_cast<int>(water_.edge[i]), water_.s_from[i]);
    auto element = std::lower_bound(elements.begin(), elements.end(), place, before);
    for (; element != elements.end() && element->block == std::get<0>(place) && element->edge == std::get<1>(place) &&
           element->s_from < water_.s_to[i];
         ++element) {
      add_on(*element, i, load);
    }
  }
}

/// The part of a joint's panel that lies on an element. The network tells the pressure in the middle of the gap.
void JointFlow::add_on(const EdgeElement& e, std::size_t panel, wire::Load& load) const {
  const double closed = 1 - e.openness;
  const double from = std::max(e.s_from, water_.s_from[panel]);
  const double to = std::min(e.s_to, water_.s_to[panel]);
  if (e.slot || closed <= 0 || to <= from) return;
  const double weight = blocks_.interface().water_density * blocks_.interface().gravity;
  const double below_middle = weight * e.gap_m / 2 * e.normal.y();
  const auto pressure = [&](double s) {
    const double share = (s - water_.s_from[panel]) / (water_.s_to[panel] - water_.s_from[panel]);
    const double middle =
        water_.pressure_from_pa[panel] + share * (water_.pressure_to_pa[panel] - water_.pressure_from_pa[panel]);
    return middle > 0 ? closed * std::max(0.0, middle + below_middle) : 0;
  };
  const double p_from = pressure(from);
  const double p_to = pressure(to);
  if (p_from > 0 || p_to > 0) wire::add_panel(load, e.block, e.edge, from, to, p_from, p_to);
}

void JointFlow::record(double time_s) {
  or_end([&] { flow_->record(time_s); });
}

}  // namespace blockweir::openfoam
