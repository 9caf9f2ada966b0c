// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/repeat.hpp"

#include <toml++/toml.h>

#include <sstream>

namespace blockweir::scene {
namespace {

toml::table table_of(const FacePressure& load, const std::vector<Block>& blocks) {
  return toml::table{{"block", blocks[static_cast<std::size_t>(load.block)].name},
                     {"from_m", toml::array{load.from_m.x(), load.from_m.y()}},
                     {"to_m", toml::array{load.to_m.x(), load.to_m.y()}},
                     {"pressure_from_pa", load.pressure_from_pa.at(0)},
                     {"pressure_to_pa", load.pressure_to_pa.at(0)}};
}

/// Uplift is water, too.
void dry(toml::table& file) {
  const auto without_water = [](toml::table* law) {
    for (const char* key : {"uplift", "drain_m", "drain_efficiency", "drain_head_m", "piezometers_m",
                            "piezometers_level_m", "hydraulic_aperture_m", "least_aperture_m", "largest_aperture_m",
                            "aperture_stiffness_pa_per_m", "aperture_pressure_pa"}) {
      if (law != nullptr) law->erase(key);
    }
  };
  without_water(file["joint"].as_table());
  for (const char* list : {"joints", "cut", "joint_set"}) {
    toml::array* laws = file[list].as_array();
    if (laws == nullptr) continue;
    for (toml::node& law : *laws) {
      without_water(law.as_table());
    }
  }
}

}  // namespace

std::string repeat_text(const Scene& scene, double duration_s, const std::vector<FacePressure>& in_place_of_water) {
  toml::table file = toml::parse(scene.text);
  file["analysis"].as_table()->insert_or_assign("duration_s", duration_s);
  for (const char* section : {"water", "fluid", "coupling", "expect", "expect_water", "variant", "load_case", "limit",
                              "order", "map", "bench", "bench_motion", "joint_flow", "drain", "grout"}) {
    file.erase(section);
  }
  dry(file);
  if (!in_place_of_water.empty()) {
    if (!file.contains("face_pressure")) file.insert("face_pressure", toml::array{});
    for (const FacePressure& load : in_place_of_water) {
      if (scene.blocks[static_cast<std::size_t>(load.block)].fixed) continue;
      file["face_pressure"].as_array()->push_back(table_of(load, scene.blocks));
    }
  }
  std::ostringstream text;
  text << file << '\n';
  return text.str();
}

}  // namespace blockweir::scene
