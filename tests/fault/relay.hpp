// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in the line between solid and fluid and does to one frame what a bad line or a bad partner would. The parts of
// a message count as frames.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>
#include <zmq.hpp>

namespace blockweir::test {

using Frame = std::vector<std::uint8_t>;

class Relay {
 public:
  enum class From { solid, fluid };
  /// What is sent on for the frame `number` (0: Hello) of a side, given all that the side has sent so far.
  using Tamper = std::function<std::vector<Frame>(From, std::size_t number, const std::vector<Frame>& sent)>;

  /// Listens at `to_fluid` and connects to the solid's own endpoint.
  Relay(const std::string& to_solid, const std::string& to_fluid, Tamper tamper)
      : solid_(context_, zmq::socket_type::pair), fluid_(context_, zmq::socket_type::pair), tamper_(std::move(tamper)) {
    for (zmq::socket_t* socket : {&solid_, &fluid_}) socket->set(zmq::sockopt::linger, 200);
    fluid_.bind(to_fluid);
    solid_.connect(to_solid);
    thread_ = std::thread([this] { run(); });
  }
  ~Relay() {
    stop_ = true;
    thread_.join();
  }
  Relay(const Relay&) = delete;
  Relay& operator=(const Relay&) = delete;

 private:
  void run() {
    while (!stop_) {
      zmq::pollitem_t items[] = {{solid_.handle(), 0, ZMQ_POLLIN, 0}, {fluid_.handle(), 0, ZMQ_POLLIN, 0}};
      zmq_poll(items, 2, 20);
      pass(From::solid, solid_, fluid_, solid_sent_);
      pass(From::fluid, fluid_, solid_, fluid_sent_);
    }
    solid_.close();
    fluid_.close();
  }
  void pass(From from, zmq::socket_t& source, zmq::socket_t& target, std::vector<Frame>& sent) {
    for (zmq::message_t message; source.recv(message, zmq::recv_flags::dontwait);) {
      const auto* bytes = static_cast<const std::uint8_t*>(message.data());
      sent.emplace_back(bytes, bytes + message.size());
      for (const Frame& frame : tamper_(from, sent.size() - 1, sent)) {
        // The solid may have said its hello before the fluid has come.
        const auto more = message.more() ? zmq::send_flags::sndmore : zmq::send_flags::none;
        while (!stop_ && !target.send(zmq::buffer(frame), more | zmq::send_flags::dontwait)) {
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
      }
    }
  }

  zmq::context_t context_;
  zmq::socket_t solid_;
  zmq::socket_t fluid_;
  Tamper tamper_;
  std::vector<Frame> solid_sent_;
  std::vector<Frame> fluid_sent_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

}  // namespace blockweir::test
