// SPDX-License-Identifier: GPL-3.0-or-later
// A two-party ZeroMQ line between solid and fluid: opens, exchanges, and says in one line why it broke.
// C++17: the OpenFOAM plugin includes this.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "bridge/wire/message.hpp"

namespace blockweir::channel {

/// The partner died, hung, never came, left, or said something that is not a message. what() is one line for
/// the user: who, what, when, remedy.
struct PeerError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the partner said is wrong, and it has not been told yet.
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
  std::string partner;         ///< how messages call the other side, e.g. "fluid process (hydrostatic)"
  double timeout_s = 20;       ///< longest silence, without progress, while a message is awaited
  double open_timeout_s = 20;  ///< longest wait for the partner to arrive
  std::string keys{};          ///< folder of this side's CURVE keys; empty: none
  bool insecure = false;       ///< a tcp port that other machines reach may do without them
};

class Channel {
 public:
  /// Opens the line; throws PeerError when the endpoint is taken, malformed or unreachable, std::invalid_argument when
  /// the keys are wrong, or missing where other machines reach it.
  explicit Channel(const Options& options);
  ~Channel();
  Channel(Channel&&) noexcept;
  Channel& operator=(Channel&&) noexcept;

  /// Sends ours, waits for theirs, refuses any difference with both sides' values, and tells the partner; returns
  /// theirs.
  wire::Hello handshake(const wire::Hello& ours);
  /// The handshake of a side that has no scene of its own: waits for theirs, agrees to all of it, returns it.
  wire::Hello agree(const std::string& role, const std::string& build);
  /// How messages call the other side from now on.
  void call_partner(const std::string& name);

  void send(const wire::Motion& motion);
  void send(const wire::Load& load);
  void send(const wire::Farewell& end);
  void send(const wire::Failure& failure);
  /// To be called while this side computes what it owes, whenever it has come further: goes out where nothing has for a
  /// quarter of timeout_s.
  void send(const wire::Progress& progress);

  /// Wait for the next message, which must be of this kind. Storage in `into` is reused: no allocation in
  /// steady state. Throw PeerError, PeerEnded or Interrupted.
  void receive(wire::Motion& into);
  void receive(wire::Load& into);

  /// Seconds so far: waiting for the partner; packing and unpacking; handing frames to ZeroMQ.
  [[nodiscard]] double waited_s() const;
  [[nodiscard]] double packed_s() const;
  [[nodiscard]] double wire_s() const;

 private:
  struct Line;
  std::unique_ptr<Line> line_;
};

/// Installs handlers that count SIGINT and SIGTERM. Whoever waits for a Motion then throws Interrupted; a load that is
/// on its way is still waited for, until asked twice. A launcher that is killed asks once, then an alarm, then another
/// ends the process. What is written to a pipe that nobody reads is lost, no more.
void catch_stop_signals();
[[nodiscard]] bool stop_requested();
[[nodiscard]] bool stop_requested_twice();

}  // namespace blockweir::channel
