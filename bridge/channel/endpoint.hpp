// SPDX-License-Identifier: GPL-3.0-or-later
// Is an endpoint fit to be opened? ZeroMQ itself takes over an ipc path that somebody listens at.
#pragma once

#include <string>

namespace blockweir::channel {

[[nodiscard]] bool is_tcp(const std::string& endpoint);

/// Throws PeerError for an endpoint that is neither ipc://PATH nor tcp://HOST:PORT, an ipc path that is too long or
/// lies in no folder, and, when `listens`, one that a live process listens at. A stale ipc file is removed. Throws
/// std::invalid_argument for a tcp port that other machines reach, unless they `may_come`.
void check_endpoint(const std::string& endpoint, bool listens, bool may_come);

}  // namespace blockweir::channel
