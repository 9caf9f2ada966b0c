// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/ask.hpp"

#include <fmt/format.h>

#include <fstream>

#include "bridge/process/programs.hpp"
#include "bridge/process/trouble.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/folder_lock.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::process {
namespace {

namespace fs = std::filesystem;

/// Nothing that no answer has written is lost.
void require_own(const fs::path& folder) {
  std::error_code unreadable;
  if (!fs::exists(folder, unreadable) || fs::is_empty(folder, unreadable)) return;
  if (fs::exists(scene_of(folder), unreadable) && fs::exists(folder / "limit.log", unreadable)) return;
  throw std::invalid_argument(
      fmt::format("--out {}: found a folder that holds something else; expected a new one, or that "
                  "of an earlier answer; choose another folder",
                  folder.string()));
}

}  // namespace

Asked ask(const std::string& question, const AskOptions& options) {
  constexpr double grace_s = 5;
  scene::ReadScene read = scene::read_variant(options.scene, options.variant, options.overrides);
  for (const auto& note : read.notes) fmt::print(stderr, "{}\n", note.text());
  for (const auto& warning : read.warnings) fmt::print(stderr, "{}\n", warning.text());
  Asked asked{.folder = options.out, .scene = std::move(read.scene)};
  if (asked.folder.empty()) asked.folder = fs::path("runs") / (case_name(options.scene) + "-" + question);
  require_own(asked.folder);
  results::make_folder(asked.folder);
  const results::FolderLock lock(asked.folder);
  const fs::path file = asked.folder / (question + ".json");
  fs::remove(file);
  fs::remove(asked.folder / "mechanism.png");
  results::replace_file(scene_of(asked.folder), asked.scene.text);
  const StopsLater until_it_is_answered;
  const Supervised supervised =
      supervise({limit_command(asked.folder, question, file)}, asked.folder, grace_s, [] { return true; });
  const std::string trouble = supervised.interrupted ? "stopped on request" : first_trouble(supervised, asked.folder);
  if (!trouble.empty()) throw std::runtime_error(trouble);
  std::ifstream stream(file);
  asked.answer = nlohmann::json::parse(stream);
  return asked;
}

}  // namespace blockweir::process
