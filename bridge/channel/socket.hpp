// SPDX-License-Identifier: GPL-3.0-or-later
// A line's ZeroMQ socket: how it beats, what it takes, who may read it.
#pragma once

#include <string>
#include <zmq.hpp>

#include "bridge/channel/channel.hpp"

namespace blockweir::channel {

/// Before it is opened. The partner's public key, Z85; empty where the line has no keys. Throws what Channel does.
std::string set_up(zmq::socket_t& socket, const Options& options);

/// Throws PeerError when the endpoint is taken or out of reach.
void open_at_endpoint(zmq::socket_t& socket, const Options& options);

}  // namespace blockweir::channel
