// SPDX-License-Identifier: GPL-3.0-or-later
// The ZeroMQ socket of a connection: heartbeat, limits, keys.
#pragma once

#include <string>
#include <zmq.hpp>

#include "bridge/channel/channel.hpp"

namespace blockweir::channel {

/// Call before the socket is opened. Returns the partner's public key, Z85; empty without keys. Throws as Channel does.
std::string set_up(zmq::socket_t& socket, const Options& options);

/// Throws PeerError if the endpoint is taken or cannot be reached.
void open_at_endpoint(zmq::socket_t& socket, const Options& options);

}  // namespace blockweir::channel
