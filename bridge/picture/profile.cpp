// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/profile.hpp"

#include <fmt/format.h>

#include <fstream>
#include <vector>

#include "bridge/picture/draw.hpp"
#include "bridge/picture/gnuplot.hpp"

namespace blockweir::picture {
namespace {

using nlohmann::json;

/// A key of profile_s and how people call it.
struct Phase {
  const char* key;
  const char* words;
};

struct Part {
  std::string words;
  double seconds;
};

struct Side {
  std::string name;
  std::vector<Part> parts{};
};

constexpr Phase of_solid[] = {{"start_up", "start-up"},
                              {"search", "contact search"},
                              {"islands", "groups in contact"},
                              {"contact", "contact forces"},
                              {"assembly", "assembly"},
                              {"factorization", "factorization"},
                              {"solve", "solution"},
                              {"state_changes", "multipliers and bonds"},
                              {"accept", "states at the step's end"},
                              {"rest_of_step", "rest of the step"},
                              {"watch", "failure, margins, energies"},
                              {"mapping", "water onto blocks"},
                              {"pack", "packing"},
                              {"wire", "wire"},
                              {"wait_for_fluid", "waiting for the water"},
                              {"output", "output"}};
constexpr Phase of_fluid[] = {{"fluid_start_up", "start and end of interFoam"},
                              {"fluid_mapping", "blocks into water"},
                              {"fluid_cut", "blocks cut out of cells"},
                              {"fluid_step", "step"},
                              {"fluid_pack", "packing"},
                              {"fluid_wire", "wire"},
                              {"fluid_wait", "waiting for blocks"},
                              {"fluid_output", "output"}};

template <std::size_t Size>
Side side(const char* name, const Phase (&phases)[Size], const json& profile) {
  Side found{name};
  for (const Phase& phase : phases) {
    if (profile.contains(phase.key)) found.parts.push_back({phase.words, profile[phase.key].get<double>()});
  }
  return found;
}

double sum(const Side& side) {
  double seconds = 0;
  for (const Part& part : side.parts) seconds += part.seconds;
  return seconds;
}

std::vector<Side> sides_of(const json& summary) {
  const json& profile = summary["profile_s"];
  std::vector<Side> sides = {side("solid", of_solid, profile)};
  const double wall_s = summary["wall_time_s"];
  const double rest_s = wall_s - sum(sides.front());
  sides.front().parts.push_back({"start and end of the processes", std::max(0.0, rest_s)});
  if (Side fluid = side("fluid", of_fluid, profile); !fluid.parts.empty()) sides.push_back(std::move(fluid));
  return sides;
}

/// Whoever waits is grey, what works goes round the colours.
std::string colour(const std::string& words, double turn) {
  if (words.rfind("waiting", 0) == 0) return "rgb '#d4d4d4'";
  return fmt::format("rgb hsv2rgb({:.3f}, {}, {})", turn, 0.55, 0.85);
}

/// Each part is a bar from where the one before it ends.
Picture picture_of(const std::vector<Side>& sides, const std::filesystem::path& file) {
  std::string data;
  std::string curves;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    double from = 0;
    for (std::size_t k = 0; k < sides[i].parts.size(); ++k) {
      const Part& part = sides[i].parts[k];
      const double y = -static_cast<double>(i);
      const double to = from + part.seconds;
      data += fmt::format("{} {} {} {} {} {}\ne\n", (from + to) / 2, y, from, to, y - 0.35, y + 0.35);
      curves += fmt::format("{}'-' using 1:2:3:4:5:6 with boxxyerror fs solid noborder lc {} title {}",
                            curves.empty() ? "" : ", ",
                            colour(part.words, static_cast<double>(k) / static_cast<double>(sides[i].parts.size())),
                            gnuplot_text(fmt::format("{}: {}, {:.3g} s", sides[i].name, part.words, part.seconds)));
      from = to;
    }
  }
  std::string ticks;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    ticks += fmt::format("{}'{}' {}", ticks.empty() ? "" : ", ", sides[i].name, -static_cast<double>(i));
  }
  return {file, 1100, 520,
          fmt::format("set xlabel 'wall time (s)'\nset ytics ({})\nset yrange [{}:0.6]\n"
                      "set key outside right top\nset xrange [0:*]\nset border 3\nset tics nomirror\nplot {}\n{}",
                      ticks, -static_cast<double>(sides.size()) + 0.4, curves, data)};
}

/// Time that the solid waits while the water's process does nothing: messages, and processes that get no processor.
/// Empty where that is little.
std::string hint_of_waiting(const json& summary) {
  constexpr double much = 0.25;  // of the wall time
  const json& profile = summary["profile_s"];
  if (!profile.contains("fluid_wait")) return {};
  double idle_s = profile.value("wait_for_fluid", 0.0);
  for (const auto& [phase, seconds] : profile.items()) {
    if (phase.starts_with("fluid_") && phase != "fluid_wait") idle_s -= seconds.get<double>();
  }
  const double share = idle_s / summary["wall_time_s"].get<double>();
  if (share < much) return {};
  return fmt::format(
      "{:.0f} % of the time both processes waited, for messages or for a processor; where processors are few try "
      "--inproc (still water or a reservoir), or fewer --jobs\n",
      100 * share);
}

}  // namespace

std::string profile_tree(const json& summary) {
  const double wall_s = summary["wall_time_s"];
  const auto row = [wall_s](const std::string& branch, const std::string& words, double seconds) {
    return fmt::format("{}{:<{}} {:>10.4f} s {:>6.1f} %\n", branch, words, 40 - 3 * (branch.size() / 3), seconds,
                       100 * seconds / wall_s);
  };
  std::string text = row("", "run", wall_s);
  for (const Side& side : sides_of(summary)) {
    text += row("  ", side.name, sum(side));
    for (const Part& part : side.parts) text += row("     ", part.words, part.seconds);
  }
  text += hint_of_waiting(summary);
  for (const json& skip : summary.value("skips", json::array())) {
    text += fmt::format("skipped {}\n", skip.get<std::string>());
  }
  const json counts = summary.value("counts", json::object());
  for (const auto& [what, count] : counts.items()) {
    text += fmt::format("{:<25} {}\n", what, count.dump());
  }
  const json memory = summary.value("peak_memory_mb", json::object());
  for (const auto& [who, mb] : memory.items()) {
    text += fmt::format("{:<25} {:.1f} MB at most\n", "memory of " + who, mb.get<double>());
  }
  return text;
}

void profile(const ProfileOptions& options) {
  std::ifstream stream(options.run / "summary.json");
  const json summary = json::parse(stream, nullptr, /*allow_exceptions=*/false);
  if (!summary.is_object() || !summary.contains("profile_s") || !summary.contains("wall_time_s")) {
    throw std::invalid_argument(fmt::format(
        "{}: found no summary.json with profile_s; expected the folder of a run that has ended", options.run.string()));
  }
  fmt::print("{}", profile_tree(summary));
  const std::filesystem::path file = options.run / (options.svg ? "profile.svg" : "profile.png");
  draw({picture_of(sides_of(summary), file)});
  fmt::print("{}\n", file.string());
}

}  // namespace blockweir::picture
