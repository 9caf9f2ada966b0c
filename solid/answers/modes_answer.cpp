// SPDX-License-Identifier: GPL-3.0-or-later
// Natural modes of a scene's structure at rest, without water and with it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "bridge/process/answers.hpp"
#include "solid/answers/answer_entries.hpp"
#include "solid/capacity/situation.hpp"
#include "solid/capacity/static_blocks.hpp"
#include "solid/modes/natural_modes.hpp"
#include "solid/modes/structure.hpp"

namespace blockweir::process {
namespace {

using nlohmann::json;
using solid::NaturalMode;
using solid::Structure;

/// Frequency of a wave across the structure, in its order of magnitude.
double typical_omega(const solid::Solid& blocks) {
  double lightest = std::numeric_limits<double>::infinity();
  for (const solid::Block& block : blocks.blocks()) {
    if (!block.fixed && block.area > 0) lightest = std::min(lightest, block.mass_per_m() / block.area);
  }
  return std::sqrt(solid::largest_modulus(blocks) / lightest) / blocks.model().size_m;
}

/// Outlines of what moves, each point with its displacement.
json shape_json(const solid::Solid& blocks, const Structure& structure, const Eigen::VectorXd& q) {
  json shape = json::array();
  for (std::size_t b = 0; b < blocks.described(); ++b) {
    if (blocks.blocks()[b].fixed) continue;
    json points = json::array();
    for (const solid::OutlineSide& side : blocks.parts().outlines[b]) {
      const solid::Point& material = blocks.parts().vertex(side);
      const auto part = static_cast<std::size_t>(side.part);
      const solid::Point x = blocks.placements()[part].position(material);
      const solid::Point u = structure.displacement(side.part, material, q);
      points.push_back({x.x(), x.y(), u.x(), u.y()});
    }
    shape.push_back({{"block", blocks.blocks()[b].name}, {"points_m", std::move(points)}});
  }
  return shape;
}

/// The share of all that moves that follows the ground in this mode, along x and y.
std::array<double, 2> following_shares(const Structure& structure, const NaturalMode& mode) {
  std::array<double, 2> shares{};
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::VectorXd ground = structure.mass() * structure.translation(axis);
    const double all = structure.translation(axis).dot(ground);
    const double own = mode.shape.dot(structure.mass() * mode.shape);  // below 1 where water moves along
    shares[static_cast<std::size_t>(axis)] = std::pow(mode.shape.dot(ground), 2) / own / all;
  }
  return shares;
}

json modes_json(const solid::Solid& blocks, const Structure& structure, const std::vector<NaturalMode>& modes) {
  json all = json::array();
  for (const NaturalMode& mode : modes) {
    const auto [x, y] = following_shares(structure, mode);
    json row = {{"omega_rad_per_s", mode.omega_rad_per_s},
                {"frequency_hz", mode.omega_rad_per_s / (2 * std::numbers::pi)},
                {"mass_share_x", x},
                {"mass_share_y", y},
                {"shape", shape_json(blocks, structure, mode.shape)}};
    row["period_s"] = mode.omega_rad_per_s > 0 ? json(2 * std::numbers::pi / mode.omega_rad_per_s) : json();
    all.push_back(std::move(row));
  }
  return all;
}

json joints_json(const solid::Solid& blocks) {
  std::array<long, 3> count{};
  for (const solid::ContactPoint& c : blocks.contacts()) ++count[static_cast<std::size_t>(c.state)];
  return {{"open", count[0]}, {"stick", count[1]}, {"slip", count[2]}};
}

/// Water sees the blocks as drawn: displacements by springs and round-off must not open a way for it.
wire::Motion as_drawn(const solid::Solid& blocks) {
  wire::Motion motion;
  motion.displacement.own().resize(blocks.described());
  motion.velocity.own().resize(blocks.described());
  return motion;
}

std::vector<std::string> warnings_of(const solid::Solid& blocks, const json& modes) {
  std::vector<std::string> warnings;
  const auto free = std::count_if(modes.begin(), modes.end(), [](const json& m) { return m["omega_rad_per_s"] == 0; });
  if (free > 0) {
    warnings.push_back(std::to_string(free) +
                       " motions have no frequency: no joint, bolt or support holds them, as where a joint slips or "
                       "blocks touch at one corner");
  }
  if (!blocks.model().boundary.empty()) {
    warnings.push_back(
        "[[viscous_boundary]] is held fast here: the ground beyond has no modes, and waves do not leave");
  }
  const auto even = std::find_if(blocks.blocks().begin(), blocks.blocks().end(), [](const solid::Block& block) {
    return !block.fixed && !block.rigid && !block.meshed && !block.is_part();
  });
  if (even != blocks.blocks().end()) {
    warnings.push_back("block \"" + even->name +
                       "\" has no mesh and strains evenly, too stiff in bending: state mesh_size_m, or rigid = true");
  }
  return warnings;
}

std::string does_not_rest(double level_m) {
  const std::string found = "the structure does not come to rest under its loads";
  const std::string expected = "; expected one that stands, of which natural modes are small motions; ";
  if (std::isnan(level_m)) return found + expected + "run the scene to see what moves";
  return fmt::format(
      "{}, at a level of {:.6g} m, the last of the run{}set a lower one, as by --set "
      "water.upstream_level_m=...; \"blockweir level\" finds the one at which it fails",
      found, level_m, expected);
}

}  // namespace

json modes_answer(const scene::Scene& given, const FluidMaker& make_fluid, const WaterMass& water_mass) {
  constexpr int count = 10;
  scene::Scene scene = given;
  if (scene.analysis.rigid == scene::Rigid::automatic) scene.analysis.rigid = scene::Rigid::named;
  solid::Situation now(scene, make_fluid);
  solid::SearchBudget effort("rest");
  if (std::all_of(scene.blocks.begin(), scene.blocks.end(), [](const scene::Block& block) { return block.fixed; })) {
    throw std::invalid_argument("all blocks are fixed; expected one that moves");
  }
  solid::StaticBlocks at_rest(scene, now.water_if_any(), effort);
  if (!at_rest.begin(now.level_m)) {
    throw std::runtime_error(does_not_rest(now.level_m));
  }
  const solid::Solid& blocks = at_rest.solid();
  const Structure structure(blocks);
  const double typical = typical_omega(blocks);
  json answer = {{"level_m", std::isnan(now.level_m) ? json() : json(now.level_m)},
                 {"unknowns", structure.unknowns()},
                 {"contacts", joints_json(blocks)}};
  const auto found = [&](const Eigen::SparseMatrix<double>& mass) {
    return modes_json(blocks, structure, solid::natural_modes(structure.stiffness(), mass, count, typical));
  };
  answer["dry"] = found(structure.mass());
  if (now.water) {
    const Eigen::SparseMatrix<double> water =
        water_mass(scene, as_drawn(blocks), structure.unknowns(),
                   [&](const FacePoint& point) { return structure.motion_of(point); });
    answer["wet"] = found(structure.mass() + water);
  }
  if (answer["dry"].empty()) {
    throw std::runtime_error(
        "nothing swings: found rigid blocks on rigid supports; expected blocks that strain, or bolts; state "
        "youngs_modulus_pa without rigid, or a [[bolt]]");
  }
  answer["warnings"] = warnings_of(blocks, answer["dry"]);
  return answer;
}

}  // namespace blockweir::process
