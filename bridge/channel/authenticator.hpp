// SPDX-License-Identifier: GPL-3.0-or-later
// Decides who may connect to a tcp port: with keys, the partner only; without keys, any client with the present ZeroMQ
// protocol. ZeroMQ asks at the end of each handshake (ZAP, rfc.zeromq.org/spec/27).
#pragma once

#include <string>
#include <zmq.hpp>

namespace blockweir::channel {

class Authenticator {
 public:
  /// Create it before the socket is opened. `partner_public`: Z85; empty: no keys.
  Authenticator(zmq::context_t& context, const std::string& partner_public);

  /// Answers all waiting requests.
  void answer();
  [[nodiscard]] void* handle() { return questions_.handle(); }

 private:
  zmq::socket_t questions_;
  std::string partner_;  ///< 32 bytes
};

}  // namespace blockweir::channel
