// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of a scene file, one function each.
#include "bridge/scene/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "bridge/scene/check.hpp"
#include "bridge/scene/overrides.hpp"
#include "bridge/scene/polygon.hpp"
#include "bridge/scene/table_reader.hpp"

namespace blockweir::scene {
namespace {

constexpr std::uintmax_t largest_file = 16U << 20U;

/// The file as tables, with the names that other sections refer to.
struct File {
  toml::table& tables;
  Problems& problems;
  Scene& scene;
  std::vector<std::string> materials{};
  std::vector<std::string> blocks{};
  std::vector<std::string> joints{};
  std::vector<std::string> asked{};

  const toml::table* section(const char* name) {
    asked.emplace_back(name);
    const toml::node* node = tables.get(name);
    if (node == nullptr) return nullptr;
    if (!node->is_table())
      problems.error(line_of(*node), fmt::format("{} is not a section", name), fmt::format("[{}]", name));
    return node->as_table();
  }

  /// Calls read(table) for each [[name]].
  template <class Read>
  void each(const char* name, Read read) {
    asked.emplace_back(name);
    const toml::node* node = tables.get(name);
    if (node == nullptr) return;
    const toml::array* list = node->as_array();
    if (list == nullptr || !list->is_array_of_tables()) {
      return problems.error(line_of(*node), fmt::format("{} is not a list of sections", name),
                            fmt::format("[[{}]]", name));
    }
    int index = 0;
    for (const auto& entry : *list) {
      TableReader table(problems, entry.as_table(), fmt::format("[[{}]] number {}", name, ++index));
      read(table);
    }
  }
};

void read_law(TableReader& table, JointLaw& law) {
  const Range angle = between(0, 90, "an angle in degrees, at least 0 and below 90");
  const double before = law.friction_angle_deg;
  table.number("friction_angle_deg", law.friction_angle_deg, angle);
  if (law.friction_angle_deg != before) law.residual_friction_angle_deg = law.friction_angle_deg;
  table.number("residual_friction_angle_deg", law.residual_friction_angle_deg, angle);
  table.number("cohesion_pa", law.cohesion_pa, not_negative());
  table.number("tension_strength_pa", law.tension_strength_pa, not_negative());
  table.number("bonded_length_m", law.bonded_length_m, not_negative());
  table.flag("keeps_cohesion", law.keeps_cohesion);
  table.choice<Uplift>("uplift", law.uplift,
                       {{"none", Uplift::none}, {"triangular", Uplift::triangular}, {"full", Uplift::full}});
}

void read_analysis(File& file) {
  TableReader table(file.problems, file.section("analysis"), "[analysis]");
  Analysis& a = file.scene.analysis;
  table.choice<AnalysisKind>("kind", a.kind,
                             {{"dynamic", AnalysisKind::dynamic}, {"quasi-static", AnalysisKind::quasi_static}});
  table.choice<Integrator>("integrator", a.integrator,
                           {{"shi", Integrator::shi},
                            {"trapezoidal", Integrator::trapezoidal},
                            {"generalized-alpha", Integrator::generalized_alpha}});
  table.choice<Plane>("plane", a.plane, {{"strain", Plane::strain}, {"stress", Plane::stress}});
  table.choice<Start>("start", a.start, {{"equilibrium", Start::equilibrium}, {"unstressed", Start::unstressed}});
  table.number("spectral_radius", a.spectral_radius, between(0, 1.0000001, "a number from 0 to 1"));
  table.number("duration_s", a.duration_s, positive(), true);
  table.number("step_s", a.step_s, positive());
  table.number("max_displacement_ratio", a.max_displacement_ratio, positive());
  table.number("gravity_m_per_s2", a.gravity_m_per_s2, not_negative());
  table.number("rest_speed_m_per_s", a.rest_speed_m_per_s, positive());
  table.number("failure_displacement_m", a.failure_displacement_m, positive());
  table.flag("stop_at_failure", a.stop_at_failure);
  if (a.step_s > a.duration_s) {
    file.problems.error(table.line("step_s"),
                        fmt::format("step_s {} is longer than duration_s {}", a.step_s, a.duration_s),
                        "a step within the duration", "shorten step_s");
  }
}

void read_materials(File& file) {
  const toml::table* materials = file.section("material");
  if (materials == nullptr) {
    file.problems.error(0, "no material", "[material.NAME] with youngs_modulus_pa, poissons_ratio, density_kg_per_m3");
    return;
  }
  const bool strain = file.scene.analysis.plane == Plane::strain;
  for (const auto& [key, node] : *materials) {
    const std::string name(key.str());
    TableReader table(file.problems, node.as_table(), fmt::format("[material.{}]", name), line_of(node));
    Material material;
    material.name = name;
    table.number("youngs_modulus_pa", material.youngs_modulus_pa, positive(), true);
    table.number("poissons_ratio", material.poissons_ratio,
                 strain ? between(0, 0.5, "a number of at least 0 and below 0.5 (plane strain)")
                        : between(0, 0.5000001, "a number from 0 to 0.5"),
                 true);
    table.number("density_kg_per_m3", material.density_kg_per_m3, positive(), true);
    file.scene.materials.push_back(material);
    file.materials.push_back(name);
  }
}

void read_blocks(File& file) {
  file.each("block", [&](TableReader& table) {
    Block block;
    block.line = table.line();
    table.text("name", block.name, true);
    block.material = table.reference("material", "material", file.materials);
    table.points("vertices_m", block.vertices);
    table.flag("fixed", block.fixed);
    table.point("initial_velocity_m_per_s", block.initial_velocity_m_per_s);
    table.number("initial_spin_deg_per_s", block.initial_spin_deg_per_s);
    if (std::find(file.blocks.begin(), file.blocks.end(), block.name) != file.blocks.end()) {
      file.problems.error(table.line("name"), fmt::format("a second block is called \"{}\"", block.name),
                          "names that differ");
    }
    if (block.vertices.size() >= 3 && signed_area(block.vertices) < 0) {
      std::reverse(block.vertices.begin(), block.vertices.end());
      file.problems.note(table.line("vertices_m"), fmt::format("block \"{}\" runs clockwise", block.name),
                         "taken the other way round");
    }
    file.blocks.push_back(block.name);
    file.scene.blocks.push_back(std::move(block));
  });
  if (file.scene.blocks.empty()) file.problems.error(0, "no block", "at least one [[block]]");
}

void read_joints(File& file) {
  {
    TableReader table(file.problems, file.section("joint"), "[joint]");
    read_law(table, file.scene.default_joint);
  }
  file.each("joints", [&](TableReader& table) {
    Joint joint;
    joint.law = file.scene.default_joint;
    table.text("name", joint.name, true);
    std::vector<std::string> between;
    table.texts("between", between, 2);
    joint.between = {-1, -1};
    for (std::size_t i = 0; i < between.size(); ++i) {
      const auto found = std::find(file.blocks.begin(), file.blocks.end(), between[i]);
      if (found == file.blocks.end()) {
        file.problems.error(table.line("between"),
                            fmt::format("joint \"{}\" names no block: \"{}\"", joint.name, between[i]),
                            "names of blocks", did_you_mean(between[i], file.blocks));
      } else {
        joint.between[i] = static_cast<int>(found - file.blocks.begin());
      }
    }
    read_law(table, joint.law);
    file.joints.push_back(joint.name);
    file.scene.joints.push_back(joint);
  });
}

void read_loads(File& file) {
  const double duration = file.scene.analysis.duration_s;
  file.each("support", [&](TableReader& table) {
    Support support;
    support.block = table.reference("block", "block", file.blocks);
    table.point("point_m", support.point_m, true);
    table.time_table("displacement_x_m", support.displacement_x_m, duration);
    table.time_table("displacement_y_m", support.displacement_y_m, duration);
    if (!support.displacement_x_m && !support.displacement_y_m) {
      file.problems.error(table.line(), "a support that holds nothing", "displacement_x_m or displacement_y_m",
                          "0 holds the point");
    }
    file.scene.supports.push_back(support);
  });
  file.each("point_load", [&](TableReader& table) {
    PointLoad load;
    load.block = table.reference("block", "block", file.blocks);
    table.point("point_m", load.point_m, true);
    std::optional<TimeTable> x;
    std::optional<TimeTable> y;
    table.time_table("force_x_n_per_m", x, duration);
    table.time_table("force_y_n_per_m", y, duration);
    load.force_x_n_per_m = x.value_or(TimeTable::constant(0));
    load.force_y_n_per_m = y.value_or(TimeTable::constant(0));
    file.scene.point_loads.push_back(load);
  });
  file.each("face_pressure", [&](TableReader& table) {
    FacePressure load;
    load.block = table.reference("block", "block", file.blocks);
    table.point("from_m", load.from_m, true);
    table.point("to_m", load.to_m, true);
    std::optional<TimeTable> both;
    std::optional<TimeTable> from;
    std::optional<TimeTable> to;
    table.time_table("pressure_pa", both, duration);
    table.time_table("pressure_from_pa", from, duration);
    table.time_table("pressure_to_pa", to, duration);
    if (!both && !(from && to)) {
      file.problems.error(table.line(), "a face_pressure without pressure",
                          "pressure_pa, or pressure_from_pa and pressure_to_pa");
    }
    load.pressure_from_pa = from.value_or(both.value_or(TimeTable::constant(0)));
    load.pressure_to_pa = to.value_or(both.value_or(TimeTable::constant(0)));
    file.scene.face_pressures.push_back(load);
  });
}

void read_water(File& file) {
  Scene& scene = file.scene;
  {
    TableReader table(file.problems, file.section("water"), "[water]");
    Water& w = scene.water;
    table.number("density_kg_per_m3", w.density_kg_per_m3, positive());
    table.time_table("upstream_level_m", w.upstream_level_m, scene.analysis.duration_s);
    table.time_table("downstream_level_m", w.downstream_level_m, scene.analysis.duration_s);
    table.choice<Atmosphere>("atmosphere", w.atmosphere,
                             {{"none", Atmosphere::none}, {"wet-faces", Atmosphere::wet_faces}});
    table.number("atmospheric_pressure_pa", w.atmospheric_pressure_pa, not_negative());
    table.choice<NodalRule>("nodal_rule", w.nodal_rule,
                            {{"consistent", NodalRule::consistent}, {"lumped", NodalRule::lumped}});
    table.integer("elements_per_face", w.elements_per_face, 1);
    table.number("open_crack_width_m", w.open_crack_width_m, positive());
    table.flag("may_overtop", w.may_overtop);
    if (table.present()) {
      scene.fluid = FluidModel::hydrostatic;
      if (!w.upstream_level_m && !w.downstream_level_m) {
        file.problems.error(table.line(), "[water] without a level", "upstream_level_m or downstream_level_m");
      }
    }
  }
  const bool water = scene.fluid == FluidModel::hydrostatic;
  TableReader table(file.problems, file.section("fluid"), "[fluid]");
  table.choice<FluidModel>("model", scene.fluid,
                           {{"none", FluidModel::none}, {"hydrostatic", FluidModel::hydrostatic}});
  if (!water && scene.fluid == FluidModel::hydrostatic) {
    file.problems.error(table.line("model"), "a hydrostatic fluid without [water]", "[water] with a level");
  }
}

void read_run(File& file) {
  Scene& scene = file.scene;
  {
    TableReader table(file.problems, file.section("contact"), "[contact]");
    Contact& c = scene.contact;
    table.number("initial_penalty_n_per_m2", c.initial_penalty_n_per_m2, positive());
    table.number("penetration_tolerance_m", c.penetration_tolerance_m, positive());
    table.number("force_tolerance", c.force_tolerance, positive());
    table.integer("max_iterations", c.max_iterations, 1);
  }
  {
    TableReader table(file.problems, file.section("coupling"), "[coupling]");
    scene.coupling.window_s = scene.analysis.step_s;
    table.number("window_s", scene.coupling.window_s, positive());
    table.number("timeout_s", scene.coupling.timeout_s, positive());
  }
  {
    TableReader table(file.problems, file.section("output"), "[output]");
    table.number("frame_every_s", scene.output.frame_every_s, positive());
    table.number("history_every_s", scene.output.history_every_s, positive());
  }
  file.each("expect", [&](TableReader& table) {
    Expectation e;
    table.text("quantity", e.quantity, true);
    table.number("value", e.value);
    table.text("formula", e.formula);
    table.text("of", e.of);
    table.number("tolerance", e.tolerance, positive());
    table.text("source", e.source);
    if (e.value.has_value() == !e.formula.empty()) {
      file.problems.error(
          table.line(),
          "an [[expect]] with " + std::string(e.value ? "both value and formula" : "neither value nor formula"),
          "exactly one of value and formula");
    }
    scene.expectations.push_back(e);
  });
}

void reject_unknown_sections(File& file) {
  for (const auto& [key, node] : file.tables) {
    const std::string word(key.str());
    if (std::find(file.asked.begin(), file.asked.end(), word) != file.asked.end()) continue;
    file.problems.error(static_cast<int>(key.source().begin.line), fmt::format("unknown section or key \"{}\"", word),
                        "a section of a scene", did_you_mean(word, file.asked));
  }
}

void read_sections(toml::table& tables, Scene& scene, Problems& problems) {
  File file{tables, problems, scene};
  const auto heading = [&](const char* key, std::string& into) {
    file.asked.emplace_back(key);
    if (const toml::node* node = tables.get(key)) {
      if (const auto text = node->value<std::string>(); text && node->is_string()) {
        into = *text;
      } else {
        problems.error(line_of(*node), fmt::format("{} is not a text", key), "a text in quotes");
      }
    }
  };
  heading("title", scene.title);
  heading("note", scene.note);
  read_analysis(file);
  read_materials(file);
  read_blocks(file);
  read_joints(file);
  read_loads(file);
  read_water(file);
  read_run(file);
  reject_unknown_sections(file);
}

/// FNV-1a, 64 bit.
std::string digest_of(const std::string& text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return fmt::format("{:016x}", hash);
}

}  // namespace

ReadScene read_text(const std::string& text, const std::string& name, const std::vector<std::string>& overrides) {
  Problems problems(name);
  toml::table tables;
  try {
    tables = toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    problems.error(static_cast<int>(error.source().begin.line), std::string(error.description()), "TOML");
    throw SceneError(problems.errors());
  }
  ReadScene result;
  Scene& scene = result.scene;
  scene.file = name;
  scene.text = text;
  if (!overrides.empty()) {
    apply_overrides(tables, overrides, problems);
    std::ostringstream merged;
    merged << tables << '\n';
    scene.text = merged.str();
  }
  scene.digest = digest_of(scene.text);
  read_sections(tables, scene, problems);
  if (problems.errors().empty()) check(scene, problems);
  if (!problems.errors().empty()) throw SceneError(problems.errors());
  result.notes = problems.notes();
  return result;
}

ReadScene read(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path file = fs::is_directory(path, ignored) ? path / "scene.toml" : path;
  const auto refuse = [&](const std::string& found) {
    Problems problems(file.string());
    problems.error(0, found, "a scene file, or a folder that holds scene.toml");
    throw SceneError(problems.errors());
  };
  if (!fs::exists(file, ignored)) refuse("there is no such file");
  if (!fs::is_regular_file(file, ignored)) refuse("this is not a file");
  if (fs::file_size(file, ignored) > largest_file) refuse("the file is larger than 16 MiB");
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!(text << stream.rdbuf())) refuse("the file cannot be read, or is empty");
  return read_text(text.str(), file.string(), overrides);
}

}  // namespace blockweir::scene
