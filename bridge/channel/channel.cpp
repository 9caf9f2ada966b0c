// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/channel/channel.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <zmq.hpp>

#include "bridge/channel/endpoint.hpp"
#include "bridge/channel/hello.hpp"
#include "bridge/wire/codec.hpp"

namespace blockweir::channel {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr int linger_ms = 1000;       // a last word still goes out
constexpr double poll_slice_s = 0.2;  // how late a stop signal may be seen that arrived just before a poll
constexpr double spin_s = 50e-6;      // answers of a small scene come within this: no sleep, no wake-up

}  // namespace

/// The socket, its monitor and the buffers.
struct Channel::Line {
  explicit Line(const Options& o)
      : options(o), socket(context, zmq::socket_type::pair), monitor(context, zmq::socket_type::pair) {
    socket.set(zmq::sockopt::linger, linger_ms);
    // The other side's I/O thread answers even while it computes; a stopped or vanished process does not.
    const int heartbeat_ms = static_cast<int>(std::max(100.0, 1000 * options.timeout_s / 4));
    socket.set(zmq::sockopt::heartbeat_ivl, heartbeat_ms);
    socket.set(zmq::sockopt::heartbeat_timeout, 2 * heartbeat_ms);
    socket.set(zmq::sockopt::maxmsgsize, std::int64_t{1} << 30);
    const std::string events = fmt::format("inproc://monitor-{}", static_cast<const void*>(this));
    zmq_socket_monitor(
        socket.handle(), events.c_str(),
        ZMQ_EVENT_ACCEPTED | ZMQ_EVENT_CONNECTED | ZMQ_EVENT_HANDSHAKE_SUCCEEDED | ZMQ_EVENT_DISCONNECTED);
    monitor.connect(events);
    open();
  }
  ~Line() { zmq_socket_monitor(socket.handle(), nullptr, 0); }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  void open() {
    check_endpoint(options.endpoint, options.side == Side::listens);
    try {
      if (options.side == Side::listens) {
        socket.bind(options.endpoint);
      } else {
        socket.connect(options.endpoint);
      }
    } catch (const zmq::error_t& error) {
      throw PeerError(fmt::format("cannot {} {}: {}; choose another --endpoint",
                                  options.side == Side::listens ? "listen at" : "connect to", options.endpoint,
                                  error.what()));
    }
  }

  template <class Message>
  void send(const Message& message) {
    const auto start = Clock::now();
    wire::encode(message, builder);
    packed_s += seconds_since(start);
    socket.send(zmq::const_buffer(builder.GetBufferPointer(), builder.GetSize()), zmq::send_flags::dontwait);
  }

  /// True when the partner has gone; what it still sent can be read all the same. A third process that comes to a line
  /// in use is turned away by ZeroMQ, and its going is not the partner's: connections are told apart by descriptor.
  bool partner_left() {
    zmq::message_t event;
    while (monitor.recv(event, zmq::recv_flags::dontwait)) {
      std::uint16_t number = 0;
      std::int32_t descriptor = 0;
      std::memcpy(&number, event.data(), sizeof number);
      std::memcpy(&descriptor, static_cast<const char*>(event.data()) + sizeof number, sizeof descriptor);
      if (!joined && (number == ZMQ_EVENT_ACCEPTED || number == ZMQ_EVENT_CONNECTED)) partner_descriptor = descriptor;
      if (number == ZMQ_EVENT_HANDSHAKE_SUCCEEDED) joined = true;
      if (number == ZMQ_EVENT_DISCONNECTED && joined && descriptor == partner_descriptor) left = true;
      zmq::message_t address;
      (void)monitor.recv(address, zmq::recv_flags::dontwait);
    }
    return left;
  }

  bool try_receive() { return socket.recv(incoming, zmq::recv_flags::dontwait).has_value(); }

  /// A pair socket has nowhere to put a message before its partner is there.
  void await_partner() {
    const auto start = Clock::now();
    while (!joined) {
      zmq::pollitem_t item{monitor.handle(), 0, ZMQ_POLLIN, 0};
      zmq_poll(&item, 1, static_cast<long>(1000 * poll_slice_s));
      (void)partner_left();
      if (stop_requested()) throw Interrupted("asked to stop");
      if (!joined && seconds_since(start) > options.open_timeout_s) {
        throw PeerError(fmt::format("{} has not come to {} within {:.3g} s; is it running, with the same --endpoint?",
                                    options.partner, options.endpoint, options.open_timeout_s));
      }
    }
  }

  /// Waits for the next message's bytes.
  void wait(double patience_s, const std::string& moment, bool (*give_up)()) {
    const auto start = Clock::now();
    while (!try_receive()) {
      if (give_up()) throw Interrupted("asked to stop");
      const double waited = seconds_since(start);
      if (waited < spin_s) continue;
      if (partner_left()) {
        if (try_receive()) break;
        throw PeerError(
            fmt::format("{} closed the line {}; see its own message for the cause", options.partner, moment));
      }
      if (waited > patience_s) {
        throw PeerError(fmt::format("{} has been silent for {:.3g} s at {} {}; [coupling] timeout_s sets the patience",
                                    options.partner, patience_s, options.endpoint, moment));
      }
      zmq::pollitem_t items[] = {{socket.handle(), 0, ZMQ_POLLIN, 0}, {monitor.handle(), 0, ZMQ_POLLIN, 0}};
      const double slice = std::min(poll_slice_s, patience_s - waited + 1e-3);
      zmq_poll(items, 2, std::max(1L, static_cast<long>(1000 * slice)));
    }
    waited_s += seconds_since(start);
  }

  /// ZeroMQ hands small messages out from wherever they stand in its own buffer.
  const void* aligned_bytes() {
    if (reinterpret_cast<std::uintptr_t>(incoming.data()) % wire::alignment == 0) return incoming.data();
    realigned.resize(incoming.size() / sizeof realigned.front() + 1);
    std::memcpy(realigned.data(), incoming.data(), incoming.size());
    return realigned.data();
  }

  template <class Message>
  void receive(wire::Kind kind, Message& into, double patience_s, const std::string& moment) {
    wait(patience_s, moment, kind == wire::Kind::load ? stop_requested_twice : stop_requested);
    const auto start = Clock::now();
    const void* data = aligned_bytes();
    try {
      const wire::Kind got = wire::verify(data, incoming.size());
      if (got == wire::Kind::end) {
        wire::End end;
        wire::decode(data, end);
        throw PeerEnded(end.reason);
      }
      if (got == wire::Kind::failure) {
        wire::Failure failure;
        wire::decode(data, failure);
        throw PeerError(fmt::format("{} stopped {}: {}", options.partner, moment, failure.text));
      }
      if (got != kind) throw wire::BadMessage("a message of another kind than was due");
      wire::decode(data, into);
    } catch (const wire::BadMessage& bad) {
      throw PeerError(fmt::format("{} sent {} ({})", options.partner, bad.what(), moment));
    }
    packed_s += seconds_since(start);
  }

  Options options;
  zmq::context_t context{1};
  zmq::socket_t socket;
  zmq::socket_t monitor;
  zmq::message_t incoming;
  std::vector<std::uint64_t> realigned;
  flatbuffers::FlatBufferBuilder builder;
  std::int32_t partner_descriptor = -1;
  bool joined = false;
  bool left = false;
  double waited_s = 0;
  double packed_s = 0;
  std::uint64_t window = 0;

  [[nodiscard]] std::string moment() const { return fmt::format("in window {}", window); }
};

Channel::Channel(const Options& options) : line_(std::make_unique<Line>(options)) {}
Channel::~Channel() = default;
Channel::Channel(Channel&&) noexcept = default;
Channel& Channel::operator=(Channel&&) noexcept = default;

wire::Hello Channel::handshake(const wire::Hello& ours) {
  line_->await_partner();
  line_->send(ours);
  wire::Hello theirs;
  line_->receive(wire::Kind::hello, theirs, line_->options.open_timeout_s, "at the handshake");
  const std::string differences = compare(ours, theirs);
  if (!differences.empty()) throw PeerError("handshake refused: " + differences);
  return theirs;
}

void Channel::send(const wire::Motion& motion) {
  line_->send(motion);
}
void Channel::send(const wire::Load& load) {
  line_->send(load);
}
void Channel::send(const wire::End& end) {
  line_->send(end);
}
void Channel::send(const wire::Failure& failure) {
  line_->send(failure);
}

void Channel::receive(wire::Motion& into) {
  line_->receive(wire::Kind::motion, into, line_->options.timeout_s, line_->moment());
  line_->window = into.window;
}

void Channel::receive(wire::Load& into) {
  line_->receive(wire::Kind::load, into, line_->options.timeout_s, line_->moment());
  line_->window = into.window;
}

double Channel::waited_s() const {
  return line_->waited_s;
}
double Channel::packed_s() const {
  return line_->packed_s;
}

}  // namespace blockweir::channel
