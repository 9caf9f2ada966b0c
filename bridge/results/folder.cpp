// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/results/folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

namespace blockweir::results {
namespace {

namespace fs = std::filesystem;

/// Why nothing can be created in `folder`; empty if it can.
std::string obstacle(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return folder.string() + " is no folder";
  if (::access(folder.c_str(), W_OK | X_OK) == 0) return "";
  return fmt::format("cannot write in {} ({})", folder.string(), std::generic_category().message(errno));
}

[[noreturn]] void refuse_folder(const fs::path& folder, const std::string& found) {
  throw std::invalid_argument(fmt::format(
      "--out {}: {}; expected a folder that can be made and written; choose another --out", folder.string(), found));
}

}  // namespace

void make_folder(const fs::path& folder) {
  const fs::path full = fs::absolute(folder);
  fs::path existing = full;
  std::error_code error;
  // symlink_status also stops at a link that leads nowhere.
  while (!fs::exists(fs::symlink_status(existing, error)) && existing.has_relative_path()) {
    existing = existing.parent_path();
  }
  if (const std::string found = obstacle(existing); !found.empty()) refuse_folder(folder, found);
  fs::create_directories(full, error);
  if (!error) return;
  const std::string found = fmt::format("cannot be made ({})", error.message());
  for (fs::path made = full; made != existing; made = made.parent_path()) fs::remove(made, error);
  refuse_folder(folder, found);
}

void require_writable_file(const char* option, const fs::path& file, const std::vector<std::string>& endings) {
  std::error_code error;
  const std::string found =
      fs::is_directory(file, error) ? "this is a folder" : obstacle(fs::absolute(file).parent_path());
  if (!found.empty()) {
    throw std::invalid_argument(
        fmt::format("{} {}: {}; expected a file that can be written; choose another", option, file.string(), found));
  }
  const bool is_device = fs::exists(file, error) && !fs::is_regular_file(file, error);
  if (is_device || std::find(endings.begin(), endings.end(), file.extension()) != endings.end()) return;
  throw std::invalid_argument(fmt::format("{} {}: expected a name that ends in {}; choose such a name", option,
                                          file.string(), fmt::join(endings, " or ")));
}

void require_room(const fs::path& place, double mb) {
  fs::path there = fs::absolute(place);
  std::error_code error;
  while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  if (!fs::is_regular_file(there, error) && !fs::is_directory(there, error)) return;  // a device, a pipe
  const fs::space_info room = fs::space(there, error);
  if (error) return;  // some network disks do not tell
  const double free_mb = static_cast<double>(room.available) / 1e6;
  if (free_mb >= mb) return;
  throw std::runtime_error(
      fmt::format("no room is left on the disk that holds {}: {:.2g} MB are free, expected at least {:.2g} MB; free "
                  "some, or choose another place with --out",
                  place.string(), free_mb, mb));
}

}  // namespace blockweir::results
