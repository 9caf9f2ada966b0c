// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of frames to be sent. ZeroMQ sends each frame from here, in its own thread; afterwards the memory is reused,
// so that the operating system provides its pages only once a run.
#pragma once

#include <flatbuffers/flatbuffers.h>

#include <atomic>
#include <list>
#include <utility>
#include <zmq.hpp>

#include "bridge/wire/codec.hpp"

namespace blockweir::channel {

/// ZeroMQ releases the memory once the frame is sent.
inline zmq::message_t sent_from(wire::Part& part) {
  const auto let_go = [](void*, void* keeper) { delete static_cast<wire::Keeper*>(keeper); };
  return {const_cast<void*>(part.data), part.size, let_go, new wire::Keeper(std::move(part.keeper))};
}

/// Must outlive the context that sends its frames.
class Outgoing {
 public:
  /// The frame built by `pack(builder)`.
  template <class Pack>
  zmq::message_t frame(Pack pack) {
    Buffer& buffer = idle();
    pack(buffer.builder);
    buffer.sending = true;
    const auto sent = [](void*, void* which) { static_cast<Buffer*>(which)->sending = false; };
    return {buffer.builder.GetBufferPointer(), buffer.builder.GetSize(), sent, &buffer};
  }

 private:
  struct Buffer {
    flatbuffers::FlatBufferBuilder builder;
    std::atomic<bool> sending = false;
  };

  Buffer& idle() {
    for (Buffer& buffer : buffers_) {
      if (!buffer.sending) return buffer;
    }
    return buffers_.emplace_back();
  }

  std::list<Buffer> buffers_;  ///< two if messages alternate
};

}  // namespace blockweir::channel
