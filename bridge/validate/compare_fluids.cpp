// SPDX-License-Identifier: GPL-3.0-or-later
// Fluids side by side on the same scenes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <set>

#include "bridge/process/run.hpp"
#include "bridge/results/csv.hpp"
#include "bridge/results/figure.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/fluid_models.hpp"
#include "bridge/scene/read/nearest.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/study/study.hpp"
#include "bridge/validate/cases_folder.hpp"
#include "bridge/validate/compare.hpp"
#include "bridge/validate/compared_run.hpp"
#include "bridge/validate/table_line.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using process::RunOptions;
using process::RunResult;
using process::TemporaryFolder;

const scene::FluidEntry& entry_of(const std::string& key) {
  const auto found = std::find_if(scene::fluid_models.begin(), scene::fluid_models.end(),
                                  [&](const scene::FluidEntry& e) { return e.key == key; });
  if (found != scene::fluid_models.end()) return *found;
  std::vector<std::string> known;
  for (const scene::FluidEntry& e : scene::fluid_models) known.emplace_back(e.key);
  const std::string meant = scene::did_you_mean(key, known);
  throw std::invalid_argument(fmt::format("--fluids: found \"{}\"; expected {}; {}", key, scene::one_of(known),
                                          meant.empty() ? "name them with commas between" : meant));
}

/// The model that has the key of [fluid] which `setting` sets; null where it sets none of one model alone.
const scene::FluidEntry* owner_of(const std::string& setting) {
  constexpr std::string_view section = "fluid.";
  if (!setting.starts_with(section)) return nullptr;
  const std::string key = setting.substr(section.size(), setting.find_first_of(".=", section.size()) - section.size());
  if (key == "model") return nullptr;
  const auto table = std::find_if(scene::fluid_models.begin(), scene::fluid_models.end(),
                                  [&](const scene::FluidEntry& e) { return e.key == key; });
  return table != scene::fluid_models.end() ? &*table : &scene::fluid_entry(scene::FluidModel::openfoam);
}

void refuse_settings_of_none(const CompareOptions& options) {
  for (const std::string& setting : options.overrides) {
    const scene::FluidEntry* owner = owner_of(setting);
    if (owner == nullptr || std::count(options.fluids.begin(), options.fluids.end(), owner->key) > 0) continue;
    throw std::invalid_argument(
        fmt::format("--set {}: found a key of model = \"{}\", which is not compared; expected keys of {}; add {} to "
                    "--fluids, or leave the key out",
                    setting, owner->key, fmt::join(options.fluids, ", "), owner->key));
  }
}

/// A way in which a scene has a model.
struct Choice {
  std::string variant;  ///< empty: the scene itself
  Settings set;
};

Choice choice_of(const fs::path& path, scene::FluidModel model, const Settings& overrides) {
  const scene::Scene as_it_stands = scene::read(path, overrides).scene;
  if (as_it_stands.fluid == model) return {};
  for (const scene::Variant& variant : as_it_stands.variants) {
    if (scene::read_variant(path, variant, overrides).scene.fluid == model) return {.variant = variant.name};
  }
  Settings set = {fmt::format("fluid={{ model = \"{}\" }}", scene::fluid_entry(model).key)};
  if (model != scene::FluidModel::openfoam && !as_it_stands.water_expectations.empty())
    set.emplace_back("expect_water=[]");
  return {.set = set};
}

/// Columns of history.csv by their heading.
std::map<std::string, std::vector<double>> columns_of(const fs::path& file) {
  std::map<std::string, std::vector<double>> columns;
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> names = results::csv_cells(line);
  while (std::getline(stream, line)) {
    const std::vector<std::string> cells = results::csv_cells(line);
    if (cells.size() != names.size()) break;  // a killed run may leave half a line
    for (std::size_t i = 0; i < cells.size(); ++i) columns[names[i]].push_back(std::strtod(cells[i].c_str(), nullptr));
  }
  return columns;
}

/// Of each block that moves: largest size of the water's force along x, and half of its range. Blocks with the largest
/// forces come first.
json peaks(const fs::path& run) {
  const std::string ending = ".water_force_x_n_per_m";
  std::multimap<double, json, std::greater<>> blocks;
  for (const auto& [name, values] : columns_of(run / "history.csv")) {
    if (!name.ends_with(ending) || values.empty()) continue;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const std::string block = name.substr(0, name.size() - ending.size());
    const double largest = std::max(std::abs(*low), std::abs(*high));
    json both = json::array();
    for (const auto& [what, got] :
         {std::pair{"largest", largest}, std::pair{"half the range of", (*high - *low) / 2}}) {
      both.push_back({{"name", fmt::format("{} water_force_x_n_per_m on {}", what, block)},
                      {"expected", nullptr},
                      {"got", got},
                      {"relative_error", nullptr}});
    }
    blocks.emplace(largest, both);
  }
  json list = json::array();
  for (const auto& [largest, both] : blocks) list.insert(list.end(), both.begin(), both.end());
  return list;
}

/// Difference from the figure with the same name of the first model; null if there is none.
json off_first(const json& figure, const json& first) {
  for (const json& other : first) {
    if (other["name"] != figure["name"] || !other["got"].is_number() || !figure["got"].is_number()) continue;
    const double reference = other["got"];
    if (reference == 0) return nullptr;
    return figure["got"].get<double>() / reference - 1;
  }
  return nullptr;
}

/// In percent; where that says nothing, how many times the figure it is.
std::string off_text(double off) {
  if (off == 0) return "0 %*";
  return std::abs(off) < 10 ? fmt::format("{:+.3g} %*", 100 * off) : fmt::format("{:.3g} x*", 1 + off);
}

/// The runs of one scene, one a model.
class FluidTable {
 public:
  FluidTable(const CompareOptions& options, const TemporaryFolder& scratch) : options_(options), scratch_(scratch) {}

  void add(const fs::path& scene) {
    fmt::print("{}\n", case_name(scene));
    first_ = json::array();
    shown_.clear();
    left_out_ = 0;
    for (const std::string& fluid : options_.fluids) add(scene, fluid);
    if (left_out_ > 0) {
      fmt::print("  {} more block{} with less of the water's force {} in the file of --json\n", left_out_,
                 left_out_ == 1 ? "" : "s", left_out_ == 1 ? "is" : "are");
    }
  }
  [[nodiscard]] const json& rows() const { return rows_; }
  [[nodiscard]] bool sound() const { return sound_; }

 private:
  void add(const fs::path& scene, const std::string& fluid) {
    RunOptions one{.scene = scene,
                   .out = options_.out.empty() ? scratch_.path() / "run"
                                               : options_.out / fmt::format("{}-{}", case_name(scene), fluid)};
    Settings own;
    std::string left_out;
    for (const std::string& setting : options_.overrides) {
      const scene::FluidEntry* owner = owner_of(setting);
      if (owner != nullptr && owner->key != fluid) {
        left_out += fmt::format("    without {}, which only {} has\n", setting, owner->key);
      } else {
        (owner == nullptr ? one.overrides : own).push_back(setting);
      }
    }
    std::string trouble;
    json summary;
    try {
      const Choice choice = choice_of(scene, entry_of(fluid).model, one.overrides);
      one.variant = choice.variant;
      one.overrides = joined(joined(one.overrides, choice.set), own);
      const RunResult result = uninterrupted(fmt::format("{}, {}: a run", case_name(scene), fluid), one);
      if (result.exit_code != 0) trouble = result.trouble;
      summary = result.summary;
    } catch (const scene::SceneError& error) {
      trouble = error.what();
    }
    if (trouble.empty()) return add_figures(scene, fluid, left_out, command_of(one), summary, one.out);
    sound_ = false;
    fmt::print("  {}\n{}{}{}", fluid, results::wrapped(left_out), results::wrapped("    " + trouble),
               results::wrapped("    repeat it with " + command_of(one)));
    rows_.push_back({{"case", case_name(scene)}, {"fluid", fluid}, {"trouble", trouble}, {"command", command_of(one)}});
  }

  void add_figures(const fs::path& scene, const std::string& fluid, const std::string& left_out,
                   const std::string& command, const json& summary, const fs::path& run) {
    fmt::print(
        "{}{}",
        table_line("  " + fluid, fmt::format("{:>16} {:>9} {:>9.3g}", "", "", summary["wall_time_s"].get<double>())),
        results::wrapped(left_out));
    json all = figures(summary);
    const json forces = peaks(run);
    if (first_.empty()) choose(all, forces);
    all.insert(all.end(), forces.begin(), forces.end());
    for (const json& f : all) {
      const bool stated = f["relative_error"].is_number();
      const json off = stated ? f["relative_error"] : off_first(f, first_);
      if (shown_.contains(f["name"])) {
        print_figure(f["name"].get<std::string>(), results::figure(f["got"]),
                     !off.is_number() ? ""
                     : stated         ? fmt::format("{:.2e}", off.get<double>())
                                      : off_text(off));
      }
      rows_.push_back({{"case", case_name(scene)},
                       {"fluid", fluid},
                       {"name", f["name"]},
                       {"expected", f["expected"]},
                       {"got", f["got"]},
                       {"relative_error", f["relative_error"]},
                       {"off_first_fluid", off_first(f, first_)},
                       {"wall_time_s", summary["wall_time_s"]},
                       {"command", command}});
    }
    if (first_.empty()) first_ = all;
  }

  /// What is printed of each model: all figures, and the forces of the blocks that the first model's water presses
  /// most.
  void choose(const json& all, const json& forces) {
    constexpr std::size_t most = 3;
    for (const json& f : all) shown_.insert(f["name"].get<std::string>());
    const std::size_t blocks = forces.size() / 2;
    for (std::size_t i = 0; i < 2 * std::min(most, blocks); ++i) shown_.insert(forces[i]["name"].get<std::string>());
    left_out_ = blocks - std::min(most, blocks);
  }

  const CompareOptions& options_;
  const TemporaryFolder& scratch_;
  std::set<std::string> shown_;
  std::size_t left_out_ = 0;
  json first_ = json::array();  ///< figures of the first model
  json rows_ = json::array();
  bool sound_ = true;
};

}  // namespace

int compare_fluids(const CompareOptions& options) {
  if (options.cases.empty()) {
    throw std::invalid_argument(
        "--fluids: found no scene beside it; expected one or more; name those in which fluids are to be compared");
  }
  for (const std::string& fluid : options.fluids) entry_of(fluid);
  refuse_settings_of_none(options);
  if (options.fluids.size() < 2) {
    throw std::invalid_argument(fmt::format(
        "--fluids: found \"{}\" alone; expected two models or more, with commas between; add another, as {}",
        options.fluids.front(), options.fluids.front() == "hydrostatic" ? "reservoir" : "hydrostatic"));
  }
  if (!options.json.empty()) results::require_writable_file("--json", options.json, {".json"});
  if (!options.out.empty()) results::make_folder(options.out);
  const TemporaryFolder scratch;
  FluidTable table(options, scratch);
  fmt::print("{}", table_line("case, fluid, figure", fmt::format("{:>16} {:>9} {:>9}", "got", "error", "time s")));
  try {
    for (const fs::path& scene : options.cases) {
      table.add(scene);
      std::fflush(stdout);
    }
  } catch (const Interrupted&) {
    fmt::print(stderr, "stopped on request\n");
    return 130;
  }
  fmt::print("*: off the figure of {}, in percent; x: times that figure\n", options.fluids.front());
  if (!options.json.empty()) results::replace_file(options.json, table.rows().dump(2) + "\n");
  std::error_code kept;
  fs::remove(options.out, kept);  // where no run has left anything in it
  return table.sound() ? 0 : 1;
}

}  // namespace blockweir::study
