// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/scene_file_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

#include "bridge/reliability/refused_draws.hpp"
#include "bridge/study/load_case_scene.hpp"
#include "bridge/study/open_study.hpp"
#include "bridge/study/study.hpp"
#include "bridge/validate/bench.hpp"

namespace blockweir::launch {
namespace {

/// Adds the warnings of a variant or load case that the scene itself does not have; the entry is at `line`.
void add_warnings(const scene::ReadScene& read, const std::string& whose, int line,
                  std::vector<scene::Diagnostic> warnings, std::vector<scene::Diagnostic>& all) {
  for (scene::Diagnostic& warning : warnings) {
    const auto same = [&](const scene::Diagnostic& other) { return other.message() == warning.message(); };
    if (std::any_of(read.warnings.begin(), read.warnings.end(), same)) continue;
    if (warning.line != line) warning.found = fmt::format("{}: {}", whose, warning.found);
    all.push_back(std::move(warning));
  }
}

/// Whether the text has the name of such a table anywhere: large scenes, which rarely have one, are not read twice.
bool may_hold_variants_or_studies(const std::filesystem::path& path) {
  const std::filesystem::path file = scene::scene_file(path);
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed)) return false;
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const auto words = {"variant", "load_case", "study", "limit", "order", "map", "random"};
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return text.find(word) != std::string::npos; });
}

/// All but benches, whose dozens of settings each want the scene read anew.
SceneFileCheck check_but_benches(const scene::ReadScene& read, const std::filesystem::path& path,
                                 const std::vector<std::string>& overrides) {
  SceneFileCheck found;
  std::vector<scene::Diagnostic>& warnings = found.warnings;
  scene::CollectedErrors& wrong = found.wrong;
  for (const scene::Variant& variant : read.scene.variants) {
    wrong.from([&] {
      add_warnings(read, fmt::format("variant \"{}\"", variant.name), variant.line,
                   scene::read_variant(path, variant, overrides).warnings, warnings);
    });
  }
  for (const scene::LoadCase& load_case : read.load_cases) {
    wrong.from([&] {
      const scene::ReadScene set = study::load_case_scene(load_case, path, overrides);
      add_warnings(read, fmt::format("load case \"{}\"", load_case.name), load_case.line, set.warnings, warnings);
      if (auto idle = study::idle_load_case(load_case, read.scene, set.scene)) warnings.push_back(std::move(*idle));
      for (auto& missed : study::missed_joints(load_case, set.scene)) warnings.push_back(std::move(missed));
    });
  }
  const scene::Studies& asked = read.scene.studies;
  if (!asked.limits.empty() || !asked.orders.empty() || !asked.maps.empty()) {
    wrong.from([&] { found.studies += study::study_tasks(path, overrides).size(); });
  }
  if (!read.open_studies.empty()) {
    wrong.from([&] { found.studies += study::open_study_tasks(path, overrides, /*jobs=*/1).size(); });
  }
  wrong.from([&] {
    for (auto& warning : study::refused_draws(path, read, overrides)) warnings.push_back(std::move(warning));
  });
  return found;
}

}  // namespace

SceneFileCheck check_scene_file(const scene::ReadScene& read, const std::filesystem::path& path,
                                const std::vector<std::string>& overrides) {
  SceneFileCheck found = check_but_benches(read, path, overrides);
  if (!read.scene.studies.benches.empty()) found.wrong.from([&] { study::bench_settings(path, overrides); });
  return found;
}

void require_sound_file(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  if (!may_hold_variants_or_studies(path)) return;
  const auto report_with = [&](const std::vector<std::string>& set) {
    const auto read = [&]() -> std::optional<scene::ReadScene> {
      try {
        return scene::read(path, set);
      } catch (const scene::SceneError&) {
        return std::nullopt;
      }
    }();
    if (read) check_but_benches(*read, path, set).wrong.report();
  };
  try {
    report_with({});
  } catch (const scene::SceneError&) {
    if (overrides.empty()) throw;
    report_with(overrides);
  }
}

}  // namespace blockweir::launch
