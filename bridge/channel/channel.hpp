// SPDX-License-Identifier: GPL-3.0-or-later
// A ZeroMQ connection between solid and fluid: opens, exchanges messages, and reports a failure in one line. C++17: the
// OpenFOAM plugin includes this.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "bridge/wire/message.hpp"

namespace blockweir::channel {

/// The partner died, hung, never connected, left, or sent something that is not a message. what() is one line for the
/// user: who, what, when, remedy.
struct PeerError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The partner's message is wrong, and the partner has not been told yet.
struct PartnerFault : PeerError {
  using PeerError::PeerError;
};

/// The partner ended the run on purpose (wire::Farewell) where a data message was expected.
struct PeerEnded : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// This process was asked to stop (SIGINT, SIGTERM) while it waited.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class Side { listens, connects };

struct Options {
  Side side = Side::listens;
  std::string endpoint;        ///< ipc://PATH, tcp://HOST:PORT
  std::string partner;         ///< name of the other side in messages, e.g. "fluid process (hydrostatic)"
  double timeout_s = 20;       ///< longest wait for a message without any sign of progress
  double open_timeout_s = 20;  ///< longest wait for the partner to connect
  std::string keys{};          ///< folder of this side's CURVE keys; empty: none
  bool insecure = false;       ///< allows a tcp port that other machines can reach without keys
};

class Channel {
 public:
  /// Opens the connection. Throws PeerError if the endpoint is taken, malformed or unreachable, and
  /// std::invalid_argument if the keys are wrong, or missing although other machines can reach the port.
  explicit Channel(const Options& options);
  ~Channel();
  Channel(Channel&&) noexcept;
  Channel& operator=(Channel&&) noexcept;

  /// Sends our Hello, waits for the partner's and refuses any difference, with both values; the partner is told.
  /// Returns the partner's.
  wire::Hello handshake(const wire::Hello& ours);
  /// The handshake of a side without a scene: waits for the partner's Hello, accepts all of it and returns it.
  wire::Hello agree(const std::string& role, const std::string& build);
  /// Sets the name of the other side in messages.
  void call_partner(const std::string& name);

  void send(const wire::Motion& motion);
  void send(const wire::Load& load);
  void send(const wire::Farewell& end);
  void send(const wire::Failure& failure);
  /// Call during long computations whenever there is progress. Sent only if nothing was sent for a quarter of the
  /// timeout.
  void send(const wire::Progress& progress);

  /// Wait for the next message, which must be of this kind. `into` keeps its storage: no allocation in steady state.
  /// Throw PeerError, PeerEnded or Interrupted.
  void receive(wire::Motion& into);
  void receive(wire::Load& into);

  /// Seconds so far: waiting for the partner; packing and unpacking; passing frames to ZeroMQ.
  [[nodiscard]] double waited_s() const;
  [[nodiscard]] double packed_s() const;
  [[nodiscard]] double wire_s() const;

 private:
  struct Line;
  std::unique_ptr<Line> line_;
};

/// Installs handlers that count SIGINT and SIGTERM. A wait for a Motion then throws Interrupted; a wait for a load goes
/// on until the second signal. If the launcher is killed, this process receives one signal, then SIGALRM, and one more
/// ends it. Output to a pipe that nobody reads is lost without further effect.
void catch_stop_signals();
[[nodiscard]] bool stop_requested();
[[nodiscard]] bool stop_requested_twice();

}  // namespace blockweir::channel
