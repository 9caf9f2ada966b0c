// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/checkpoint/checkpoints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/seconds.hpp"
#include "bridge/wire/checksum.hpp"

namespace blockweir::checkpoint {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kept = 2;
constexpr int format = 16;

std::uint64_t checksum(const std::string& bytes) {
  return wire::checksum(bytes.data(), bytes.size());
}

fs::path folder_in(const fs::path& run) {
  return run / "checkpoint";
}

fs::path file_of(const fs::path& run, const std::string& role, std::uint64_t window) {
  return folder_in(run) / fmt::format("{}-{}", role, window);
}

/// All checkpoints of a run are of one scene: those before this one help no more.
[[noreturn]] void refuse_changed_scene(const fs::path& file, const std::string& had, const std::string& has) {
  throw std::runtime_error(fmt::format(
      "{}: the scene was changed since: it has digest {} now, expected {}; put scene.toml of the run back as "
      "it was, or begin a new run in another folder",
      file.string(), has, had));
}

}  // namespace

Checkpoints::Checkpoints(const fs::path& folder, std::string role, std::string scene_digest, double every_s)
    : folder_(folder), role_(std::move(role)), digest_(std::move(scene_digest)), every_s_(every_s) {}

fs::path Checkpoints::file(std::uint64_t window) const {
  return file_of(folder_, role_, window);
}

bool Checkpoints::due() const {
  return every_s_ > 0 && seconds_since(last_) >= every_s_;
}

void Checkpoints::write(std::uint64_t window, const std::string& state) {
  if (folder_.empty()) return;
  results::make_folder(folder_in(folder_));
  results::replace_file(file(window), fmt::format("blockweir checkpoint {} {} {} {} {} {:016x}\n", format, role_,
                                                  window, digest_, state.size(), checksum(state)) +
                                          state);
  last_ = std::chrono::steady_clock::now();
  const std::vector<std::uint64_t> all = windows(folder_, role_);
  for (std::size_t i = 0; i + kept < all.size(); ++i) fs::remove(file(all[i]));
}

bool Checkpoints::has(std::uint64_t window) const {
  return fs::exists(file(window));
}

std::string Checkpoints::read(std::uint64_t window) const {
  const fs::path path = file(window);
  const auto refuse = [&](const std::string& found) {
    const std::vector<std::uint64_t> all = windows(folder_, role_);
    const bool others = std::any_of(all.begin(), all.end(), [&](std::uint64_t other) { return other < window; });
    throw std::runtime_error(fmt::format("{}: {}; {}run anew", path.string(), found,
                                         others ? "delete it to go on from the checkpoint before it, or " : ""));
  };
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse("no such checkpoint");
  std::string heading;
  std::getline(stream, heading);
  std::ostringstream rest;
  rest << stream.rdbuf();
  std::string state = std::move(rest).str();
  std::istringstream words(heading);
  std::string us;
  std::string what;
  int version = 0;
  std::string role;
  std::uint64_t number = 0;
  std::string digest;
  std::size_t size = 0;
  std::uint64_t sum = 0;
  if (!(words >> us >> what >> version >> role >> number >> digest >> size >> std::hex >> sum) || us != "blockweir") {
    refuse("not a checkpoint");
  }
  if (version != format) refuse(fmt::format("format {}, this blockweir reads {}", version, format));
  if (role != role_ || number != window) refuse(fmt::format("holds window {} of {}", number, role));
  if (digest != digest_) refuse_changed_scene(path, digest, digest_);
  if (size != state.size()) refuse(fmt::format("{} bytes, {} expected", state.size(), size));
  if (sum != checksum(state)) refuse("its content has changed since it was written");
  return state;
}

std::vector<std::uint64_t> windows(const fs::path& folder, const std::string& role) {
  std::vector<std::uint64_t> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder_in(folder), none)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind(role + "-", 0) != 0) continue;
    const char* const end = name.data() + name.size();
    std::uint64_t window = 0;
    const auto read = std::from_chars(name.data() + role.size() + 1, end, window);
    if (read.ec == std::errc() && read.ptr == end) found.push_back(window);
  }
  std::sort(found.begin(), found.end());
  return found;
}

void forget(const fs::path& folder) {
  fs::remove_all(folder_in(folder));
}

}  // namespace blockweir::checkpoint
