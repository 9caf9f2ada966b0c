// SPDX-License-Identifier: GPL-3.0-or-later
// Checks an endpoint before it is opened. ZeroMQ itself would take over an ipc path that another process listens at.
#pragma once

#include <string>

namespace blockweir::channel {

[[nodiscard]] bool is_tcp(const std::string& endpoint);

/// Throws PeerError for an endpoint that is not ipc://PATH or tcp://HOST:PORT, an ipc path that is too long or whose
/// folder is missing, and, if `listens`, one where a live process listens. Removes a stale ipc file. Throws
/// std::invalid_argument for a tcp port that other machines can reach, unless `may_come`.
void check_endpoint(const std::string& endpoint, bool listens, bool may_come);

}  // namespace blockweir::channel
