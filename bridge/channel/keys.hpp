// SPDX-License-Identifier: GPL-3.0-or-later
// CURVE keys of the two sides, as files. C++17: the OpenFOAM plugin includes this.
#pragma once

#include <filesystem>
#include <string>

namespace blockweir::channel {

/// The keys of one side, in ZeroMQ's format (Z85).
struct Keys {
  std::string own_secret;
  std::string own_public;
  std::string partner_public;
};

/// Makes `folder`/solid and `folder`/fluid, each with the files that its side needs: own-secret, readable by the owner
/// only, and partner-public. Throws std::invalid_argument if there are keys already; they are not replaced.
void make_keys(const std::filesystem::path& folder);

/// Reads one side's folder. Throws std::invalid_argument if a file is missing, is no key, or lets others read a secret.
Keys read_keys(const std::filesystem::path& folder);

}  // namespace blockweir::channel
