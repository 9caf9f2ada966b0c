// SPDX-License-Identifier: GPL-3.0-or-later
// Joints: the law of all, and the pairs of blocks that differ.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <type_traits>
#include <variant>

#include "bridge/scene/joint_law_keys.hpp"
#include "bridge/scene/read/nearest.hpp"
#include "bridge/scene/read/reading.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::scene {
namespace {

std::array<int, 2> read_between(TableReader& table, Reading& reading) {
  std::array<int, 2> between{-1, -1};
  std::vector<std::string> words;
  if (!table.texts("between", words, 2)) return between;
  for (std::size_t i = 0; i < 2; ++i) {
    between[i] = reading.blocks.find(words[i]);
    if (between[i] >= 0 || !reading.blocks.complete()) continue;
    reading.problems.error(table.place("between", i),
                           fmt::format("between in {} names no block: \"{}\"", table.name(), words[i]),
                           one_of(reading.blocks.list()), did_you_mean(words[i], reading.blocks.list()));
  }
  if (between[0] >= 0 && between[0] == between[1]) {
    reading.problems.error(table.place("between"),
                           fmt::format("{} joins block \"{}\" to itself", table.name(), words[0]),
                           "two different blocks", "name the block on its other side");
  }
  return between;
}

void note_tension_cut_off(TableReader& table, const char* key, const JointLaw& law, Problems& problems) {
  const double borne = law.tension_cut_off_pa();
  constexpr double round_off = 1e-9;
  if (law.tension_strength_pa <= (1 + round_off) * borne) return;
  problems.note(table.place(key),
                fmt::format("in {} tension_strength_pa is {:.6g}, more than cohesion over tan(friction angle); {:.6g} "
                            "Pa is used instead, where Mohr-Coulomb's law ends",
                            table.name(), law.tension_strength_pa, borne),
                "state what the joint bears, or the cohesion_pa that goes with such a tension");
}

/// Slip works N tan(friction) and lifts N by tan(dilation): more of that would make energy.
void refuse_dilation_beyond_friction(TableReader& table, const char* key, const JointLaw& law, Problems& problems) {
  const bool by_residual = law.residual_friction_angle_deg < law.friction_angle_deg;
  const double friction_deg = by_residual ? law.residual_friction_angle_deg : law.friction_angle_deg;
  if (law.dilation_angle_deg <= friction_deg) return;
  problems.error(table.place(key),
                 fmt::format("dilation_angle_deg in {} is {:.6g}, above {} = {:.6g}: slip would then create energy",
                             table.name(), law.dilation_angle_deg,
                             by_residual ? "residual_friction_angle_deg" : "friction_angle_deg", friction_deg),
                 "a dilation angle of at most the friction angle, peak and residual (associated flow has equal ones)",
                 fmt::format("set dilation_angle_deg to at most {:.6g}, or the friction angle to at least {:.6g}",
                             friction_deg, law.dilation_angle_deg));
}

/// Reads the keys of a law; returns those that were given.
std::vector<std::string> read_keys(TableReader& table, JointLaw& law) {
  const Range angle{[](double degrees) { return degrees >= 0 && degrees < 90; },
                    "an angle of at least 0 and below 90 degrees"};
  // A joint that closes completely would keep the water out of an adjacent open part.
  const Range above_zero{[](double width) { return width > 0; },
                         "a number above 0 (1e-6 m lets next to nothing through)"};
  const auto range = [&](const JointLawKey& key) {
    if (key.range == JointLawKey::Range::angle) return angle;
    constexpr std::array<std::string_view, 4> widths = {"hydraulic_aperture_m", "least_aperture_m",
                                                        "largest_aperture_m", "aperture_stiffness_pa_per_m"};
    return std::count(widths.begin(), widths.end(), key.name) > 0 ? above_zero : not_negative();
  };
  std::vector<std::string> taken;
  for (const JointLawKey& key : joint_law_keys()) {
    const auto read = [&](auto member) {
      if constexpr (std::is_same_v<decltype(member), bool JointLaw::*>)
        return table.flag(key.name, law.*member);
      else
        return table.number(key.name, law.*member, range(key));
    };
    if (std::visit(read, key.member)) taken.emplace_back(key.name);
  }
  return taken;
}

/// The last of these keys that was given; null if none was.
const char* last_taken(const std::vector<std::string>& taken, std::initializer_list<const char*> keys) {
  const char* last = nullptr;
  for (const char* key : keys) {
    if (std::find(taken.begin(), taken.end(), key) != taken.end()) last = key;
  }
  return last;
}

}  // namespace

void read_law(TableReader& table, JointLaw& law, Reading& reading, bool& residual_given) {
  const std::vector<std::string> taken = read_keys(table, law);
  const auto last = [&](std::initializer_list<const char*> keys) { return last_taken(taken, keys); };
  if (table.has("friction_angle_deg") && last({"friction_angle_deg"}) == nullptr) {
    law.friction_angle_deg = std::numeric_limits<double>::quiet_NaN();  // refused: nothing is compared with the default
  }
  if (last({"residual_friction_angle_deg"}) != nullptr) residual_given = true;
  if (!residual_given) law.residual_friction_angle_deg = law.friction_angle_deg;
  const char* bond = last({"friction_angle_deg", "residual_friction_angle_deg", "cohesion_pa", "tension_strength_pa"});
  const bool has_friction = !std::isnan(law.friction_angle_deg);
  if (has_friction && bond != nullptr) note_tension_cut_off(table, bond, law, reading.problems);
  const char* slope = last({"friction_angle_deg", "residual_friction_angle_deg", "dilation_angle_deg"});
  if (has_friction && slope != nullptr) refuse_dilation_beyond_friction(table, slope, law, reading.problems);
  read_uplift(table, law, reading);
}

void read_default_joint(Reading& reading) {
  TableReader table(reading.problems, reading.section("joint"), "[joint]");
  read_law(table, reading.scene.default_joint, reading, reading.residual_given);
  check_law(table, reading.scene.default_joint, reading, /*of_all=*/true);
}

void read_joints(Reading& reading) {
  std::set<std::string> names;
  std::set<std::array<int, 2>> pairs;
  for (const Joint& cut : reading.scene.joints) {
    names.insert(cut.name);
    const auto [low, high] = std::minmax(cut.between[0], cut.between[1]);
    pairs.insert({low, high});
  }
  const double touching_m = 0.5e-6 * structure_size_m(reading.scene.blocks);  // as the solid has it
  reading.each("joints", [&](TableReader& table) {
    Joint joint{.law = reading.scene.default_joint};
    table.text("name", joint.name, true);
    joint.between = read_between(table, reading);
    bool own_residual = reading.residual_given;
    read_law(table, joint.law, reading, own_residual);
    check_law(table, joint.law, reading, /*of_all=*/false);
    check_joint(table, reading, joint, touching_m);
    const auto [low, high] = std::minmax(joint.between[0], joint.between[1]);
    if (!names.insert(joint.name).second && !joint.name.empty()) {
      refuse_second(reading, table.place("name"), "joint", joint.name, {"joints"});
    }
    if (low >= 0 && !pairs.insert({low, high}).second) {
      reading.problems.error(table.place("between"),
                             fmt::format("{} is a second joint of its two blocks", table.name()),
                             "one joint for each pair of blocks", "leave one of the two out");
    }
    reading.scene.joints.push_back(std::move(joint));
  });
}

}  // namespace blockweir::scene
