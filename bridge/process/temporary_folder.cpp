// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/temporary_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace blockweir::process {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view stem = "blockweir-";
constexpr std::size_t random_letters = 6;

/// Whether its process, and all that this started, have ended: then nobody holds its lock.
bool is_left_behind(const fs::path& folder) {
  const std::string name = folder.filename().string();
  if (!name.starts_with(stem) || name.size() != stem.size() + random_letters) return false;
  const int lock = ::open((folder / results::FolderLock::file).c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (lock < 0) return false;
  const bool free = ::flock(lock, LOCK_EX | LOCK_NB) == 0;
  ::close(lock);
  return free;
}

void remove_left_behind(const fs::path& place) {
  std::error_code unknown;
  for (const auto& entry : fs::directory_iterator(place, unknown)) {
    if (is_left_behind(entry.path())) fs::remove_all(entry.path(), unknown);
  }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::error_code missing;
  const fs::path place = fs::temp_directory_path(missing);
  if (missing) {
    throw std::runtime_error(fmt::format(
        "found no folder for temporary files ({}); TMPDIR, or else /tmp, has to be one", missing.message()));
  }
  remove_left_behind(place);
  // Until it is locked it has a name that is_left_behind() does not know: launchers that start at the same time would
  // take it for one that was left.
  std::string fresh = (place / (std::string(stem) + "new-" + std::string(random_letters, 'X'))).string();
  std::error_code failed;
  if (::mkdtemp(fresh.data()) != nullptr) {
    lock_.emplace(fresh);
    path_ = place / (std::string(stem) + fresh.substr(fresh.size() - random_letters));
    fs::rename(fresh, path_, failed);
  } else {
    failed = {errno, std::generic_category()};
  }
  if (failed) {
    throw std::runtime_error(fmt::format("cannot make a folder in {} ({}); TMPDIR names another place for it",
                                         place.string(), failed.message()));
  }
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace blockweir::process
