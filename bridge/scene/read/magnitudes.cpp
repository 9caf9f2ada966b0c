// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/magnitudes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <tuple>

#include "bridge/scene/structure_size.hpp"

namespace blockweir::scene {
namespace {

constexpr bool grows_with_size = true;
constexpr bool may_glue = true;
constexpr double most_of_glue = 1e12;
constexpr const char* bonds = "joints of dams have 0 to 3e6, sound rock up to 5e7; 5e8 and more glues blocks together";
constexpr const char* law_sections[] = {"joint", "joints[]", "cut[]", "joint_set[]"};

constexpr Unit percent = {"percent", 0.01};
constexpr Unit radians = {"radians", 180 / std::numbers::pi};
constexpr Unit kilopascals = {"kPa", 1e3};
constexpr Unit megapascals = {"MPa", 1e6};
constexpr Unit gigapascals = {"GPa", 1e9};
constexpr Unit tonnes = {"t/m3", 1000};
constexpr Unit kilonewtons = {"kN/m", 1e3};
constexpr Unit meganewtons = {"MN/m", 1e6};

constexpr Magnitude table_of_magnitudes[] = {
    {"material.*", "density_kg_per_m3", "kg/m3", 100, 20'000, {tonnes, {"kN/m3", 1000 / 9.81}}},
    {"material.*", "youngs_modulus_pa", "Pa", 1e6, 1e13, {gigapascals, megapascals, kilopascals}, "", grows_with_size},
    {"material.*", "poissons_ratio", "", 0.01, 0.45, {percent}, "rock and concrete have 0.1 to 0.3"},
    {"material.*", "damping_ratio", "", 1e-4, 0.3, {percent}, "5 % is 0.05"},
    {"analysis", "gravity_m_per_s2", "m/s2", 9, 10, {{"cm/s2", 0.01}}, "more is meant in a centrifuge only"},
    {"analysis", "gravity_tilt_deg", "deg", 0.5, 90, {radians}},
    {"analysis", "duration_s", "s", 1e-6, 1e7, {}, "a year is 3e7 s: a run makes each of its steps"},
    {"analysis", "step_s", "s", 1e-9, 100, {}, "dynamic motions of dams take milliseconds to seconds"},
    {"analysis", "max_displacement_ratio", "", 1e-6, 1, {percent}, "1 % is 0.01"},
    {"analysis", "rest_speed_m_per_s", "m/s", 1e-12, 0.01, {}, "what moves faster than this does not count as at rest"},
    {"analysis", "residual_tolerance", "", 1e-15, 1e-3, {percent}},
    {"contact", "force_tolerance", "", 1e-15, 1e-3, {percent}, "contact forces are found to this share of the largest"},
    {"load_case[]", "required_factor", "", 0.5, 20, {percent}, "guidelines ask for 1 to 4"},
    {"joint", "friction_angle_deg", "deg", 2, 80, {radians}},
    {"joint", "residual_friction_angle_deg", "deg", 2, 80, {radians}},
    {"joint", "dilation_angle_deg", "deg", 0.5, 45, {radians}},
    {"joint", "cohesion_pa", "Pa", 1000, 5e7, {kilopascals, megapascals}, bonds, grows_with_size, may_glue},
    {"joint", "tension_strength_pa", "Pa", 1000, 5e7, {megapascals, kilopascals}, bonds, grows_with_size, may_glue},
    {"joint", "roughness", "", 0.5, 20, {}, "JRC is 2 for smooth joints, 20 for the roughest"},
    {"joint", "wall_strength_pa", "Pa", 1e6, 5e8, {megapascals, kilopascals}},
    {"water", "density_kg_per_m3", "kg/m3", 500, 2000, {tonnes, {"kN/m3", 1000 / 9.81}}},
    {"water", "atmospheric_pressure_pa", "Pa", 3e4, 1.2e5, {kilopascals, {"hPa", 100}, {"bar", 1e5}}},
    {"ice", "thickness_m", "m", 0.1, 2, {{"cm", 0.01}, {"mm", 0.001}}},
    {"ice", "thrust_n_per_m", "N/m", 5e3, 2e6, {kilonewtons, meganewtons}, "", grows_with_size},
    {"earthquake", "horizontal_coefficient", "", 1e-3, 0.6, {{"m/s2", 1 / 9.81}, percent}, "a share of gravity"},
    {"earthquake", "vertical_coefficient", "", 1e-3, 0.6, {{"m/s2", 1 / 9.81}, percent}, "a share of gravity"},
    {"silt", "submerged_density_kg_per_m3", "kg/m3", 100, 2000, {{"kN/m3", 1000 / 9.81}, tonnes}},
    {"bolt[]", "prestress_n_per_m", "N/m", 2000, 1e8, {kilonewtons, meganewtons}, "", grows_with_size},
    {"bolt[]", "yield_n_per_m", "N/m", 2000, 1e9, {kilonewtons, meganewtons}, "", grows_with_size},
    {"bolt[]", "youngs_modulus_pa", "Pa", 1e9, 1e12, {gigapascals, megapascals}},
    {"bolt[]", "area_m2_per_m", "m2/m", 1e-9, 0.5, {{"mm2", 1e-6}, {"cm2", 1e-4}}},
};

/// Whether a row of [joint] goes for the other laws, too.
std::vector<const char*> sections_of(const Magnitude& row) {
  if (row.section == std::string("joint")) return {std::begin(law_sections), std::end(law_sections)};
  return {row.section};
}

/// Calls see(name for messages, table) for each table that a section stands for.
void each_table(const toml::table& file, std::string section,
                const std::function<void(const std::string&, const toml::table&)>& see) {
  if (section.ends_with(".*")) {
    section.resize(section.size() - 2);
    const toml::table* tables = file[section].as_table();
    if (tables == nullptr) return;
    for (const auto& [name, node] : *tables) {
      if (node.is_table()) see(fmt::format("[{}.{}]", section, name.str()), *node.as_table());
    }
  } else if (section.ends_with("[]")) {
    section.resize(section.size() - 2);
    const toml::array* list = file[section].as_array();
    if (list == nullptr) return;
    for (const toml::node& node : *list) {
      if (!node.is_table()) continue;
      const auto name = (*node.as_table())["name"].value<std::string>();
      see(fmt::format("[[{}]] \"{}\"", section, name.value_or("")), *node.as_table());
    }
  } else if (const toml::table* table = file[section].as_table()) {
    see(fmt::format("[{}]", section), *table);
  }
}

/// What no calculation with doubles bears, or no matter has. Numbers without a unit have ranges of their own.
struct Bounds {
  double least;
  double most;
};

Bounds bounds_of(const Magnitude& row) {
  constexpr double beyond = 1e6;  // the usual
  if (*row.unit == '\0') return {0, std::numeric_limits<double>::infinity()};
  const bool is_of_matter = std::string(row.section) == "material.*" || std::string(row.key).starts_with("density");
  return {is_of_matter ? row.least / beyond : 0, beyond * (row.may_glue ? most_of_glue : row.most)};
}

void check_row(const Magnitude& row, double least, const toml::table& file, Problems& problems) {
  const std::string unit = *row.unit == '\0' ? "" : std::string(" ") + row.unit;
  const Bounds bounds = bounds_of(row);
  for (const char* section : sections_of(row)) {
    each_table(file, section, [&](const std::string& name, const toml::table& table) {
      const toml::node* node = table.get(row.key);
      const auto value = node == nullptr || !node->is_number() ? std::nullopt : node->value<double>();
      const double size = std::abs(value.value_or(0));  // a tilt may be to either side
      const bool glues = row.may_glue && size >= 5e8 && size <= most_of_glue;
      if (size == 0 || glues || (size >= least && size <= row.most)) return;
      if (std::isinf(size)) return;  // an error already
      if (size < bounds.least || size > bounds.most) {
        return problems.error(problems.at(node->source()),
                              fmt::format("{} in {} is {:.6g}{}", row.key, name, *value, unit),
                              fmt::format("{:.3g} to {:.3g}{}, usually {:.3g} to {:.3g}", bounds.least, bounds.most,
                                          unit, least, row.most),
                              likely_meaning(row, *value));
      }
      problems.warning(problems.at(node->source()),
                       fmt::format("{} in {} is {:.6g}{}, which is unusual", row.key, name, *value, unit),
                       fmt::format("{:.3g} to {:.3g}{}", least, row.most, unit), likely_meaning(row, *value));
    });
  }
}

/// A run of so many windows, frames or rows would not end.
void check_counts(const toml::table& file, const Scene& scene, Problems& problems) {
  constexpr double most = 1e8;
  // Of frames and rows those are counted that a step passes over.
  const double rows = 1e6 * scene.analysis.duration_s / scene.analysis.step_s;
  for (const auto& [section, key, every_s, countable] :
       {std::tuple{"coupling", "window_s", scene.coupling.window_s, 1e15},
        {"output", "frame_every_s", scene.output.frame_every_s, rows},
        {"output", "history_every_s", scene.output.history_every_s, rows}}) {
    const toml::node* node = file[section][key].node();
    const double count = scene.analysis.duration_s / every_s;
    if (node == nullptr || count <= most) continue;
    const std::string found = fmt::format("{} in [{}] is {:.3g} s: {:.2g} of them in duration_s = {:.3g}", key, section,
                                          every_s, count, scene.analysis.duration_s);
    const std::string expected = fmt::format("at most {:.0e} in a run", count > countable ? countable : most);
    const std::string remedy = fmt::format("lengthen {} to {:.2g} s, the step, or more", key, scene.analysis.step_s);
    if (count > countable) {
      problems.error(problems.at(node->source()), found, expected, remedy);
    } else {
      problems.warning(problems.at(node->source()), found + ", which is unusual", expected, remedy);
    }
  }
}

/// What moves by a good part of a structure in water has failed. Without water blocks may be made to bounce and roll.
void check_lengths(const toml::table& file, const Scene& scene, double size_m, Problems& problems) {
  for (const auto& [section, key, length_m, most_ratio] :
       {std::tuple{"analysis", "failure_displacement_m", scene.analysis.failure_displacement_m,
                   still_pools(scene.fluid) ? 0.2 : 100},
        {"contact", "penetration_tolerance_m", scene.contact.penetration_tolerance_m, 1e-4}}) {
    const toml::node* node = file[section][key].node();
    if (node == nullptr || length_m <= most_ratio * size_m) continue;
    problems.warning(problems.at(node->source()),
                     fmt::format("{} in [{}] is {:.3g} m in a structure of {:.3g} m, which is unusual", key, section,
                                 length_m, size_m),
                     fmt::format("up to {:.2g} m, {:g} of the structure's size", most_ratio * size_m, most_ratio),
                     length_m / 1000 <= most_ratio * size_m
                         ? fmt::format("if it is in mm, write {:.4g}", length_m / 1000)
                         : "shorten it, or leave it out");
  }
}

/// What is far longer than the structure has no effect in it.
void check_spacings(const toml::table& file, double size_m, Problems& problems) {
  constexpr double most = 20;  // in millimetres it is a thousand times as long
  for (const auto& [section, key, effect] :
       {std::tuple{"joint_set[]", "spacing_m", "one of its joints at most crosses it"},
        {"joint", "bonded_length_m", "no joint is that long"},
        {"block[]", "mesh_size_m", "the mesh is as if it were not stated"}}) {
    each_table(file, section, [&, key = key, effect = effect](const std::string& name, const toml::table& table) {
      const toml::node* node = table.get(key);
      const auto length_m = node == nullptr || !node->is_number() ? std::nullopt : node->value<double>();
      if (!length_m || *length_m <= most * size_m) return;
      problems.warning(problems.at(node->source()),
                       fmt::format("{} in {} is {:.4g} m in a structure of {:.3g} m, which is unusual: {}", key, name,
                                   *length_m, size_m, effect),
                       fmt::format("up to {:.3g} m, {:g} times its size", most * size_m, most),
                       fmt::format("if it is in mm, write {:.4g}", *length_m / 1000));
    });
  }
}

/// A run of so many steps would not end.
void check_steps(const toml::table& file, const Scene& scene, Problems& problems) {
  constexpr double most = 1e8;
  const double steps = scene.analysis.duration_s / scene.analysis.step_s;
  if (steps <= most) return;
  const toml::node* stated = file["analysis"]["duration_s"].node();
  if (stated == nullptr) stated = file["analysis"]["step_s"].node();
  constexpr double countable = 1e15;
  if (steps > countable) {
    return problems.error(problems.at(stated->source()),
                          fmt::format("duration_s {:.3g} in steps of {:.3g} s takes {:.2g} steps",
                                      scene.analysis.duration_s, scene.analysis.step_s, steps),
                          fmt::format("at most {:.0e} steps", countable), "shorten duration_s, or lengthen step_s");
  }
  problems.warning(problems.at(stated->source()),
                   fmt::format("duration_s {:.3g} in steps of {:.3g} s takes {:.2g} steps, which is unusual",
                               scene.analysis.duration_s, scene.analysis.step_s, steps),
                   fmt::format("at most {:.0e} steps", most), "shorten duration_s, or lengthen step_s");
}

void check_size(const Scene& scene, double size_m, Problems& problems) {
  constexpr double least_m = 1e-3;
  constexpr double most_m = 5000;
  if (size_m >= least_m && size_m <= most_m) return;
  problems.warning(problems.at(scene.blocks.front().line),
                   fmt::format("the structure is {:.4g} m large, which is unusual", size_m),
                   fmt::format("{} to {} m", least_m, most_m),
                   size_m > most_m ? "are its coordinates in millimetres? write metres"
                                   : "are its coordinates in kilometres? write metres");
}

void check_crack_width(const toml::table& file, const Scene& scene, double size_m, Problems& problems) {
  constexpr double most_ratio = 0.05;
  const toml::node* node = file["water"]["open_crack_width_m"].node();
  if (node == nullptr || scene.water.open_crack_width_m <= most_ratio * size_m) return;
  problems.warning(problems.at(node->source()),
                   fmt::format("open_crack_width_m is {:.3g} m in a structure of {:.3g} m, which is unusual: water in "
                               "narrower gaps is left out",
                               scene.water.open_crack_width_m, size_m),
                   fmt::format("up to {:.2g} m, 1/20 of the structure's size", most_ratio * size_m),
                   "narrow it, or leave it out");
}

/// 30 in GPa is 30e9, 2.4 in t/m3 is 2400.
std::string in_own_unit(double value, double size) {
  constexpr double long_number = 1e5;
  const double power = std::round(std::log10(size));
  const bool by_power = std::abs(value * size) >= long_number && std::pow(10, power) == size;
  return by_power ? fmt::format("{:.6g}e{:.0f}", value, power) : fmt::format("{:.4g}", value * size);
}

}  // namespace

std::span<const Magnitude> magnitudes() {
  return table_of_magnitudes;
}

std::string likely_meaning(const Magnitude& row, double value) {
  std::string text;
  for (const Unit& unit : row.units) {
    if (unit.name == nullptr || std::abs(value) * unit.size < row.least || std::abs(value) * unit.size > row.most) {
      continue;
    }
    text = fmt::format("if it is in {}, write {}", unit.name, in_own_unit(value, unit.size));
    break;
  }
  if (text.empty()) return *row.remark == '\0' ? "check its unit" : row.remark;
  return *row.remark == '\0' ? text : fmt::format("{}; {}", text, row.remark);
}

void check_ranges(const toml::table& file, double size_m, Problems& problems) {
  for (const Magnitude& row : table_of_magnitudes) {
    const double shrunk = row.grows_with_size ? std::min(1.0, size_m / 10) : 1;
    check_row(row, shrunk * row.least, file, problems);
  }
}

void check_magnitudes(const toml::table& file, const Scene& scene, Problems& problems) {
  const double size_m = structure_size_m(scene.blocks);
  check_ranges(file, size_m, problems);
  check_steps(file, scene, problems);
  check_counts(file, scene, problems);
  check_lengths(file, scene, size_m, problems);
  check_spacings(file, size_m, problems);
  check_size(scene, size_m, problems);
  check_crack_width(file, scene, size_m, problems);
  check_proportions(file, scene, problems);
  check_levels(file, scene, problems);
  check_small_loads(file, scene, problems);
  check_gaps(scene, problems);
  check_hovering(scene, problems);
  check_corner_stands(scene, problems);
  check_crumbs(scene, problems);
}

}  // namespace blockweir::scene
