// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths and speeds that a scene does not state follow its structure's size L: lengths as L, speeds as sqrt(g L), as
// in Froude's model law, by which a model is filled in a time that goes as sqrt(L/g).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/scene/read/reading.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::scene {
namespace {

// A dam of 20 m has 0.02 m, 1e-5 m/s, 0.05 m and 1e-9 m.
constexpr double failure_displacement_ratio = 1e-3;  // of L
constexpr double rest_speed_ratio = 7e-7;            // of sqrt(g L)
constexpr double open_crack_ratio = 2.5e-3;          // of L
constexpr double penetration_ratio = 5e-11;          // of L

// Bricks of a large wall move and part by less: at most these shares of a block's typical width.
constexpr double failure_displacement_of_block = 0.1;
constexpr double open_crack_of_block = 0.25;

constexpr double narrowest_crack_ratio = 1e-7;  // of L: below, the loads of still water are lost in its grid

}  // namespace

void resolve_lengths(Reading& reading) {
  Scene& scene = reading.scene;
  const double size_m = structure_size_m(scene.blocks);
  const double width_m = typical_width_m(scene.blocks);
  const double failure_m = std::min(failure_displacement_ratio * size_m, failure_displacement_of_block * width_m);
  const double open_crack_m =
      std::max(std::min(open_crack_ratio * size_m, open_crack_of_block * width_m), 10 * narrowest_crack_ratio * size_m);
  const double gravity = scene.analysis.gravity_m_per_s2 > 0 ? scene.analysis.gravity_m_per_s2 : 9.81;
  const auto stated = [&](const char* section, const char* key) {
    return reading.file[section][key].node() != nullptr;
  };
  const auto resolve = [&](const char* section, const char* key, double& into, double value) {
    if (!stated(section, key)) into = value;
  };
  Analysis& a = scene.analysis;
  resolve("analysis", "failure_displacement_m", a.failure_displacement_m, failure_m);
  resolve("analysis", "rest_speed_m_per_s", a.rest_speed_m_per_s, rest_speed_ratio * std::sqrt(gravity * size_m));
  resolve("contact", "penetration_tolerance_m", scene.contact.penetration_tolerance_m, penetration_ratio * size_m);
  resolve("water", "open_crack_width_m", scene.water.open_crack_width_m, open_crack_m);
  const toml::node* width = reading.file["water"]["open_crack_width_m"].node();
  if (width == nullptr || scene.water.open_crack_width_m >= narrowest_crack_ratio * size_m) return;
  reading.problems.error(
      reading.problems.at(width->source()),
      fmt::format("open_crack_width_m is {:.3g} m in a structure of {:.3g} m", scene.water.open_crack_width_m, size_m),
      fmt::format("at least 1e-7 of the structure's size, {:.2g} m", narrowest_crack_ratio * size_m),
      fmt::format("widen it, or leave it out: it is then {:.2g} m", open_crack_m));
}

}  // namespace blockweir::scene
