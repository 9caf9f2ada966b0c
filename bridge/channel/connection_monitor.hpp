// SPDX-License-Identifier: GPL-3.0-or-later
// Who has come to a socket and gone again, from ZeroMQ's monitor: the partner, and strangers, who are logged.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <zmq.hpp>

namespace blockweir::channel {

class ConnectionMonitor {
 public:
  /// Before `socket` is opened. `endpoint`: how messages call it; strangers are logged where it is a tcp port that
  /// listens.
  ConnectionMonitor(zmq::context_t& context, zmq::socket_t& socket, std::string endpoint, bool logs);
  ~ConnectionMonitor();
  ConnectionMonitor(const ConnectionMonitor&) = delete;
  ConnectionMonitor& operator=(const ConnectionMonitor&) = delete;

  /// Takes note of all that has happened.
  void update();
  [[nodiscard]] void* handle() { return events_.handle(); }

  /// Whoever a message comes from is the partner.
  void identify_partner(int descriptor);
  /// Somebody has shaken hands.
  [[nodiscard]] bool joined() const { return joined_; }
  /// The partner has gone; what it still sent can be read all the same.
  [[nodiscard]] bool left() const { return left_; }
  /// Why the last handshake failed; empty: none did. A side that connects does not try again after `final_refusal`.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  [[nodiscard]] bool final_refusal() const { return final_refusal_; }
  [[nodiscard]] int strangers() const { return strangers_; }

 private:
  void note(std::uint16_t event, std::int32_t value);
  void gone(int descriptor);
  void log(const std::string& address);

  zmq::socket_t& socket_;
  zmq::socket_t events_;
  std::string endpoint_;
  bool logs_;
  std::map<int, std::string> connections_;  ///< connections by descriptor: their addresses
  int partner_ = -1;
  bool joined_ = false;
  bool left_ = false;
  bool final_refusal_ = false;
  std::string refusal_;
  int strangers_ = 0;
};

}  // namespace blockweir::channel
