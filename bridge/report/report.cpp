// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/report/report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <optional>

#include "bridge/process/ask.hpp"
#include "bridge/process/external_fluid.hpp"
#include "bridge/process/previous_run.hpp"
#include "bridge/process/programs.hpp"
#include "bridge/process/run.hpp"
#include "bridge/process/temporary_folder.hpp"
#include "bridge/reliability/reliability_answer.hpp"
#include "bridge/report/report_page.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/folder_lock.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/shell_word.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/study/safety.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The answers of a report, which can do without: the reason then stands in their place. After Ctrl-C no more is asked.
class Questions {
 public:
  template <class Answer>
  json result_or_trouble(Answer answer) {
    if (stopped_) return {{"trouble", "not asked, as the report was stopped before"}};
    try {
      return answer();
    } catch (const process::Stopped& error) {
      stopped_ = true;
      return {{"trouble", error.what()}};
    } catch (const scene::SceneError& error) {
      return {{"trouble", error.what()}};
    } catch (const std::invalid_argument& error) {
      return {{"trouble", error.what()}};
    } catch (const std::runtime_error& error) {
      return {{"trouble", error.what()}};
    }
  }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  bool stopped_ = false;
};

/// Can a folder "runs" be made, or be written into, where we are?
bool may_write_here() {
  const fs::path runs = "runs";
  return ::access(fs::exists(runs) ? runs.c_str() : ".", W_OK) == 0;
}

json sound_summary(const fs::path& run) {
  json summary = process::summary_of(run);
  if (!summary.empty()) return summary;
  if (fs::exists(run / "summary.json")) {
    throw std::invalid_argument(
        fmt::format("{}: found a summary.json that is cut off or damaged; expected the whole file; make the run anew "
                    "with blockweir run {}",
                    run.string(), results::shell_word(process::scene_of(run).string())));
  }
  throw std::invalid_argument(fmt::format(
      "{}: found a run without a summary.json; expected one that has ended; {}", run.string(),
      process::can_be_resumed(run) ? fmt::format("blockweir resume {} may end it", results::shell_word(run.string()))
                                   : fmt::format("make it anew with blockweir run {}, as it has no checkpoint",
                                                 results::shell_word(process::scene_of(run).string()))));
}

/// That of a former call of blockweir reliability.
json kept_reliability(const fs::path& folder) {
  std::ifstream stream(folder / "reliability.json");
  json answer = stream ? json::parse(stream, nullptr, /*allow_exceptions=*/false) : json();
  if (answer.is_object() && answer.contains("digest")) return answer;
  throw std::invalid_argument(fmt::format(
      "--reliability {}: found no reliability.json that can be read; expected a folder of \"blockweir reliability\"; "
      "make it with --out {}",
      folder.string(), results::shell_word(folder.string())));
}

/// Null if nothing is uncertain. Long computations are not started for a report.
json reliability_of(const fs::path& run, const scene::ReadScene& read, const json& kept, Questions& questions) {
  if (!kept.is_null()) {
    if (kept["digest"] == read.scene.digest) return kept;
    throw std::invalid_argument(
        fmt::format("--reliability: found an answer for another scene, of digest {}; expected that of this one, {}; "
                    "make it anew, with the same --set",
                    kept["digest"].get<std::string>(), read.scene.digest));
  }
  if (read.randomness.variables.empty()) return {};
  if (read.randomness.reliability.by != scene::CapacityBy::limit) {
    return {{"trouble",
             "it is not by limit analysis, and takes long: \"blockweir reliability SCENE --out FOLDER\" finds "
             "it, and \"blockweir report SCENE --reliability FOLDER\" shows it"}};
  }
  fmt::print(stderr, "asking for the reliability\n");
  const fs::path folder = run / "reliability";
  results::make_folder(folder);
  return questions.result_or_trouble([&] {
    try {
      return find_reliability({.scene = process::scene_of(run)}, read, folder).answer;
    } catch (const Interrupted&) {
      throw process::Stopped();
    }
  });
}

picture::ReportParts parts_of(const fs::path& run, const std::string& program, const json& kept, Questions& questions) {
  const scene::ReadScene read = scene::read(process::scene_of(run));
  picture::ReportParts parts{.scene = read.scene, .run = run, .program = program};
  parts.reliability = reliability_of(run, read, kept, questions);
  parts.summary = sound_summary(run);
  fmt::print(stderr, "asking for the level of failure and the factors of safety; Ctrl-C writes the page without\n");
  const process::TemporaryFolder scratch;
  process::AskOptions question{
      .scene = process::scene_of(run), .out = scratch.path() / "level", .quiet = true, .tells_progress = true};
  parts.level = questions.result_or_trouble([&] {
    process::Asked asked = process::ask("level", question);
    asked.answer["scene_warnings"] = asked.scene.warnings;
    return asked.answer;
  });
  question.out = scratch.path() / "safety";
  parts.safety = questions.result_or_trouble([&] {
    json cases = json::array();
    safety_answers(question, cases);
    return cases;
  });
  parts.home = process::home_of_external(parts.scene, run).string();
  std::vector<const char*> commands{"run", "level", "safety", "report"};
  if (!parts.reliability.is_null()) commands.insert(commands.end() - 1, "reliability");
  for (const char* command : commands) {
    parts.commands.push_back(fmt::format("blockweir {} scene.toml", command));
  }
  return parts;
}

/// That of a question has one, that of samples has not.
void require_scene(const fs::path& folder, const std::string& answers) {
  if (fs::exists(process::scene_of(folder))) return;
  throw std::invalid_argument(
      fmt::format("{}: found {}, without its scene; expected a folder of a run, or a scene; \"blockweir report SCENE "
                  "--reliability {}\" shows these results",
                  folder.string(), answers, results::shell_word(folder.string())));
}

}  // namespace

int write_report(const ReportOptions& options) {
  if (!options.out.empty()) results::require_writable_file("--out", options.out, {".html", ".htm"});
  constexpr double page_mb = 2;
  const fs::path run_folder = options.run.empty() ? fs::path(".") : options.run;
  results::require_room(!options.out.empty()              ? options.out
                        : process::is_run(options.source) ? options.source
                                                          : run_folder,
                        page_mb);
  const json kept = options.reliability.empty() ? json() : kept_reliability(options.reliability);
  fs::path run = options.source;
  std::optional<process::TemporaryFolder> scratch;
  if (!process::is_run(options.source)) {
    fs::path folder = options.run;
    if (const std::string found = process::answers_in(options.source); !found.empty()) {
      require_scene(options.source, found);
      fmt::print(stderr, "{}: these are {}, not of a run: their scene is run first\n", options.source.string(), found);
    }
    if (folder.empty() && !options.out.empty() && !may_write_here()) folder = scratch.emplace().path() / "run";
    process::RunResult made = process::run({.scene = options.source,
                                            .out = folder,
                                            .variant = options.variant,
                                            .overrides = options.overrides,
                                            .margin = true,
                                            .keeps_others = true});
    made.kept = !scratch;
    fmt::print("{}", process::report(made));
    if (made.exit_code != 0) return made.exit_code;
    if (made.asked_to_stop) throw process::Stopped();
    run = made.folder;
  } else if (!options.run.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: found a run, beside --run; expected a scene with it; leave it out, or name the scene",
                    options.source.string()));
  } else if (!options.variant.empty() || !options.overrides.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: found a run, beside --set or --variant; expected a scene with them; leave them out, or name "
                    "the scene",
                    options.source.string()));
  }
  results::FolderLock::refuse_in_use(run);
  const fs::path out = options.out.empty() ? run / "report.html" : options.out;
  Questions questions;
  const picture::ReportParts parts = parts_of(run, options.program, kept, questions);
  results::replace_file(out, picture::report_page(picture::report_data(parts)));
  if (questions.stopped()) fmt::print(stderr, "stopped on request: the page is without what was not found by then\n");
  fmt::print("report  {}\n", out.string());
  return questions.stopped() ? process::stopped_status : 0;
}

}  // namespace blockweir::study
