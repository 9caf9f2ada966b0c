// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/channel/connection_monitor.hpp"
#include "bridge/channel/retry_on_interrupt.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <cstdio>
#include <cstring>

namespace blockweir::channel {
namespace {

constexpr int most_lines = 10;  // a knock a millisecond shall not fill the disk

/// Where a connection comes from, for people.
std::string address_of(int descriptor) {
  sockaddr_storage peer = {};
  socklen_t size = sizeof peer;
  std::array<char, INET6_ADDRSTRLEN> text = {};
  if (::getpeername(descriptor, reinterpret_cast<sockaddr*>(&peer), &size) == 0) {
    if (peer.ss_family == AF_INET) {
      const auto& v4 = reinterpret_cast<const sockaddr_in&>(peer);
      return fmt::format("{}:{}", ::inet_ntop(AF_INET, &v4.sin_addr, text.data(), text.size()), ntohs(v4.sin_port));
    }
    if (peer.ss_family == AF_INET6) {
      const auto& v6 = reinterpret_cast<const sockaddr_in6&>(peer);
      return fmt::format("[{}]:{}", ::inet_ntop(AF_INET6, &v6.sin6_addr, text.data(), text.size()),
                         ntohs(v6.sin6_port));
    }
  }
  return "an address that it had left already";
}

}  // namespace

ConnectionMonitor::ConnectionMonitor(zmq::context_t& context, zmq::socket_t& socket, std::string endpoint, bool logs)
    : socket_(socket), events_(context, zmq::socket_type::pair), endpoint_(std::move(endpoint)), logs_(logs) {
  const std::string name = fmt::format("inproc://monitor-{}", static_cast<const void*>(this));
  constexpr int of_interest = ZMQ_EVENT_ACCEPTED | ZMQ_EVENT_CONNECTED | ZMQ_EVENT_DISCONNECTED |
                              ZMQ_EVENT_HANDSHAKE_SUCCEEDED | ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL |
                              ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL | ZMQ_EVENT_HANDSHAKE_FAILED_AUTH;
  retry_on_interrupt([&] {
    if (zmq_socket_monitor(socket.handle(), name.c_str(), of_interest) != 0) throw zmq::error_t();
  });
  retry_on_interrupt([&] { events_.connect(name); });
}

ConnectionMonitor::~ConnectionMonitor() {
  zmq_socket_monitor(socket_.handle(), nullptr, 0);
}

void ConnectionMonitor::update() {
  zmq::message_t event;
  const auto receive = [&] {
    return retry_on_interrupt([&] { return events_.recv(event, zmq::recv_flags::dontwait); });
  };
  while (receive()) {
    std::uint16_t number = 0;
    std::int32_t value = 0;
    std::memcpy(&number, event.data(), sizeof number);
    std::memcpy(&value, static_cast<const char*>(event.data()) + sizeof number, sizeof value);
    note(number, value);
    (void)receive();  // the endpoint, which we know
  }
}

void ConnectionMonitor::note(std::uint16_t event, std::int32_t value) {
  switch (event) {
    case ZMQ_EVENT_ACCEPTED:
    case ZMQ_EVENT_CONNECTED:
      connections_[value] = logs_ ? address_of(value) : std::string();
      break;
    case ZMQ_EVENT_DISCONNECTED:
      gone(value);
      break;
    case ZMQ_EVENT_HANDSHAKE_SUCCEEDED:
      joined_ = true;
      break;
    case ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL:
      refusal_ = "it left in the middle of the handshake";
      break;
    case ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL:
      refusal_ =
          "its keys are not those expected, or it has none although they are required, or it is not a blockweir "
          "program";
      final_refusal_ = true;
      break;
    case ZMQ_EVENT_HANDSHAKE_FAILED_AUTH:
      refusal_ = "its key is not the partner's";
      final_refusal_ = true;
      break;
    default:
      break;
  }
}

/// ZeroMQ says that a handshake has failed, then whose connection has gone.
void ConnectionMonitor::gone(int descriptor) {
  const auto visitor = connections_.find(descriptor);
  if (visitor == connections_.end()) return;
  const std::string address = visitor->second;
  connections_.erase(visitor);
  if (joined_ && (descriptor == partner_ || (partner_ < 0 && connections_.empty()))) {
    left_ = true;
  } else if (logs_) {
    log(address);
  }
}

void ConnectionMonitor::log(const std::string& address) {
  if (++strangers_ > most_lines) return;
  const std::string line = fmt::format("blockweir: refused a client from {} at {}: {}{}\n", address, endpoint_,
                                       refusal_.empty() ? "it does not follow blockweir's protocol" : refusal_,
                                       strangers_ == most_lines ? "; further ones are not logged" : "");
  std::fputs(line.c_str(), stderr);
  refusal_.clear();
}

void ConnectionMonitor::identify_partner(int descriptor) {
  if (partner_ >= 0) return;
  partner_ = descriptor;
  left_ = connections_.count(descriptor) == 0;
}

}  // namespace blockweir::channel
