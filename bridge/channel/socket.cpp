// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/channel/socket.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/channel/endpoint.hpp"
#include "bridge/channel/keys.hpp"
#include "bridge/channel/retry_on_interrupt.hpp"

namespace blockweir::channel {
namespace {

constexpr int linger_ms = 1000;  // a last word still goes out
constexpr int reconnect_ms = 5;  // who connects may come first: its next try is not far off

/// An I/O thread answers even while its process computes; a stopped or vanished process does not. Only who connects
/// beats, and says how long the listener is to wait for the next one: ZeroMQ 4.3.4 aborts where a beat of the
/// listener's own falls due for a stranger who has just left.
/// The wire has the time to live in tenths of a second, as 16 bits.
void keep_beating(zmq::socket_t& socket, double timeout_s) {
  constexpr double longest_ms = 3e6;  // twice as long is still below 65,535 tenths
  const int every_ms = static_cast<int>(std::clamp(1000 * timeout_s / 4, 100.0, longest_ms));
  socket.set(zmq::sockopt::heartbeat_ivl, every_ms);
  socket.set(zmq::sockopt::heartbeat_timeout, 2 * every_ms);
  socket.set(zmq::sockopt::heartbeat_ttl, 2 * every_ms);
}

void secure(zmq::socket_t& socket, const Keys& keys, bool listens) {
  socket.set(zmq::sockopt::curve_secretkey, keys.own_secret);
  if (listens) {
    socket.set(zmq::sockopt::curve_server, 1);
    return;
  }
  socket.set(zmq::sockopt::curve_publickey, keys.own_public);
  socket.set(zmq::sockopt::curve_serverkey, keys.partner_public);
}

}  // namespace

std::string set_up(zmq::socket_t& socket, const Options& options) {
  const bool listens = options.side == Side::listens;
  check_endpoint(options.endpoint, listens, options.insecure || !options.keys.empty());
  socket.set(zmq::sockopt::linger, linger_ms);
  socket.set(zmq::sockopt::reconnect_ivl, reconnect_ms);
  if (!listens) keep_beating(socket, options.timeout_s);
  socket.set(zmq::sockopt::maxmsgsize, std::int64_t{1} << 30);
  socket.set(zmq::sockopt::ipv6, options.endpoint.find('[') != std::string::npos ? 1 : 0);
  if (options.keys.empty()) return {};
  if (!is_tcp(options.endpoint)) {
    throw std::invalid_argument(
        fmt::format("--keys: found endpoint {}, which only this machine reaches; expected tcp://HOST:PORT, whose "
                    "connections keys encrypt; leave --keys out",
                    options.endpoint));
  }
  const Keys keys = read_keys(options.keys);
  secure(socket, keys, listens);
  return keys.partner_public;
}

void open_at_endpoint(zmq::socket_t& socket, const Options& options) {
  const bool listens = options.side == Side::listens;
  try {
    retry_on_interrupt([&] {
      if (listens) {
        socket.bind(options.endpoint);
      } else {
        socket.connect(options.endpoint);
      }
    });
  } catch (const zmq::error_t& error) {
    throw PeerError(fmt::format("cannot {} {}: {}; choose another --endpoint", listens ? "listen at" : "connect to",
                                options.endpoint, error.what()));
  }
}

}  // namespace blockweir::channel
