// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/channel/channel.hpp"

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <thread>
#include <tuple>
#include <zmq.hpp>

#include "bridge/channel/authenticator.hpp"
#include "bridge/channel/connection_monitor.hpp"
#include "bridge/channel/endpoint.hpp"
#include "bridge/channel/handshake.hpp"
#include "bridge/channel/incoming.hpp"
#include "bridge/channel/outgoing.hpp"
#include "bridge/channel/retry_on_interrupt.hpp"
#include "bridge/channel/socket.hpp"
#include "bridge/channel/trace.hpp"
#include "bridge/results/seconds.hpp"
#include "bridge/wire/codec.hpp"

namespace blockweir::channel {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double poll_slice_s = 0.2;  // how late a stop signal may be seen that arrived just before a poll
constexpr double spin_s = 1e-3;       // answers on some ten thousand panels come within this: no sleep, no wake-up

template <class Message>
constexpr bool is_of_a_window = std::is_same_v<Message, wire::Motion> || std::is_same_v<Message, wire::Load>;

}  // namespace

/// The socket, those who come to it, and the buffers.
struct Channel::Line {
  explicit Line(const Options& o)
      : options(o),
        listens(o.side == Side::listens),
        socket(context, zmq::socket_type::pair),
        monitor(context, socket, o.endpoint, listens && is_tcp(o.endpoint)) {
    const std::string partner_public = set_up(socket, options);
    if (listens && is_tcp(options.endpoint)) {
      authenticator.emplace(context, partner_public);
      socket.set(zmq::sockopt::zap_domain, "blockweir");  // asked without keys, too: turns ZMTP 1, any bytes, away
    }
    open_at_endpoint(socket, options);
  }
  ~Line() {
    if (listens) remove_socket_file(options.endpoint);
  }

  template <class Message>
  void send(const Message& message) {
    const auto start = Clock::now();
    zmq::message_t frame = outgoing.frame([&](auto& builder) {
      if constexpr (is_of_a_window<Message>) {
        wire::encode(message, builder, parts);
      } else {
        wire::encode(message, builder);
      }
    });
    const auto packed = Clock::now();
    for (wire::Part& part : parts) {
      send_part(frame, zmq::send_flags::sndmore);
      frame = sent_from(part);
    }
    send_part(frame, zmq::send_flags::none);
    parts.clear();
    packed_s += seconds_between(start, packed);
    last_sent = Clock::now();
    wire_s += seconds_between(packed, last_sent);
    if constexpr (is_of_a_window<Message>) {
      if (trace) trace->add("send", message.window, start, last_sent);
    }
  }

  void send_part(zmq::message_t& frame, zmq::send_flags flags) {
    retry_on_interrupt([&] { return socket.send(frame, flags | zmq::send_flags::dontwait); });
  }

  /// Until something happens at the line, or `longest_s` has passed.
  void poll(double longest_s) {
    zmq::pollitem_t items[] = {{monitor.handle(), 0, ZMQ_POLLIN, 0},
                               {socket.handle(), 0, ZMQ_POLLIN, 0},
                               {authenticator ? authenticator->handle() : nullptr, 0, ZMQ_POLLIN, 0}};
    zmq_poll(items, authenticator ? 3 : 2, std::max(1L, static_cast<long>(1000 * longest_s)));
    monitor.update();  // before the answer: whoever is turned away by it can still be asked for an address
    if (authenticator) authenticator->answer();
  }

  bool partner_left() {
    monitor.update();
    return monitor.left();
  }

  /// A pair socket has nowhere to put a message before its partner is there.
  void await_partner() {
    const auto start = Clock::now();
    for (monitor.update(); !monitor.joined(); monitor.update()) {
      poll(poll_slice_s);
      if (stop_requested()) throw Interrupted("asked to stop");
      if (monitor.joined()) return;
      if (!listens && monitor.final_refusal()) {
        throw PeerError(
            fmt::format("no handshake with {} at {}: {}; are both sides given --keys of one \"blockweir keys\"?",
                        options.partner, options.endpoint, monitor.refusal()));
      }
      if (seconds_since(start) > options.open_timeout_s) {
        const std::string met = monitor.strangers() > 0      ? fmt::format("{} other clients were", monitor.strangers())
                                : !monitor.refusal().empty() ? "a client that left during the handshake was"
                                                             : "";
        throw PeerError(fmt::format(
            "no connection with the {} at {} within {:.3g} s{}; is it running, with the same {}?", options.partner,
            options.endpoint, options.open_timeout_s, met.empty() ? "" : " (" + met + " there)",
            options.keys.empty() ? "--endpoint" : "--endpoint, and --keys of the same make"));
      }
    }
  }

  /// Waits for the next message's bytes.
  void wait(double patience_s, const std::string& moment, bool (*give_up)()) {
    const auto start = Clock::now();
    while (!incoming.receive()) {
      if (give_up()) throw Interrupted("asked to stop");
      const double waited = seconds_since(start);
      if (waited < spin_s && last_wait_s < spin_s) {
        std::this_thread::yield();  // to those that bring the answer, where cores are few
        continue;
      }
      if (partner_left()) {
        if (incoming.receive()) break;
        socket.set(zmq::sockopt::linger, 0);  // the partner is gone: drop unsent messages
        throw PeerError(
            fmt::format("{} closed the line {}; see its own message for the cause", options.partner, moment));
      }
      if (waited > patience_s) {
        throw PeerError(fmt::format(
            "{} has been silent for {:.3g} s at {} {}{}; [coupling] timeout_s sets the patience", options.partner,
            patience_s, options.endpoint, moment, progress.text.empty() ? "" : ": it hangs since " + progress.text));
      }
      poll(std::min(poll_slice_s, patience_s - waited + 1e-3));
    }
    monitor.identify_partner(incoming.source());
    last_wait_s = seconds_since(start);
    waited_s += last_wait_s;
  }

  /// Waits for the next message. A partner that reports progress is waited for as long as it does.
  template <class Message>
  void receive(wire::Kind kind, Message& into, double patience_s, const std::string& moment) {
    progress.text.clear();
    const auto start = Clock::now();
    do {
      wait(patience_s, moment, kind == wire::Kind::load ? stop_requested_twice : stop_requested);
    } while (!take(kind, into, moment));
    if constexpr (is_of_a_window<Message>) {
      if (trace) trace->add("wait", into.window, start, Clock::now());
    }
  }

  /// Rejects a wrong message; the partner is told.
  [[noreturn]] void refuse(const std::string& why) {
    send(wire::Failure{why});
    throw PeerError(why);
  }

  void begin(const wire::Hello& ours, const wire::Hello& theirs) {
    const std::string differences = compare(ours, theirs);
    if (!differences.empty()) refuse("handshake refused: " + differences);
    blocks = ours.block_names.size();
    trace = Trace::of(ours.role);
  }

  /// Decodes a received frame; false if it was the partner's progress.
  template <class Message>
  bool take(wire::Kind kind, Message& into, const std::string& moment) {
    const auto start = Clock::now();
    const wire::Part frame = incoming.frame();
    try {
      const wire::Kind got = wire::verify(frame);
      if (got == wire::Kind::progress && kind != wire::Kind::hello) {
        wire::decode(frame, progress);
        return false;
      }
      if (got == wire::Kind::end) {
        wire::Farewell end;
        wire::decode(frame, end);
        throw PeerEnded(end.reason);
      }
      if (got == wire::Kind::failure) {
        wire::Failure failure;
        wire::decode(frame, failure);
        throw PeerError(fmt::format("{} stopped {}: {}", options.partner, moment, failure.text));
      }
      if (got != kind) throw wire::BadMessage("a message of another kind than the one expected");
      incoming.decode(frame, into);
    } catch (const wire::BadMessage& bad) {
      refuse(fmt::format("{} sent {} ({})", options.partner, bad.what(), moment));
    }
    packed_s += seconds_since(start);
    return true;
  }

  Options options;
  bool listens;
  Outgoing outgoing;
  zmq::context_t context{1};
  zmq::socket_t socket;
  ConnectionMonitor monitor;
  std::optional<Authenticator> authenticator;
  Incoming incoming{socket};
  std::vector<wire::Part> parts;
  std::unique_ptr<Trace> trace;  ///< null: nobody asks for one
  double waited_s = 0;
  double last_wait_s = 0;  ///< after a long wait the next is likely to be long: who keeps looking is in the way
  double packed_s = 0;
  double wire_s = 0;
  Clock::time_point last_sent;
  wire::Progress progress;  ///< last progress of the partner; empty: none
  std::uint64_t window = 0;
  std::size_t blocks = 0;  ///< that the handshake was on

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
  line_->begin(ours, theirs);
  return theirs;
}

wire::Hello Channel::agree(const std::string& role, const std::string& build) {
  line_->await_partner();
  wire::Hello hello;
  line_->receive(wire::Kind::hello, hello, line_->options.open_timeout_s, "at the handshake");
  wire::Hello ours = hello;
  std::tie(ours.protocol, ours.role, ours.build) = std::make_tuple(wire::protocol_version, role, build);
  line_->begin(ours, hello);
  line_->send(ours);
  return ours;
}

void Channel::call_partner(const std::string& name) {
  line_->options.partner = name;
}

void Channel::send(const wire::Motion& motion) {
  line_->send(motion);
}
void Channel::send(const wire::Load& load) {
  line_->send(load);
}
void Channel::send(const wire::Farewell& end) {
  line_->send(end);
}
void Channel::send(const wire::Failure& failure) {
  line_->send(failure);
}
void Channel::send(const wire::Progress& progress) {
  if (seconds_since(line_->last_sent) > line_->options.timeout_s / 4) line_->send(progress);
}

void Channel::receive(wire::Motion& into) {
  into.release();
  line_->receive(wire::Kind::motion, into, line_->options.timeout_s, line_->moment());
  if (into.displacement.size() != line_->blocks) {
    line_->refuse(fmt::format("{} sent positions of {} blocks in window {}, the handshake was on {}",
                              line_->options.partner, into.displacement.size(), into.window, line_->blocks));
  }
  line_->window = into.window;
}

void Channel::receive(wire::Load& into) {
  into.release();
  line_->receive(wire::Kind::load, into, line_->options.timeout_s, line_->moment());
  line_->window = into.window;
}

double Channel::waited_s() const {
  return line_->waited_s;
}
double Channel::packed_s() const {
  return line_->packed_s;
}
double Channel::wire_s() const {
  return line_->wire_s;
}

}  // namespace blockweir::channel
