// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/limit_margin.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/process/ask.hpp"
#include "bridge/process/programs.hpp"
#include "bridge/process/temporary_folder.hpp"
#include "bridge/results/folder_lock.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::process {
namespace {

using nlohmann::json;

bool is_at_rest_by_its_scene(const scene::Scene& scene) {
  const bool still = scene.fluid == scene::FluidModel::none || scene.fluid == scene::FluidModel::hydrostatic;
  const bool any_moves =
      std::any_of(scene.blocks.begin(), scene.blocks.end(), [](const scene::Block& b) { return !b.fixed; });
  return still && any_moves && !scene.base_motion &&
         std::none_of(scene.blocks.begin(), scene.blocks.end(), [](const scene::Block& b) {
           return !b.initial_velocity_m_per_s.isZero() || b.initial_spin_deg_per_s != 0;
         });
}

std::string text_of(const json& found, bool fails) {
  const std::string level =
      found["level_m"].is_number() ? fmt::format(" at a level of {:.6g} m", found["level_m"].get<double>()) : "";
  const auto how = [&] { return found["mechanism"]["text"].get<std::string>(); };
  if (found["factor"].is_number()) {
    const double factor = found["factor"];
    return fmt::format("{:.4g} on the strength of the joints{}: {}{}", factor, level, how(),
                       fails && factor >= 1 ? "; above 1 although it fails, as an upper bound may be" : "");
  }
  if (found.contains("reservoir_factor")) {
    return fmt::format("{:.4g} on the reservoir's forces{}, as {}: {}", found["reservoir_factor"].get<double>(), level,
                       found["why_no_factor"].get<std::string>(), how());
  }
  return fmt::format("none: {}", found["why_no_factor"].get<std::string>());
}

}  // namespace

void add_limit_margin(RunResult& result) {
  json& summary = result.summary;
  const std::string outcome = summary.value("outcome", "stopped");
  if (outcome != "fails" && outcome != "stands") return;
  const std::filesystem::path scene = scene_of(result.folder);
  if (!is_at_rest_by_its_scene(scene::read(scene).scene)) return;
  json found;
  try {
    const TemporaryFolder scratch;
    found = ask("margin", {.scene = scene, .out = scratch.path() / "margin", .quiet = true}).answer;
  } catch (const Stopped&) {
    return;
  } catch (const std::exception& error) {  // the run stands for itself
    found = {{"factor", nullptr}, {"level_m", nullptr}, {"why_no_factor", error.what()}};
  }
  found["text"] = text_of(found, outcome == "fails");
  summary["limit_analysis"] = found;
  const results::FolderLock lock(result.folder);
  results::replace_file(result.folder / "summary.json", summary.dump(2) + "\n");
}

}  // namespace blockweir::process
