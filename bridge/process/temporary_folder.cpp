// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/temporary_folder.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace blockweir::process {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::error_code missing;
  const fs::path place = fs::temp_directory_path(missing);
  if (missing) {
    throw std::runtime_error(fmt::format(
        "found no folder for temporary files ({}); TMPDIR, or else /tmp, has to be one", missing.message()));
  }
  std::string name = (place / "blockweir-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error(fmt::format("cannot make a folder in {} ({}); TMPDIR names another place for it",
                                         place.string(), std::generic_category().message(errno)));
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace blockweir::process
