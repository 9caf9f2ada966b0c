// SPDX-License-Identifier: GPL-3.0-or-later
// Loads that are next to nothing beside the weight of the block that bears them: they were meant in another unit.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/magnitudes.hpp"

namespace blockweir::scene {
namespace {

constexpr double least = 1e-3;  // of the weight

double peak(const TimeTable& table) {
  double most = 0;
  for (const double value : table.value) most = std::max(most, std::abs(value));
  return most + (table.sine ? std::abs(table.sine->amplitude) : 0);
}

double peak(const std::array<TimeTable, 2>& force) {
  return std::hypot(peak(force[0]), peak(force[1]));
}

class SmallLoads {
 public:
  SmallLoads(const toml::table& file, const Scene& scene, Problems& problems)
      : file_(file), scene_(scene), problems_(problems) {}

  /// Of a load at this place of its list; `force_n_per_m`: the most that it ever is.
  void look(const char* list, std::size_t n, double force_n_per_m, int block) {
    const toml::node* node = file_[list][n].node();
    const Block& bears = scene_.blocks[at(block)];
    if (node == nullptr || bears.material < 0 || bears.fixed) return;
    const double weight = std::abs(geometry::signed_area(bears.vertices)) *
                          scene_.materials[at(bears.material)].density_kg_per_m3 * scene_.analysis.gravity_m_per_s2;
    if (force_n_per_m <= 0 || force_n_per_m >= least * weight) return;
    problems_.warning(
        problems_.at(node->source()),
        fmt::format("a [[{}]] on block \"{}\" is {:.3g} N per metre at most, {:.2g} of the block's weight, "
                    "which is unusual",
                    list, bears.name, force_n_per_m, force_n_per_m / weight),
        fmt::format("at least {:.3g} N per metre, {:g} of it", least * weight, least),
        "is it in kN, kPa or MN? write newtons and pascals");
  }

 private:
  const toml::table& file_;
  const Scene& scene_;
  Problems& problems_;
};

}  // namespace

void check_small_loads(const toml::table& file, const Scene& scene, Problems& problems) {
  SmallLoads small(file, scene, problems);
  for (std::size_t n = 0; n < scene.point_loads.size(); ++n) {
    const PointLoad& load = scene.point_loads[n];
    small.look("point_load", n, std::hypot(peak(load.force_x_n_per_m), peak(load.force_y_n_per_m)), load.block);
  }
  for (std::size_t n = 0; n < scene.face_pressures.size(); ++n) {
    const FacePressure& load = scene.face_pressures[n];
    const double mean_pa = (peak(load.pressure_from_pa) + peak(load.pressure_to_pa)) / 2;
    small.look("face_pressure", n, mean_pa * (load.to_m - load.from_m).norm(), load.block);
  }
  std::size_t stated = 0;
  for (const LineLoad& load : scene.line_loads) {
    if (load.origin != LoadOrigin::stated) continue;
    const double mean = (peak(load.force_from_n_per_m2) + peak(load.force_to_n_per_m2)) / 2;
    small.look("line_load", stated++, mean * (load.to_m - load.from_m).norm(), load.block);
  }
}

}  // namespace blockweir::scene
