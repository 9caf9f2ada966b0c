// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/pictured_state.hpp"

#include "bridge/picture/acting_loads.hpp"
#include "bridge/picture/section_state.hpp"
#include "bridge/process/ask.hpp"
#include "bridge/process/programs.hpp"
#include "bridge/process/temporary_folder.hpp"

namespace blockweir::picture {
namespace {

using nlohmann::json;

/// The frame does not say on which block a panel is.
json water_of(const json& frame) {
  json open = json::array();
  json in_joints = json::array();
  for (json panel : frame["panels"]) {
    json& kind = panel[6] == 0 ? open : in_joints;
    panel[6] = unknown_block;
    kind.push_back(std::move(panel));
  }
  return {{{"name", "open water"}, {"panels", open}}, {{"name", "water in joints"}, {"panels", in_joints}}};
}

/// Kind by kind, as blockweir-limit answers; null where it does not.
json still_water(const std::filesystem::path& run, double time_s) {
  const process::TemporaryFolder scratch;
  try {
    return process::ask(
               "water",
               {.scene = process::scene_of(run), .out = scratch.path() / "water", .quiet = true, .moment_s = time_s})
        .answer;
  } catch (const process::Stopped&) {
    throw;
  } catch (const std::invalid_argument&) {
    return nullptr;
  } catch (const std::runtime_error&) {
    return nullptr;
  }
}

}  // namespace

json pictured_state(const scene::Scene& scene, const std::filesystem::path& run, const json& frames_data) {
  const json& frame = frames_data["frames"][frames_data["pictured"].get<std::size_t>()];
  const double time_s = frame["t"];
  json forces = json::array();
  for (const json& bolt : frame["bolts"]) forces.push_back(bolt[4]);
  const json water = still_water(run, time_s);
  json state = section_state(scene, water.is_null() ? water_of(frame) : water, time_s, forces);
  if (water.is_null()) state["pools"] = frame["pools"];
  const json& failure_s = frames_data["failure_s"];
  if (failure_s.is_number() && failure_s > time_s) state["fails_later_s"] = failure_s;
  return state;
}

}  // namespace blockweir::picture
