// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/level.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bridge/picture/mechanism.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/wrapped.hpp"

namespace blockweir::study {
namespace {

using nlohmann::json;

/// The joint from whose end the head is measured: limit analysis names the one farthest upstream first.
std::string joint_of_head(const json& found) {
  if (const std::string joint = found.value("joint", ""); !joint.empty()) return joint;
  const json joints = found.value("mechanism", json::object()).value("joints", json::array());
  return joints.empty() ? "" : joints.front().get<std::string>();
}

/// A level and the head over the joint that fails, to a tenth of a millimetre; `level.json` has all digits.
std::string level_text(const json& found) {
  const std::string outcome = found["outcome"];
  if (outcome == "not found") return "no answer: " + found["reason"].get<std::string>();
  if (outcome == "does not stand empty") return "does not stand even with an empty reservoir";
  if (outcome == "stands") {
    return fmt::format("stands at every level up to {:.6g} m", found["highest_level_m"].get<double>());
  }
  std::string text = fmt::format("fails at a level of {:.4f} m", found["level_m"].get<double>());
  if (found.contains("head_m") && found["head_m"].is_number()) {
    const std::string joint = joint_of_head(found);
    text += fmt::format(", {:.4f} m above {}", found["head_m"].get<double>(),
                        joint.empty() ? "the joint" : fmt::format("joint \"{}\"", joint));
  }
  return text;
}

std::string blocks_text(const json& found) {
  std::string text = level_text(found);
  if (found.contains("stopped")) {
    text += fmt::format("\n        to {:.2g} m: {}", found["level_width_m"].get<double>(),
                        found["stopped"].get<std::string>());
  }
  if (found.contains("slow_rise")) {
    text += fmt::format("\n        all loads at once; under a level that rises slowly it {}",
                        level_text(found["slow_rise"]));
  }
  if (found.contains("settles_at_m")) {
    text += fmt::format("\n        from {:.6g} m on blocks slip a little and then rest again",
                        found["settles_at_m"].get<double>());
  }
  if (!found.contains("mode")) return text;
  const auto blocks = found["blocks"].get<std::vector<std::string>>();
  constexpr std::size_t most = 4;
  const auto shown = std::vector(blocks.begin(), blocks.begin() + std::min(most, blocks.size()));
  text += fmt::format("\n        {} of \"{}\"", found["mode"].get<std::string>(), fmt::join(shown, "\", \""));
  if (blocks.size() > most) text += fmt::format(" and {} more", blocks.size() - most);
  const std::string joint = found["joint"];
  if (const std::string bears = found.value("turns_on", ""); !bears.empty()) {
    return text + fmt::format(" on joint \"{}\"; joint \"{}\" opens", bears, joint);
  }
  return joint.empty() ? text : text + fmt::format(" on joint \"{}\"", joint);
}

/// `reason`: why it differs from the blocks; a note that says the same is left out.
std::string limit_text(const json& found, const std::string& reason) {
  std::string text = level_text(found);
  if (found.contains("load_factor")) {
    text += fmt::format("\n        it bears {:.6g} times the reservoir's forces at the highest",
                        found["load_factor"].get<double>());
  }
  if (const std::string note = found.value("limit_analysis_note", ""); reason.find(note) == std::string::npos) {
    text += "\n        " + note;
  }
  if (found.contains("mechanism")) text += "\n        " + found["mechanism"]["text"].get<std::string>();
  if (found.contains("gap")) {
    text += fmt::format("\n        forces and mechanism agree to {:.1g} (gap)", found["gap"].get<double>());
  }
  return text;
}

/// That blocks and limit analysis agree, or by how much and why they do not.
std::string difference_text(const json& difference) {
  const bool agree = difference["agree"];
  std::string text = agree ? "agree   " : "differ  ";
  if (difference.contains("level_m")) {
    text += fmt::format("blocks less limit analysis {:.3g} m, {:.2g} of the {}\n        ",
                        difference["level_m"].get<double>(), difference["relative"].get<double>(),
                        difference["relative_to"].get<std::string>());
  } else if (agree) {
    return text + "blocks and limit analysis agree\n";
  }
  return text + fmt::format("reason: {}\n", difference["reason"].get<std::string>());
}

std::string level_report(const json& answer) {
  std::string text = fmt::format("BLOCKS  {}\n", blocks_text(answer));
  if (answer.contains("rigid_blocks")) text += fmt::format("RIGID   {}\n", level_text(answer["rigid_blocks"]));
  text += fmt::format("LIMIT   {}\n", limit_text(answer["limit_analysis"], answer["difference"]["reason"]));
  if (answer.contains("formula")) {
    const json& formula = answer["formula"];
    text += fmt::format("FORMULA {:.4f} m, {:.4f} m above joint \"{}\" ({})\n", formula["level_m"].get<double>(),
                        formula["head_m"].get<double>(), formula["joint"].get<std::string>(),
                        formula["name"].get<std::string>());
  }
  if (answer["assumed"].is_string()) text += fmt::format("water   {}\n", answer["assumed"].get<std::string>());
  if (answer.contains("added_water_pressure")) {
    text += fmt::format("water   added pressure in the earthquake after {}\n",
                        answer["added_water_pressure"].get<std::string>());
  }
  text += difference_text(answer["difference"]);
  if (answer["looked_at"].is_string()) text += fmt::format("levels  {}\n", answer["looked_at"].get<std::string>());
  for (const json& warning : answer["warnings"]) text += fmt::format("WARNING {}\n", warning.get<std::string>());
  return text;
}

}  // namespace

int print_level(const LevelOptions& options) {
  if (!options.json.empty()) results::require_writable_file("--json", options.json, {".json"});
  const process::Asked asked = process::ask("level", options);
  const json& limit = asked.answer["limit_analysis"];
  fmt::print("{}", results::for_stdout(level_report(asked.answer)));
  if (limit.contains("mechanism")) {
    const auto picture = asked.folder / "mechanism.png";
    const json& level_m = limit["level_m"];
    picture::draw_mechanism(asked.scene, limit["mechanism"],
                            level_m.is_number() ? std::optional(level_m.get<double>()) : std::nullopt, picture);
    fmt::print("picture {}\n", picture.string());
  }
  if (!options.json.empty()) results::replace_file(options.json, asked.answer.dump(2) + "\n");
  return 0;
}

}  // namespace blockweir::study
