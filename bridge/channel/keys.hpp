// SPDX-License-Identifier: GPL-3.0-or-later
// CURVE keys of the two sides, as files. C++17: the OpenFOAM plugin includes this.
#pragma once

#include <filesystem>
#include <string>

namespace blockweir::channel {

/// What one side holds, as ZeroMQ writes keys (Z85).
struct Keys {
  std::string own_secret;
  std::string own_public;
  std::string partner_public;
};

/// Makes `folder`/solid and `folder`/fluid, each all that its side needs: own-secret, which only the owner may read,
/// and partner-public. Throws std::invalid_argument, and replaces none, where there are keys already.
void make_keys(const std::filesystem::path& folder);

/// Of one side's folder. Throws std::invalid_argument when a file is missing, is no key, or lets others read a secret.
Keys read_keys(const std::filesystem::path& folder);

}  // namespace blockweir::channel
