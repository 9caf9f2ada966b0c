// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/run.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "bridge/checkpoint/checkpoints.hpp"
#include "bridge/process/external_fluid.hpp"
#include "bridge/process/failure_cause.hpp"
#include "bridge/process/fluid_name.hpp"
#include "bridge/process/limit_margin.hpp"
#include "bridge/process/merged_report.hpp"
#include "bridge/process/previous_run.hpp"
#include "bridge/process/programs.hpp"
#include "bridge/process/progress.hpp"
#include "bridge/process/reached.hpp"
#include "bridge/process/supervisor.hpp"
#include "bridge/process/temporary_folder.hpp"
#include "bridge/results/file_name.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/folder_lock.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/seconds.hpp"
#include "bridge/results/shell_word.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/fluid_models.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/scene/two_earthquakes.hpp"

namespace blockweir::process {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
constexpr double grace_s = 5;

fs::path usual_folder(const RunOptions& options) {
  std::string name = case_name(options.scene);
  if (!options.variant.empty()) name += "-" + results::file_name(options.variant);
  return fs::path("runs") / name;
}

fs::path results_folder(const RunOptions& options) {
  if (!options.out.empty()) {
    if (fs::exists(options.out / results::FolderLock::file))
      results::FolderLock{options.out};  // whose first files are few
    if (is_anothers(options.out)) {
      throw std::invalid_argument(
          fmt::format("--out {}: not empty and not a former run; choose another folder", options.out.string()));
    }
    return options.out;
  }
  const fs::path usual = usual_folder(options);
  fs::path out = usual;
  for (int n = 2; fs::exists(out); ++n) out = fmt::format("{}-{}", usual.string(), n);
  return out;
}

/// OpenFOAM drops blanks and quotes from the paths that it is given, and finds nothing there.
void require_path_of_openfoam(const scene::Scene& scene, const fs::path& folder) {
  if (scene.fluid != scene::FluidModel::openfoam) return;
  const std::string full = fs::absolute(folder).string();
  const auto at = full.find_first_of(" \t\n\v\f\r\"'");
  if (at == std::string::npos) return;
  throw std::invalid_argument(
      fmt::format("--out {}: found a {} in the folder's path, {}; expected a path without blanks and quotes, which "
                  "OpenFOAM drops from paths; choose another --out, or work in another folder",
                  folder.string(), full[at] == '"' || full[at] == '\'' ? "quote" : "blank", full));
}

/// The last checkpoint that all processes of the run have; 0: none. Still water needs none, except with flow through
/// joints and for its own VTK files.
std::uint64_t resumable_window(const fs::path& folder, const scene::Scene& scene) {
  std::vector<std::uint64_t> all = checkpoint::windows(folder, "solid");
  const auto keep = [&](const std::vector<std::uint64_t>& theirs) {
    std::erase_if(all, [&](std::uint64_t w) { return !std::binary_search(theirs.begin(), theirs.end(), w); });
  };
  const scene::FluidEntry& fluid = scene::fluid_entry(scene.fluid);
  const bool remembers = (fluid.yours ? scene.external.remembers : fluid.remembers) || scene.output.reservoir ||
                         scene::flows_in_joints(scene);
  if (remembers) keep(checkpoint::windows(folder / fluid.folder, fluid.role));
  return all.empty() ? 0 : all.back();
}

/// `fluid`: how messages call it.
void complete_summary(const fs::path& folder, const std::string& fluid, RunResult& result, const LimitMargin* margin,
                      double wall_s) {
  json& summary = result.summary;
  summary = summary_of(folder);
  if (!result.trouble.empty()) {
    summary["outcome"] = "stopped";
    summary["stopped"] = result.trouble;
  }
  if (!summary.contains("simulated_s")) {
    if (const json last = reached(folder); last.is_object()) summary["reached"] = last;
  }
  summary["wall_time_s"] = wall_s;
  if (margin != nullptr) margin->add_to(summary);
  merge_report(report_of(folder), fluid, summary);
  try {
    results::replace_file(folder / "summary.json", summary.dump(2) + "\n");
  } catch (const std::exception&) {
    if (result.trouble.empty()) throw;                          // else the first trouble is the one to read
    const bool is_there = fs::exists(folder / "summary.json");  // the solid's own
    result.advice += std::string(result.advice.empty() ? "" : "; ") +
                     (is_there ? "summary.json could not be completed, either: it is as the solid left it"
                               : "summary.json could not be written, either");
  }
}

bool is_refusal(const Supervised& supervised) {
  return !supervised.interrupted && !supervised.overdue &&
         std::all_of(supervised.ends.begin(), supervised.ends.end(), [](const ChildEnd& end) {
           return !end.stopped && (end.exit_code == 0 || (end.exit_code <= 2 && !end.last_line.empty()));
         });
}

/// A finished run has no checkpoint, and needs none.
void refuse_finished(const fs::path& folder) {
  const std::string outcome = summary_of(folder).value("outcome", "stopped");
  if (outcome == "stopped") return;
  throw std::invalid_argument(
      fmt::format("{}: found a run that is complete, its outcome is \"{}\"; nothing is left to resume; \"blockweir run "
                  "{} --set analysis.duration_s=...\" makes a longer one",
                  folder.string(), outcome, scene_of(folder).string()));
}

[[noreturn]] void refuse_without_checkpoint(const scene::Scene& scene, const fs::path& folder) {
  const std::string why = summary_of(folder).value("stopped", "");
  throw std::invalid_argument(fmt::format("{}: no checkpoint that all its processes have{}; {}", folder.string(),
                                          why.empty() ? "" : fmt::format(", the run ended with \"{}\"", why),
                                          lacks_checkpoint(scene, folder) ? no_checkpoint_of_external
                                          : ends_there_again(folder)
                                              ? "resuming would end in the same way: change the scene, and run it anew"
                                              : "mend the cause and run it anew, with a shorter [output] "
                                                "checkpoint_every_s where such a run is to go on"));
}

/// What to do about a run that did not end well; `too_early`: it was stopped before its first checkpoint.
std::string advice_of(const scene::Scene& scene, const fs::path& folder, bool goes_on, bool too_early) {
  const fs::path repeat = folder / "repeat.toml";
  if (fs::exists(repeat)) return fmt::format("\"blockweir run {}\" repeats it", results::shell_word(repeat.string()));
  if (goes_on) return fmt::format("\"blockweir resume {}\" continues the run", results::shell_word(folder.string()));
  if (too_early && lacks_checkpoint(scene, folder)) return no_checkpoint_of_external;
  return too_early ? "it has no checkpoint yet to resume from: run it anew" : "";
}

/// Runs from the start, or from the checkpoint before motion `first`; results go to `folder`, which contains the
/// scene.
RunResult go(const scene::Scene& scene, const fs::path& folder, std::uint64_t first, const RunOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const StopsLater until_the_summary_stands;
  RunResult result;
  result.folder = folder;
  const TemporaryFolder scratch;
  const std::string endpoint = "ipc://" + (scratch.path() / "line").string();
  int pipe_ends[2];
  if (::pipe2(pipe_ends, O_CLOEXEC | O_NONBLOCK) != 0) {
    throw std::runtime_error(
        fmt::format("cannot open a pipe to the solid process: {}; end other programs, or raise the "
                    "limit of open files (ulimit -n)",
                    std::strerror(errno)));
  }
  const Processes processes{folder, endpoint, first, options.inproc, home_of_external(scene, folder)};
  std::vector<Command> commands = commands_of(scene, processes);
  if (options.trace) {
    results::make_folder(trace_of(folder));
    for (Command& command : commands) {
      command.environment.push_back("BLOCKWEIR_TRACE=" + fs::absolute(trace_of(folder)).string());
    }
  }
  commands.front().words.insert(commands.front().words.end(), {"--progress-fd", std::to_string(pipe_ends[1])});
  commands.front().inherited_fd = pipe_ends[1];
  const LimitMargin margin(scratch.path());
  const bool asks = options.margin && LimitMargin::suits(scene);
  if (asks) commands.push_back(margin.command(folder));
  if (is_started_by_hand(scene)) fmt::print(stderr, "{}", call_for_external(scene, processes));
  Progress progress(pipe_ends[0], scene.analysis.duration_s, options.quiet && !options.tells_progress);
  const Supervised supervised = supervise(
      commands, folder, grace_s, [&] { return progress.update(); }, options.longest_s);
  progress.finish();
  ::close(pipe_ends[0]);
  ::close(pipe_ends[1]);

  result.asked_to_stop = supervised.asked_to_stop;
  result.trouble = failure_cause(supervised, folder, scene.coupling.timeout_s);
  result.refused = !result.trouble.empty() && is_refusal(supervised);
  const std::uint64_t last = resumable_window(folder, scene);
  const bool refused_to_resume = result.refused && first > 0 && last == first;  // as where a checkpoint is damaged
  const bool goes_on = last > 0 && !refused_to_resume && !ends_there_again(folder);
  const bool killed = result.trouble.find("ended by signal") != std::string::npos;  // or what one of them has started
  const bool too_early = last == 0 && (killed || !result.refused);
  if (!result.trouble.empty()) result.advice = advice_of(scene, folder, goes_on, too_early);
  result.exit_code = supervised.interrupted ? 130 : supervised.all_fine() ? 0 : 1;
  if (result.exit_code == 0) forget_checkpoints(folder);
  complete_summary(folder, fluid_name(scene), result, asks ? &margin : nullptr, seconds_since(start));
  return result;
}

}  // namespace

std::string trouble_text(const RunResult& result) {
  return result.trouble + (result.advice.empty() ? "" : "; " + result.advice);
}

RunResult run(const RunOptions& options) {
  const scene::ReadScene read = scene::read_variant(options.scene, options.variant, options.overrides);
  require_fit(read.scene, options.inproc);
  std::vector<scene::Diagnostic> warnings = read.warnings;
  if (auto twice = scene::two_earthquakes(read.scene)) warnings.push_back(std::move(*twice));
  if (options.strict) scene::refuse_warnings(warnings);
  for (const auto& note : read.notes) fmt::print(stderr, "{}", results::for_stderr(note.text() + "\n"));
  if (!options.quiet) {
    for (const auto& warning : warnings) fmt::print(stderr, "{}", results::for_stderr(warning.text() + "\n"));
  }
  const fs::path folder = results_folder(options);
  require_path_of_openfoam(read.scene, folder);
  results::make_folder(folder);
  const results::FolderLock lock(folder);
  if (options.keeps_others) refuse_to_lose(folder, read.scene, options.overrides);
  forget_previous_run(folder, read.scene);
  results::replace_file(scene_of(folder), read.scene.text);
  RunResult result = go(read.scene, folder, 0, options);
  if (options.out.empty() && folder != usual_folder(options)) result.in_place_of = usual_folder(options);
  return result;
}

RunResult resume(const ResumeOptions& options) {
  if (!is_run(options.folder)) {
    throw std::invalid_argument(
        fmt::format("{}: found no scene.toml and solid.log of a run; expected the folder that a run has written",
                    options.folder.string()));
  }
  const results::FolderLock lock(options.folder);
  const scene::Scene scene = scene::read(scene_of(options.folder), {}).scene;
  require_fit(scene, options.inproc);
  require_path_of_openfoam(scene, options.folder);
  const std::uint64_t first = resumable_window(options.folder, scene);
  if (first == 0) {
    refuse_finished(options.folder);
    refuse_without_checkpoint(scene, options.folder);
  }
  return go(scene, options.folder, first, {.inproc = options.inproc, .quiet = options.quiet, .margin = options.margin});
}

}  // namespace blockweir::process
