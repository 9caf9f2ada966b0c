// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/ask.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "bridge/process/failure_cause.hpp"
#include "bridge/process/programs.hpp"
#include "bridge/results/file_name.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/folder_lock.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::process {
namespace {

namespace fs = std::filesystem;

/// Prints the progress lines in blockweir-limit's log.
class Echo {
 public:
  Echo(fs::path log, bool quiet) : log_(std::move(log)), quiet_(quiet) {}

  void print_new_lines() {
    if (!stream_.is_open()) stream_.open(log_);
    for (std::string line; std::getline(stream_, line);) {
      if (!line.ends_with("linear systems solved") && !line.starts_with("limit analysis: ")) continue;
      if (!quiet_) fmt::print(stderr, "{}", results::for_stderr(line + "\n"));
      last_ = std::move(line);
    }
    stream_.clear();  // more may come
  }
  [[nodiscard]] const std::string& last() const { return last_; }

 private:
  fs::path log_;
  bool quiet_;
  std::ifstream stream_;
  std::string last_;
};

/// Has blockweir-limit answer into `folder`, which holds nothing of an earlier answer then.
nlohmann::json answer_in(const fs::path& folder, const std::string& question, const scene::Scene& scene,
                         const AskOptions& options) {
  constexpr double grace_s = 5;
  const fs::path file = folder / (question + ".json");
  fs::remove(file);
  for (const char* picture : {"mechanism.png", "mechanism-loads.png", "modes.png"}) fs::remove(folder / picture);
  fs::remove(folder / "limit.log");
  results::replace_file(scene_of(folder), scene.text);
  const StopsLater until_it_is_answered;
  Echo echo(folder / "limit.log", options.no_progress || (options.quiet && !options.tells_progress));
  Command command = limit_command(folder, question, file);
  if (options.moment_s) command.words.insert(command.words.end(), {"--moment", fmt::format("{}", *options.moment_s)});
  const Supervised supervised = supervise({command}, folder, grace_s, [&echo] {
    echo.print_new_lines();
    return true;
  });
  if (supervised.asked_to_stop) throw Stopped(echo.last());
  const std::string trouble = failure_cause(supervised, folder);
  const int status = supervised.ends.front().exit_code;
  if (!trouble.empty() && status == 2) throw std::invalid_argument(trouble);
  if (status > 128) {
    throw std::runtime_error(
        fmt::format("{}: no answer: {}; the system ends a program by signal 9 where memory runs short: free some, and "
                    "ask again",
                    options.scene.string(), trouble));
  }
  if (!trouble.empty()) throw std::runtime_error(trouble);
  std::ifstream stream(file);
  return nlohmann::json::parse(stream);
}

}  // namespace

void make_answer_folder(const fs::path& folder) {
  std::error_code none;
  const bool holds_nothing = std::all_of(fs::directory_iterator(folder, none), {}, [](const auto& entry) {
    return entry.path().filename() == results::FolderLock::file;
  });
  if (!holds_nothing && (!fs::exists(scene_of(folder), none) || !fs::exists(folder / "limit.log", none))) {
    throw std::invalid_argument(
        fmt::format("--out {}: found a folder that holds something else; expected a new one, or that "
                    "of an earlier answer; choose another folder",
                    folder.string()));
  }
  results::make_folder(folder);
}

fs::path answer_folder(const std::string& question, const AskOptions& options) {
  if (!options.out.empty()) return options.out;
  const std::string variant = options.variant.empty() ? "" : "-" + results::file_name(options.variant);
  return fs::path("runs") / (case_name(options.scene) + variant + "-" + question);
}

Asked ask(const std::string& question, const AskOptions& options) {
  scene::ReadScene read = scene::read_variant(options.scene, options.variant, options.overrides);
  for (const auto* messages : {&read.notes, &read.warnings}) {
    for (const auto& line : *messages) {
      if (!options.quiet) fmt::print(stderr, "{}", results::for_stderr(line.text() + "\n"));
    }
  }
  Asked asked{.folder = answer_folder(question, options), .scene = std::move(read.scene)};
  make_answer_folder(asked.folder);
  const results::FolderLock lock(asked.folder);  // where another holds it nothing is touched
  try {
    asked.answer = answer_in(asked.folder, question, asked.scene, options);
  } catch (...) {  // nothing half-written stays
    std::error_code kept;
    fs::remove(scene_of(asked.folder), kept);
    fs::remove(asked.folder / "limit.log", kept);
    fs::remove(asked.folder / results::FolderLock::file, kept);
    fs::remove(asked.folder, kept);  // where it is empty
    throw;
  }
  return asked;
}

}  // namespace blockweir::process
