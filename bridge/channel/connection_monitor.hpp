// SPDX-License-Identifier: GPL-3.0-or-later
// Follows through ZeroMQ's monitor who connects to a socket and disconnects: the partner, and strangers (logged).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <zmq.hpp>

namespace blockweir::channel {

class ConnectionMonitor {
 public:
  /// Create it before `socket` is opened. `endpoint`: name for messages; strangers are logged if it is a listening tcp
  /// port.
  ConnectionMonitor(zmq::context_t& context, zmq::socket_t& socket, std::string endpoint, bool logs);
  ~ConnectionMonitor();
  ConnectionMonitor(const ConnectionMonitor&) = delete;
  ConnectionMonitor& operator=(const ConnectionMonitor&) = delete;

  /// Processes all events so far.
  void update();
  [[nodiscard]] void* handle() { return events_.handle(); }

  /// Call on the arrival of a message: its sender is the partner.
  void identify_partner(int descriptor);
  /// Whether a handshake has been completed.
  [[nodiscard]] bool joined() const { return joined_; }
  /// Whether the partner has disconnected; messages that it sent before can still be read.
  [[nodiscard]] bool left() const { return left_; }
  /// Why the last handshake failed; empty: none did. A connecting side does not try again after `final_refusal`.
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
  std::map<int, std::string> connections_;  ///< address of each open connection, by descriptor
  int partner_ = -1;
  bool joined_ = false;
  bool left_ = false;
  bool final_refusal_ = false;
  std::string refusal_;
  int strangers_ = 0;
};

}  // namespace blockweir::channel
