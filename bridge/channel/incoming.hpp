// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of received messages. Large columns are not copied: a message views them where ZeroMQ has stored
// them.
#pragma once

#include <cstring>
#include <memory>
#include <type_traits>
#include <vector>
#include <zmq.hpp>

#include "bridge/channel/retry_on_interrupt.hpp"
#include "bridge/results/wide_vectors.hpp"
#include "bridge/wire/codec.hpp"

namespace blockweir::channel {

class Incoming {
 public:
  explicit Incoming(zmq::socket_t& socket) : socket_(socket) {}

  /// Receives the next frame, if there is one.
  bool receive() {
    if (frame_.use_count() > 1) frame_ = std::make_shared<zmq::message_t>();  // the last frame is still viewed
    if (!retry_on_interrupt([&] { return socket_.recv(*frame_, zmq::recv_flags::dontwait); })) return false;
    free_upper_halves();  // another process has had this processor
    return true;
  }

  /// File descriptor of the connection that delivered it.
  [[nodiscard]] int source() { return zmq_msg_get(frame_->handle(), ZMQ_SRCFD); }

  /// The frame, aligned: ZeroMQ delivers small messages at any address in its own buffer.
  wire::Part frame() {
    constexpr std::size_t viewed_from = 1U << 16U;  // bytes; smaller frames are copied
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
      const std::shared_ptr<zmq::message_t> first = frame_;  // kept while its parts arrive
      wire::decode(frame, into, [&] { return next_part(); });
    }
    if (frame_->more()) throw wire::BadMessage("more parts than its header states");
  }

 private:
  [[nodiscard]] bool aligned() const { return reinterpret_cast<std::uintptr_t>(frame_->data()) % wire::alignment == 0; }

  /// A message arrives complete: no part has to be waited for.
  wire::Part next_part() {
    if (!frame_->more() || !receive()) return {};
    return {frame_->data(), frame_->size(), frame_};
  }

  zmq::socket_t& socket_;
  std::shared_ptr<zmq::message_t> frame_ = std::make_shared<zmq::message_t>();
  std::vector<std::uint64_t> realigned_;
};

}  // namespace blockweir::channel
