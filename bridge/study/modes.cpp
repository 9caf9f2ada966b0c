// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/modes.hpp"

#include <fmt/format.h>

#include "bridge/picture/modes.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/wrapped.hpp"

namespace blockweir::study {
namespace {

using nlohmann::json;

std::string table(const std::string& title, const json& modes) {
  std::string text = fmt::format("{}\n  mode   rad/s      Hz         period s   share of mass in x, y\n", title);
  int number = 0;
  for (const json& mode : modes) {
    const json& period = mode["period_s"];
    text += fmt::format("  {:<6} {:<10.5g} {:<10.5g} {:<10} {:.3f}  {:.3f}\n", ++number,
                        mode["omega_rad_per_s"].get<double>(), mode["frequency_hz"].get<double>(),
                        period.is_null() ? "free" : fmt::format("{:.5g}", period.get<double>()),
                        mode["mass_share_x"].get<double>(), mode["mass_share_y"].get<double>());
  }
  return text;
}

std::string modes_report(const json& answer) {
  const json& contacts = answer["contacts"];
  std::string text = fmt::format("contacts at rest: {} that stick, {} that slip, {} open; {} unknowns\n",
                                 contacts["stick"].get<long>(), contacts["slip"].get<long>(),
                                 contacts["open"].get<long>(), answer["unknowns"].get<long>());
  text += table("DRY     without the water's inertia", answer["dry"]);
  if (answer.contains("wet")) {
    text +=
        table(fmt::format("WET     with that of incompressible water, level {:.6g} m", answer["level_m"].get<double>()),
              answer["wet"]);
  }
  for (const json& warning : answer["warnings"]) text += fmt::format("WARNING {}\n", warning.get<std::string>());
  return text;
}

}  // namespace

int print_modes(const ModesOptions& options) {
  if (!options.json.empty()) results::require_writable_file("--json", options.json, {".json"});
  const process::Asked asked = process::ask("modes", options);
  fmt::print("{}", results::for_stdout(modes_report(asked.answer)));
  const auto picture = asked.folder / "modes.png";
  picture::draw_modes(asked.scene, asked.answer, picture);
  fmt::print("picture {}\n", picture.string());
  if (!options.json.empty()) results::replace_file(options.json, asked.answer.dump(2) + "\n");
  return 0;
}

}  // namespace blockweir::study
