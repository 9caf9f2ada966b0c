// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/run.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>

#include "bridge/launch/figure.hpp"
#include "bridge/launch/progress.hpp"
#include "bridge/launch/supervisor.hpp"
#include "bridge/launch/temporary_folder.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/scene/read.hpp"

namespace blockweir::launch {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
constexpr double grace_s = 5;

/// Programs stand beside this one, wherever it was installed.
fs::path program(const char* name) {
  return fs::read_symlink("/proc/self/exe").parent_path() / name;
}

/// Does the folder hold what no run has written? What is no folder at all is make_folder's to refuse.
bool is_anothers(const fs::path& folder) {
  std::error_code unreadable;
  const fs::directory_iterator contents(folder, unreadable);
  const bool a_run = fs::exists(folder / "scene.toml", unreadable) && fs::exists(folder / "solid.log", unreadable);
  return contents != fs::directory_iterator() && !a_run;
}

fs::path results_folder(const RunOptions& options) {
  if (!options.out.empty()) {
    if (is_anothers(options.out)) {
      throw std::invalid_argument(
          fmt::format("--out {}: not empty and not a former run; choose another folder", options.out.string()));
    }
    return options.out;
  }
  const fs::path given = fs::weakly_canonical(options.scene);
  const bool folder = fs::is_directory(given) || given.filename() == "scene.toml";
  const fs::path name = fs::is_directory(given) ? given.filename()
                        : folder                ? given.parent_path().filename()
                                                : given.stem();
  fs::path out = fs::path("runs") / name;
  for (int n = 2; fs::exists(out); ++n) out = fs::path("runs") / fmt::format("{}-{}", name.string(), n);
  return out;
}

json read_json(const fs::path& path) {
  std::ifstream stream(path);
  return stream ? json::parse(stream, nullptr, /*allow_exceptions=*/false) : json();
}

/// The first failure in time is the cause; what the others say of it is its echo. A process that was killed says
/// nothing itself.
std::string first_trouble(const Supervised& supervised) {
  if (supervised.interrupted) return "stopped on request; the results so far stand";
  for (const ChildEnd& end : supervised.ends) {
    if (end.exit_code > 128) return fmt::format("the {} process was ended by signal {}", end.name, end.exit_code - 128);
  }
  const auto is_echo = [](const ChildEnd& end) {
    return end.last_line.find("see its own message for the cause") != std::string::npos;
  };
  const ChildEnd* cause = nullptr;
  for (const ChildEnd& end : supervised.ends) {
    if (end.exit_code != 0 && (cause == nullptr || (is_echo(*cause) && !end.last_line.empty()))) cause = &end;
  }
  if (cause != nullptr) {
    return cause->last_line.empty() ? fmt::format("the {} process ended with {}", cause->name, cause->exit_code)
                                    : cause->last_line;
  }
  return "";
}

void complete_summary(const fs::path& folder, RunResult& result, double wall_s) {
  json& summary = result.summary;
  summary = read_json(folder / "summary.json");
  if (!summary.is_object()) summary = json::object();
  if (!result.trouble.empty()) {
    summary["outcome"] = "stopped";
    summary["stopped"] = result.trouble;
  }
  summary["wall_time_s"] = wall_s;
  const json fluid = read_json(folder / "hydrostatic.json");
  if (fluid.is_object()) {
    for (const auto& [phase, seconds] : fluid["seconds"].items()) summary["profile_s"]["fluid_" + phase] = seconds;
    for (const auto& [what, count] : fluid["counts"].items()) summary["counts"]["fluid_" + what] = count;
    fs::remove(folder / "hydrostatic.json");
  }
  const json water = read_json(folder / "openfoam.json");
  if (water.is_object()) {
    for (const json& check : water["checks"]) summary["checks"].push_back(check);
    fs::remove(folder / "openfoam.json");
  }
  results::replace_file(folder / "summary.json", summary.dump(2) + "\n");
}

}  // namespace

RunResult run(const RunOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const scene::ReadScene read = scene::read_variant(options.scene, options.variant, options.overrides);
  const scene::Scene& scene = read.scene;
  for (const auto& note : read.notes) fmt::print(stderr, "{}\n", note.text());

  RunResult result;
  result.folder = results_folder(options);
  const TemporaryFolder socket_folder;
  const std::string endpoint = "ipc://" + (socket_folder.path() / "line").string();
  results::make_folder(result.folder);
  fs::remove(result.folder / "summary.json");
  fs::remove_all(result.folder / "frames");
  const std::string copy = (result.folder / "scene.toml").string();
  results::replace_file(copy, scene.text);

  int pipe_ends[2];
  if (::pipe2(pipe_ends, O_CLOEXEC | O_NONBLOCK) != 0) throw std::runtime_error("cannot open a pipe");
  std::vector<Command> commands;
  commands.push_back({"solid",
                      {program("blockweir-solid"), copy, "--out", result.folder, "--endpoint", endpoint,
                       "--progress-fd", std::to_string(pipe_ends[1])},
                      pipe_ends[1]});
  if (scene.fluid == scene::FluidModel::hydrostatic) {
    commands.push_back({"hydrostatic",
                        {program("blockweir-hydrostatic"), copy, "--endpoint", endpoint, "--out", result.folder,
                         "--profile-out", result.folder / "hydrostatic.json"}});
  }
  if (scene.fluid == scene::FluidModel::openfoam) {
    commands.push_back({"openfoam",
                        {program("blockweir-openfoam"), copy, "--endpoint", endpoint, "--out",
                         result.folder / "openfoam", "--result", result.folder / "openfoam.json"}});
  }
  Progress progress(pipe_ends[0], scene.analysis.duration_s, options.quiet);
  const Supervised supervised = supervise(commands, result.folder, grace_s, [&] { progress.update(); });
  progress.finish();
  ::close(pipe_ends[0]);
  ::close(pipe_ends[1]);

  result.trouble = first_trouble(supervised);
  result.exit_code = supervised.interrupted ? 130 : supervised.all_fine() ? 0 : 1;
  complete_summary(result.folder, result,
                   std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return result;
}

std::string report(const RunResult& result) {
  const json& s = result.summary;
  std::string text;
  const std::string outcome = s.value("outcome", "stopped");
  const auto number = [](const json& value) {
    return value.is_number() ? fmt::format("{:.6g}", value.get<double>()) : "none";
  };
  if (outcome == "fails") {
    const json& f = s["failure"];
    text += fmt::format("FAILS   {}\n", f["text"].get<std::string>());
    if (f["level_m"].is_number()) {
      text += fmt::format("        at a level of {} m, {} m above the joint that failed, after {} s\n",
                          number(f["level_m"]), number(f["head_m"]), number(f["time_s"]));
    } else {
      text += fmt::format("        after {} s\n", number(f["time_s"]));
    }
  } else if (outcome == "stands") {
    text += fmt::format("STANDS  {}\n", s["margin"]["text"].get<std::string>());
  } else {
    text += fmt::format("STOPPED {}\n", s.value("stopped", ""));
  }
  if (s.contains("rest")) text += fmt::format("STATIC  {}\n", s["rest"]["text"].get<std::string>());
  if (s.contains("breach")) {
    text +=
        fmt::format("BREACH  after {} s: {}\n", number(s["breach"]["time_s"]), s["breach"]["text"].get<std::string>());
  }
  if (s.contains("added_mass")) text += fmt::format("{}\n", s["added_mass"]["text"].get<std::string>());
  for (const json& check : s.value("checks", json::array())) {
    text += fmt::format("{}  {}: expected {}, got {}, off by {} (tolerance {})\n",
                        check["passed"].get<bool>() ? "ok    " : "OUT   ", check["name"].get<std::string>(),
                        figure(check["expected"]), figure(check["got"]), number(check["relative_error"]),
                        number(check["tolerance"]));
  }
  for (const json& skip : s.value("skips", json::array())) text += fmt::format("skipped {}\n", skip.get<std::string>());
  text += fmt::format("time    {} s of wall time for {} s simulated\n", number(s["wall_time_s"]),
                      number(s.value("simulated_s", json())));
  text += fmt::format("results {} (blocks.pvd opens in ParaView; \"blockweir plot {}\" draws figures)\n",
                      result.folder.string(), result.folder.string());
  return text;
}

}  // namespace blockweir::launch
