// SPDX-License-Identifier: GPL-3.0-or-later
// The law of the water in a joint, with the drains and piezometers that it needs, and whether these lie in the joint.
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <vector>

#include "bridge/scene/cracks.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

const Range share{[](double s) { return s >= 0 && s <= 1; }, "a number from 0 to 1"};

bool takes_drains(Uplift law) {
  return law == Uplift::drained || law == Uplift::cracked;
}

/// Keys that are not stated follow the drain of [joint], where that has one.
void read_drain(TableReader& table, Reading& reading, Uplift law, KnownHeads& known) {
  Drain drain = known.drain.value_or(Drain{});
  table.number("drain_m", drain.station_m, positive());
  table.number("drain_efficiency", drain.efficiency, share);
  table.number("drain_head_m", drain.head_m);
  const bool at = table.has("drain_m");
  const bool efficiency = table.has("drain_efficiency");
  const bool head = table.has("drain_head_m");
  if (!takes_drains(law) || (!at && !efficiency && !head)) return;
  if (!known.drain && (!at || (!efficiency && !head))) {
    return reading.problems.error(table.place(efficiency ? "drain_efficiency"
                                              : head     ? "drain_head_m"
                                                         : "drain_m"),
                                  fmt::format("{} states half of a drain", table.name()),
                                  "drain_m, and drain_efficiency or drain_head_m or both",
                                  at ? "add drain_efficiency" : "add drain_m, its way from the joint's upstream end");
  }
  known.drain = drain;
  if (table.has("uplift")) return;
  known.line = table.place(head ? "drain_head_m" : efficiency ? "drain_efficiency" : "drain_m").line;
}

/// Rows or level alone follow those of [joint], where that has both.
void read_piezometers(TableReader& table, Reading& reading, KnownHeads& known) {
  const bool followed = !known.piezometers.empty();
  std::vector<Point> rows;
  table.know("piezometers_m");
  if (table.has("piezometers_m")) table.points("piezometers_m", rows, 1);
  table.number("piezometers_level_m", known.level_m);
  if (table.has("piezometers_m")) known.piezometers.clear();
  for (const Point& row : rows) known.piezometers.push_back({row.x(), row.y()});
  const auto& p = known.piezometers;
  const auto falls = std::adjacent_find(
      p.begin(), p.end(), [](const Piezometer& a, const Piezometer& b) { return a.station_m >= b.station_m; });
  if (falls != p.end()) {
    reading.problems.error(table.place("piezometers_m"),
                           fmt::format("piezometers_m in {}: a station of {} m follows one of {} m", table.name(),
                                       (falls + 1)->station_m, falls->station_m),
                           "rows [station, head] with stations that increase from the upstream end", "sort the rows");
  }
  if (followed || table.has("piezometers_m") == table.has("piezometers_level_m")) return;
  reading.problems.error(table.place(table.has("piezometers_m") ? "piezometers_m" : "piezometers_level_m"),
                         fmt::format("{} states piezometers by half", table.name()),
                         "piezometers_m, and piezometers_level_m, the reservoir's level when they were read",
                         "add the other key");
}

/// Of keys that the law does not take.
void refuse_idle(TableReader& table, Reading& reading, const JointLaw& law) {
  const auto refuse_first = [&](std::initializer_list<const char*> keys, const char* laws) {
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const char* k) { return table.has(k); });
    if (key == keys.end()) return;
    reading.problems.error(
        table.place(*key),
        fmt::format("{} in {} has no effect: its uplift is \"{}\"", *key, table.name(), named(law.uplift).name),
        fmt::format("uplift = {}", laws), fmt::format("state that law, or leave {} out", *key));
  };
  if (!takes_drains(law.uplift)) {
    refuse_first({"drain_m", "drain_efficiency", "drain_head_m"}, "\"drained\" or \"cracked\"");
  }
  if (law.uplift != Uplift::heads) refuse_first({"piezometers_m", "piezometers_level_m"}, "\"heads\"");
}

void require(TableReader& table, Reading& reading, const JointLaw& law) {
  const auto lacks = [&](const char* what, const char* keys) {
    reading.problems.error(table.place("uplift"),
                           fmt::format("uplift = \"{}\" in {} without {}", named(law.uplift).name, table.name(), what),
                           keys, "state them, or take uplift = \"triangular\"");
  };
  const bool some_drain = table.has("drain_m") || table.has("drain_efficiency") || table.has("drain_head_m");
  if (law.uplift == Uplift::drained && !law.known_heads.drain && !some_drain) {
    lacks("a drain", "drain_m, and drain_efficiency or drain_head_m or both");
  }
  if (law.uplift == Uplift::heads && law.known_heads.piezometers.empty() && !table.has("piezometers_m")) {
    lacks("piezometers", "piezometers_m = [[station, head], ...] and piezometers_level_m");
  }
}

/// Reports a station beyond the crack.
void check_station(Reading& reading, const Crack& crack, const char* what, double station_m) {
  if (station_m > 0 && station_m < crack.length_m) return;
  reading.problems.error(reading.problems.at(crack.known.line),
                         fmt::format("{} of joint \"{}\" lies at {} m, and the joint is {:.6g} m long", what,
                                     name_of(reading.scene, crack), station_m, crack.length_m),
                         "a station between the joint's ends, from its upstream end",
                         "move it, or state the length from the upstream end and not from the axis");
}

/// Of the joints that one line of the file lets crack one is named.
void check_cracking(Reading& reading, const std::vector<Crack>& cracks) {
  const Scene& scene = reading.scene;
  std::map<int, std::vector<const Crack*>> cracking;
  std::map<int, std::vector<const Crack*>> parts_nothing;
  for (const Crack& crack : cracks) {
    if (crack.law != Uplift::cracked) continue;
    cracking[crack.known.line].push_back(&crack);
    if (parted_by(scene, crack).empty()) parts_nothing[crack.known.line].push_back(&crack);
  }
  if (scene.fluid == FluidModel::openfoam || scene.fluid == FluidModel::external) {
    for (const auto& [line, all] : cracking) {
      reading.problems.error(
          reading.problems.at(line),
          fmt::format("uplift = \"cracked\" with model = \"{}\": the crack's length follows still water",
                      fluid_entry(scene.fluid).key),
          "model = \"hydrostatic\" in [fluid]", "change the model, or state uplift = \"full\"");
    }
  }
  for (const auto& [line, all] : parts_nothing) {
    const std::string more = all.size() > 1 ? fmt::format(" and {} more", all.size() - 1) : "";
    reading.problems.error(
        reading.problems.at(line),
        fmt::format("uplift = \"cracked\" in joint \"{}\"{}, which {} not separate a part of the structure from the "
                    "ground: the forces that open such a crack do not follow from equilibrium",
                    name_of(scene, *all.front()), more, all.size() > 1 ? "do" : "does"),
        "a joint, or joints in one line, that run through the structure",
        "state it for such a joint, or take uplift = \"full\" or \"triangular\"");
  }
}

}  // namespace

void read_uplift(TableReader& table, JointLaw& law, Reading& reading) {
  std::vector<std::pair<const char*, Uplift>> words;
  for (const UpliftName& name : uplift_names) words.emplace_back(name.name, name.law);
  const Uplift followed = law.uplift;
  table.choice<Uplift>("uplift", law.uplift, words);
  if (law.uplift != followed) law.known_heads = {};  // drains and piezometers are those of another law
  if (table.has("uplift")) law.known_heads.line = table.place("uplift").line;
  KnownHeads& known = law.known_heads;
  read_drain(table, reading, law.uplift, known);
  read_piezometers(table, reading, known);
  refuse_idle(table, reading, law);
  require(table, reading, law);
}

void check_cracks(Reading& reading) {
  const Scene& scene = reading.scene;
  const auto needs_geometry = [](const JointLaw& law) {
    return law.uplift == Uplift::cracked || law.known_heads.drain || !law.known_heads.piezometers.empty();
  };
  if (!needs_geometry(scene.default_joint) &&
      std::none_of(scene.joints.begin(), scene.joints.end(), [&](const Joint& j) { return needs_geometry(j.law); })) {
    return;
  }
  const std::vector<Crack> cracks = find_cracks(scene);
  for (const Crack& crack : cracks) {
    if (crack.known.drain) check_station(reading, crack, "the drain", crack.known.drain->station_m);
    for (const Piezometer& p : crack.known.piezometers) check_station(reading, crack, "a piezometer", p.station_m);
    if (!crack.known.piezometers.empty() && crack.known.level_m <= crack.end().y()) {
      reading.problems.error(
          reading.problems.at(crack.known.line),
          fmt::format("piezometers_level_m of joint \"{}\" is {} m, not above its downstream end at {:.6g} m",
                      name_of(scene, crack), crack.known.level_m, crack.end().y()),
          "the reservoir's level when the piezometers were read",
          "correct it: heads follow the reservoir in proportion");
    }
  }
  check_cracking(reading, cracks);
}

}  // namespace blockweir::scene
