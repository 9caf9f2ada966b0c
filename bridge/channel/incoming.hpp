// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of messages on their way in. What is large is left where ZeroMQ has put it, for the columns of a message to
// view.
#pragma once

#include <cstring>
#include <memory>
#include <type_traits>
#include <vector>
#include <zmq.hpp>

#include "bridge/channel/retry_on_interrupt.hpp"
#include "bridge/wire/codec.hpp"

namespace blockweir::channel {

class Incoming {
 public:
  explicit Incoming(zmq::socket_t& socket) : socket_(socket) {}

  /// Takes the next frame if one is there.
  bool receive() {
    if (frame_.use_count() > 1) frame_ = std::make_shared<zmq::message_t>();  // somebody views what came last
    return retry_on_interrupt([&] { return socket_.recv(*frame_, zmq::recv_flags::dontwait); }).has_value();
  }

  /// File descriptor of the connection that brought it.
  [[nodiscard]] int source() { return zmq_msg_get(frame_->handle(), ZMQ_SRCFD); }

  /// The frame, aligned: ZeroMQ hands small messages out from wherever they stand in its own buffer.
  wire::Part frame() {
    constexpr std::size_t viewed_from = 1U << 16U;  // bytes; smaller frames are copied sooner than kept
    if (aligned()) return {frame_->data(), frame_->size(), frame_->size() >= viewed_from ? frame_ : nullptr};
    realigned_.resize(frame_->size() / sizeof realigned_.front() + 1);
    std::memcpy(realigned_.data(), frame_->data(), frame_->size());
    return {realigned_.data(), frame_->size()};
  }

  /// Decodes `frame`, which is frame(), and the parts that follow.
  template <class Message>
  void decode(const wire::Part& frame, Message& into) {
    if constexpr (std::is_same_v<Message, wire::Hello>) {
      wire::decode(frame, into);
    } else {
      const std::shared_ptr<zmq::message_t> first = frame_;  // stays while its parts come
      wire::decode(frame, into, [&] { return next_part(); });
    }
    if (frame_->more()) throw wire::BadMessage("more parts than it says");
  }

 private:
  [[nodiscard]] bool aligned() const { return reinterpret_cast<std::uintptr_t>(frame_->data()) % wire::alignment == 0; }

  /// A message arrives whole: its parts wait for nobody.
  wire::Part next_part() {
    if (!frame_->more() || !receive()) return {};
    return {frame_->data(), frame_->size(), frame_};
  }

  zmq::socket_t& socket_;
  std::shared_ptr<zmq::message_t> frame_ = std::make_shared<zmq::message_t>();
  std::vector<std::uint64_t> realigned_;
};

}  // namespace blockweir::channel
