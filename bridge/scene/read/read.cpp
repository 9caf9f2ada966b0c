// SPDX-License-Identifier: GPL-3.0-or-later
// From a TOML file to a Scene. Every problem of the file is collected before it is reported.
#include "bridge/scene/read/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>

#include "bridge/scene/read/check.hpp"
#include "bridge/scene/read/digest.hpp"
#include "bridge/scene/read/encoding.hpp"
#include "bridge/scene/read/entry.hpp"
#include "bridge/scene/read/idle_uplift.hpp"
#include "bridge/scene/read/key_depth.hpp"
#include "bridge/scene/read/magnitudes.hpp"
#include "bridge/scene/read/nearest.hpp"
#include "bridge/scene/read/overrides.hpp"
#include "bridge/scene/read/read_load_cases.hpp"
#include "bridge/scene/read/read_open_studies.hpp"
#include "bridge/scene/read/read_randomness.hpp"
#include "bridge/scene/read/reading.hpp"
#include "bridge/scene/read/section_drawing.hpp"
#include "bridge/scene/read/syntax_remedy.hpp"
#include "bridge/scene/read/time_record.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::scene {
namespace {

constexpr std::uintmax_t largest_file = 16U << 20U;
constexpr int deepest_sound_key = 20;

[[noreturn]] void refuse(const std::string& file, int line, std::string found, std::string expected,
                         std::string remedy) {
  throw SceneError(
      {{Diagnostic::Severity::error, file, line, std::move(found), std::move(expected), std::move(remedy)}});
}

std::string text_of(const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  constexpr const char* expected = "a scene file, or a folder that holds scene.toml";
  const auto refuse_file = [&](const char* found, const char* remedy) {
    refuse(file.string(), 0, found, expected, remedy);
  };
  std::error_code failed;
  if (!fs::exists(file, failed)) refuse_file("there is no such file", "check the path");
  if (!fs::is_regular_file(file, failed)) refuse_file("this is not a file", "check the path");
  if (fs::file_size(file, failed) > largest_file) refuse_file("the file is larger than 16 MB", "check the path");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse_file("the file cannot be read", "check its permissions");
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) refuse_file("the file cannot be read to its end", "check the disk");
  return text;
}

std::string line_of(const std::string& text, int line) {
  std::istringstream lines(text);
  std::string found;
  for (int i = 0; i < line && std::getline(lines, found); ++i) continue;
  return found;
}

toml::table parse(const std::string& text, const std::string& name) {
  if (const auto foreign = foreign_text(text)) {
    refuse(name, foreign->line, foreign->found, "text in UTF-8",
           "save the file as UTF-8: editors ask for the encoding under \"Save as\"");
  }
  if (const DeepKey key = deepest_key(text); key.parts > deepest_sound_key) {
    refuse(name, key.line, fmt::format("a key of {} parts", key.parts), "keys like [material.concrete]",
           "take out the dots that do not belong");
  }
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    const int line = static_cast<int>(error.source().begin.line);
    refuse(name, line, fmt::format("a syntax error: {}", error.description()), "TOML (toml.io)",
           remedy_of_syntax(line_of(text, line)));
  }
}

void read_sections(Reading& reading, ReadScene& result) {
  for (const auto read : {read_heading, read_analysis, read_materials, read_default_joint}) read(reading);
  const std::size_t before = reading.problems.count();
  for (const auto read : {read_section, read_arches, read_walls, read_heaps}) read(reading);
  if (reading.problems.count() > before) reading.blocks.set_incomplete();
  for (const auto read : {read_blocks, read_supports, read_viscous_boundaries}) read(reading);
  const bool structure_sound = reading.problems.count() == before;
  for (const auto read : {refuse_repeated_names,
                          read_joints,
                          read_point_loads,
                          read_face_pressures,
                          read_line_loads,
                          read_body_loads,
                          read_bolts,
                          read_base_motion,
                          read_water,
                          read_fluid,
                          read_joint_flow,
                          read_silt,
                          read_ice,
                          read_earthquake,
                          read_contact,
                          read_coupling,
                          read_output,
                          read_expectations,
                          read_water_expectations,
                          read_variants,
                          read_studies}) {
    read(reading);
  }
  result.load_cases = read_load_cases(reading);
  result.open_studies = read_open_studies(reading);
  result.randomness = read_randomness(reading);
  reject_unknown_sections(reading);
  resolve_lengths(reading);
  check_overlaps(reading.scene, reading.problems);
  const std::size_t supported = reading.problems.count();
  // A wrong block or support would be followed by an error for each block that it holds.
  if (structure_sound) check_unsupported(reading.scene, reading.problems);
  if (reading.problems.count() == supported) check_level_heights(reading);
  if (reading.problems.count() == before) check_cracks(reading);
  if (reading.problems.count() == before) check_joint_flow(reading);
  if (reading.problems.count() == before) check_viscous_boundaries(reading);
  if (reading.problems.count() > 0) {
    const double size_m = reading.scene.blocks.empty() ? 0 : structure_size_m(reading.scene.blocks);
    return check_ranges(reading.file, size_m, reading.problems);
  }
  check_effects(reading);
  check_records(reading);
  check_dipping_uplift(reading);
  check_reservoir(reading);
  check_shaken_water(reading);
  check_leaps(reading);
  check_surface(reading);
  check_drift(reading);
  check_magnitudes(reading.file, reading.scene, reading.problems);
}

/// Errors, and after them the warnings: a wrong unit that is only warned of may be what is behind an error.
[[noreturn]] void refuse_all(const Problems& problems) {
  std::vector<Diagnostic> all = problems.errors();
  const auto key_of = [](const Diagnostic& d) { return d.found.substr(0, d.found.find(' ')); };
  const std::vector<Diagnostic> errors = all;
  for (const Diagnostic& warning : problems.warnings()) {
    const bool wrong = std::any_of(errors.begin(), errors.end(), [&](const Diagnostic& e) {
      return e.line == warning.line && key_of(e) == key_of(warning);
    });
    if (!wrong) all.push_back(warning);
  }
  throw SceneError(std::move(all));
}

/// Of a variant, which has no variants and studies.
void require_of_one_scene(const std::vector<std::string>& overrides) {
  for (const std::string& one : overrides) {
    const std::string key = setting_key(one);
    const std::string section = key.substr(0, key.find('.'));
    if (!is_of_whole_file(section)) continue;
    refuse(override_place(one), 0, "this changes the file's variants and studies, and a variant is run",
           "keys of the scene itself", fmt::format("change [[{}]] where it is written", section));
  }
}

}  // namespace

void refuse_warnings(const std::vector<Diagnostic>& warnings) {
  if (warnings.empty()) return;
  std::vector<Diagnostic> errors = warnings;
  for (Diagnostic& d : errors) d.severity = Diagnostic::Severity::error;
  throw SceneError(std::move(errors));
}

bool is_of_whole_file(std::string_view section) {
  constexpr std::array sections{"variant", "limit", "order", "map", "bench", "bench_motion", "study"};
  return std::find(sections.begin(), sections.end(), section) != sections.end();
}

ReadScene read_text(const std::string& text, const std::string& name, const std::vector<std::string>& overrides,
                    Extent extent) {
  toml::table file = parse(text, name);
  Problems problems(name);
  ReadScene result;
  Scene& scene = result.scene;
  scene.file = name;
  scene.text = text;
  if (!overrides.empty()) {
    apply_overrides(file, overrides, problems);
    leave_out_idle_uplift(file, problems);
  }
  if (extent == Extent::one_scene) {
    for (auto section = file.begin(); section != file.end();) {
      section = is_of_whole_file(section->first.str()) ? file.erase(section) : std::next(section);
    }
  }
  const std::size_t before = problems.count();
  const auto folder = std::filesystem::path(name).parent_path();
  const bool drawn = take_drawing(file, folder, problems);
  RecordSources records = take_records(file, folder, problems);
  refuse_control_characters(file, problems);
  if (problems.count() > before) throw SceneError(problems.errors());
  if (drawn || !records.empty() || !overrides.empty()) {
    std::ostringstream merged;
    merged << file << '\n';
    scene.text = merged.str();
  }
  scene.digest = digest(scene.text);
  Reading reading{file, problems, scene, std::move(records)};
  read_sections(reading, result);
  if (problems.count() > 0) refuse_all(problems);
  result.notes = problems.notes();
  result.warnings = problems.warnings();
  for (const Diagnostic& warning : result.warnings) scene.warnings.push_back(warning.message());
  return result;
}

std::filesystem::path scene_file(const std::filesystem::path& path) {
  std::error_code failed;
  return std::filesystem::is_directory(path, failed) ? path / "scene.toml" : path;
}

ReadScene read(const std::filesystem::path& path, const std::vector<std::string>& overrides, Extent extent) {
  const std::filesystem::path file = scene_file(path);
  return read_text(text_of(file), file.string(), overrides, extent);
}

ReadScene read_variant(const std::filesystem::path& path, const std::string& name,
                       const std::vector<std::string>& overrides) {
  if (name.empty()) return read(path, overrides);
  require_of_one_scene(overrides);
  const Scene scene = read(path).scene;
  std::vector<std::string> names;
  for (const Variant& variant : scene.variants) {
    if (variant.name == name) return read_variant(path, variant, overrides);
    names.push_back(variant.name);
  }
  const std::string meant = did_you_mean(name, names);
  refuse(scene.file.string(), 0, fmt::format("there is no variant \"{}\"", name),
         names.empty() ? "a scene with a [[variant]]" : one_of(names),
         !meant.empty()  ? meant
         : names.empty() ? "leave --variant out, or add one"
                         : "name one of these, or leave --variant out");
}

ReadScene read_variant(const std::filesystem::path& path, const Variant& variant,
                       const std::vector<std::string>& overrides) {
  std::vector<std::string> all = variant.set;
  all.insert(all.end(), overrides.begin(), overrides.end());
  return read_entry(path, {fmt::format("[[variant]] \"{}\"", variant.name), variant.line, variant.set}, all);
}

}  // namespace blockweir::scene
