// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/engine/batch_files.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/scene/read/digest.hpp"

namespace blockweir::engine {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* ending = ".answers";

[[noreturn]] void refuse(const fs::path& folder, const std::string& found) {
  throw std::runtime_error(
      fmt::format("{}: {}; expected what \"blockweir ... --engine slurm\" has written there; start "
                  "that command again",
                  folder.string(), found));
}

}  // namespace

std::vector<std::string> digests_of(const Work& work) {
  const std::string common = work.common.dump();
  std::vector<std::string> digests;
  for (const json& item : work.items) digests.push_back(scene::digest(common + item.dump()));
  return digests;
}

void BatchFiles::write(const json& common, std::size_t batch, const std::vector<std::string>& digests,
                       const std::vector<json>& items) const {
  results::make_folder(folder_);
  std::string lines = json{{"common", common}, {"batch", batch}}.dump() + "\n";
  for (std::size_t i = 0; i < items.size(); ++i) lines += json{digests[i], items[i]}.dump() + "\n";
  results::replace_file(folder_ / "items.jsonl", lines);
}

BatchFiles::Task BatchFiles::read(int task) const {
  std::ifstream stream(folder_ / "items.jsonl");
  std::string line;
  const json head = std::getline(stream, line) ? json::parse(line, nullptr, /*allow_exceptions=*/false) : json();
  if (!head.is_object() || !head.contains("batch")) refuse(folder_, "found no items.jsonl that can be read");
  const auto batch = head["batch"].get<std::size_t>();
  const std::size_t first = batch * static_cast<std::size_t>(task);
  Task own{.common = head["common"], .digests = {}, .items = {}};
  for (std::size_t i = 0; std::getline(stream, line) && i < first + batch; ++i) {
    if (i < first) continue;
    const json entry = json::parse(line, nullptr, /*allow_exceptions=*/false);
    if (!entry.is_array() || entry.size() != 2) refuse(folder_, fmt::format("line {} of items.jsonl is none", i + 2));
    own.digests.push_back(entry[0]);
    own.items.push_back(entry[1]);
  }
  if (task < 0 || own.items.empty()) refuse(folder_, fmt::format("found no task {}", task));
  return own;
}

void BatchFiles::leave(const std::string& name, const Answers& answers) const {
  const json all = {{"had_s", answers.effort.had_s},
                    {"worked_s", answers.effort.worked_s},
                    {"worked_on", answers.measured.items},
                    {"processors", answers.measured.processors},
                    {"answers", answers.by_digest}};
  results::replace_file(folder_ / (name + ending), all.dump() + "\n");
}

Answers BatchFiles::take(std::set<std::string>& seen, const std::string& prefix) const {
  Answers taken;
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator(folder_, gone)) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(ending) || !name.starts_with(prefix) || !seen.insert(name).second) continue;
    std::ifstream stream(entry.path());
    const json all = json::parse(stream, nullptr, /*allow_exceptions=*/false);
    if (!all.is_object() || !all.contains("answers")) continue;  // of a disk that has lost it: it is done again
    taken.effort.had_s += all.value("had_s", 0.0);
    taken.effort.worked_s += all.value("worked_s", 0.0);
    if (const std::size_t items = all.value("worked_on", std::size_t{0}); items > 0) {
      taken.measured.items += items;
      taken.measured.worked_s += all.value("worked_s", 0.0);
      taken.measured.processors = all.value("processors", 1);
    }
    for (const auto& [digest, answer] : all["answers"].items()) taken.by_digest[digest] = answer;
  }
  return taken;
}

}  // namespace blockweir::engine
