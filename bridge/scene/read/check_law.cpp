// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of a joint's law that have no effect beside its other keys.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "bridge/scene/joint_law_keys.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

using Keys = std::vector<const char*>;

/// Does this law state one of the keys? A 0 is then meant; of laws of uplift only "flow" counts.
bool states_one(const toml::table* law, const Keys& keys) {
  if (law == nullptr) return false;
  return std::any_of(keys.begin(), keys.end(), [&](const std::string key) {
    return law->contains(key) && (key != "uplift" || (*law)[key].value<std::string>() == "flow");
  });
}

/// Does a law that follows [joint]?
bool follower_states_one(const Reading& reading, const Keys& keys) {
  for (const char* list : {"joints", "cut", "joint_set"}) {
    const toml::array* laws = reading.file[list].as_array();
    if (laws == nullptr) continue;
    for (const toml::node& law : *laws) {
      if (states_one(law.as_table(), keys)) return true;
    }
  }
  return false;
}

}  // namespace

void check_law(TableReader& table, const JointLaw& law, Reading& reading, bool of_all) {
  // A missing key is an error; only a warning if it is stated as 0 or by another law; nothing if [joint] states it for
  // other tables.
  const auto without = [&](const char* key, const char* missing, const Keys& enabling) {
    if (!table.has(key)) return;
    if (of_all && follower_states_one(reading, enabling)) return;
    const std::string found = fmt::format("{} in {} has no effect: the joint has no {}", key, table.name(), missing);
    const std::string remedy = fmt::format("state it, or leave {} out", key);
    const auto is_stated = [&](const char* k) { return table.has(k) || reading.file["joint"][k]; };
    if (std::any_of(enabling.begin(), enabling.end(), is_stated)) {
      reading.problems.warning(table.place(key), found, fmt::format("a {} above 0", missing), remedy);
    } else {
      reading.problems.error(table.place(key), found, fmt::format("a {}", missing), remedy);
    }
  };
  const auto beside_keeping = [&](const char* key) {
    if (!table.has(key) || !law.keeps_cohesion) return;
    reading.problems.warning(
        table.place(key),
        fmt::format("{} in {} has no effect: with keeps_cohesion the bond never fails", key, table.name()),
        "a bond that can fail", fmt::format("leave out {} or keeps_cohesion", key));
  };
  for (const JointLawKey& key : joint_law_keys()) {
    if (key.is_idle != nullptr && key.is_idle(law)) without(key.name, key.without, key.supplied_by);
  }
  if (table.has("residual_friction_angle_deg") && law.residual_friction_angle_deg > law.friction_angle_deg) {
    reading.problems.warning(
        table.place("residual_friction_angle_deg"),
        fmt::format("residual_friction_angle_deg {} in {} is above the peak {}: the joint grows stronger as it slips",
                    law.residual_friction_angle_deg, table.name(), law.friction_angle_deg),
        "a residual angle up to the peak one", "exchange the two, if that is not meant");
  }
  if (law.softening_slip_m > 0) beside_keeping("softening_slip_m");
  if (law.residual_friction_angle_deg != law.friction_angle_deg) beside_keeping("residual_friction_angle_deg");
  if (law.is_bonded() && law.bonded_length_m == 0.0 && table.has("bonded_length_m")) {
    reading.problems.warning(
        table.place("bonded_length_m"),
        fmt::format("bonded_length_m in {} is 0: cohesion and tension strength have no effect", table.name()),
        "a length above 0", "lengthen it, or leave it out: all of the joint is then bonded");
  }
  if (law.uplift != Uplift::none && table.has("uplift")) check_uplift(table, reading);
}

void check_uplift(TableReader& table, Reading& reading) {
  const std::string found = fmt::format("uplift in {} has no effect", table.name());
  const auto model = reading.file["fluid"]["model"].value<std::string>();
  if (!reading.file.contains("water")) {
    reading.problems.error(table.place("uplift"), found + ": the scene has no water", "[water] with a level",
                           "add [water], or leave uplift out");
  } else if (model == "none" || model == "column") {
    reading.problems.warning(table.place("uplift"),
                             fmt::format("{}: model = \"{}\" in [fluid] takes no water into joints", found, *model),
                             "model = \"hydrostatic\" or \"openfoam\"", "change the model, or set uplift = \"none\"");
  }
}

}  // namespace blockweir::scene
