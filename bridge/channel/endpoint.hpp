// SPDX-License-Identifier: GPL-3.0-or-later
// Checks an endpoint before it is opened. ZeroMQ itself would take over an ipc path that another process listens at.
#pragma once

#include <string>

namespace blockweir::channel {

[[nodiscard]] bool is_tcp(const std::string& endpoint);

/// Throws std::invalid_argument for an endpoint that is not ipc://PATH or tcp://HOST:PORT, an ipc path that is too long
/// or whose folder is missing, and a tcp port that other machines can reach, unless `may_come`. If `listens`, throws
/// PeerError for an ipc path where a live process listens or a file is, and removes a stale ipc file.
void check_endpoint(const std::string& endpoint, bool listens, bool may_come);

/// Removes the file of an ipc endpoint, which ZeroMQ leaves behind.
void remove_socket_file(const std::string& endpoint);

}  // namespace blockweir::channel
