// SPDX-License-Identifier: GPL-3.0-or-later
// Loads that grow on ground that dashpots alone hold: it drifts at F over the sum of Z (block/viscous_boundary.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

/// Whether the table ends at another value than it starts with; a load that returns leaves little.
bool lasts(const TimeTable& table, double end_s) {
  constexpr double same = 1e-9;
  const double before = table.rows_at(0);
  const double after = table.rows_at(end_s);
  return std::abs(after - before) > same * std::max(std::abs(before), std::abs(after));
}

/// The first load that does; empty where none does.
std::string lasting_load(const Scene& scene) {
  const double end_s = scene.analysis.duration_s;
  const auto any = [&](const auto&... tables) { return (lasts(tables, end_s) || ...); };
  for (const auto& [level, name] : {std::pair(&scene.water.upstream_level_m, "the upstream level"),
                                    std::pair(&scene.water.downstream_level_m, "the downstream level")}) {
    if (*level && any(**level)) return name;
  }
  for (const PointLoad& load : scene.point_loads) {
    if (any(load.force_x_n_per_m, load.force_y_n_per_m)) return "a [[point_load]]";
  }
  for (const LineLoad& load : scene.line_loads) {
    const auto& [from, to] = std::pair(load.force_from_n_per_m2, load.force_to_n_per_m2);
    if (any(from[0], from[1], to[0], to[1])) return "a [[line_load]]";
  }
  for (const FacePressure& load : scene.face_pressures) {
    if (any(load.pressure_from_pa, load.pressure_to_pa)) return "a [[face_pressure]]";
  }
  for (const BodyLoad& load : scene.body_loads) {
    if (any(load.value[0], load.value[1])) return "a [[body_load]]";
  }
  return {};
}

/// Sum of Z along x: of waves of shear below the model, and of pressure beside it [N s/m per metre].
double resistance_along_x(const Scene& scene) {
  double sum = 0;
  for (const ViscousFace& face : scene.viscous_faces) {
    const Material& m = scene.materials[at(face.material)];
    const double shear_pa = m.youngs_modulus_pa / (2 * (1 + m.poissons_ratio));
    const double ratio = face.is_side() ? 2 * (1 - m.poissons_ratio) / (1 - 2 * m.poissons_ratio) : 1;
    sum += face.length_m() * std::sqrt(ratio * shear_pa * m.density_kg_per_m3);
  }
  return sum;
}

}  // namespace

void check_drift(const Reading& reading) {
  const Scene& scene = reading.scene;
  const bool held = !scene.supports.empty() ||
                    std::any_of(scene.blocks.begin(), scene.blocks.end(), [](const Block& b) { return b.fixed; });
  if (scene.viscous_faces.empty() || scene.analysis.kind != AnalysisKind::dynamic || held) return;
  const std::string load = lasting_load(scene);
  const toml::array* stated = reading.file["viscous_boundary"].as_array();
  if (load.empty() || stated == nullptr || stated->empty()) return;
  reading.problems.warning(
      reading.problems.at((*stated)[0].source()),
      fmt::format("{} changes in the run and stays so, and dashpots bear no load that lasts: each MN per metre more "
                  "along x moves the ground by {:.3g} mm in every second, and it does not come back",
                  load, 1e9 / resistance_along_x(scene)),
      "loads that have their last value from time 0 on, or that come and go",
      "begin with the load's last value, which the ground is held for at time 0; or leave [[viscous_boundary]] out, "
      "with ground that is fixed below, while a load grows");
}

}  // namespace blockweir::scene
