// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of frames on their way out. ZeroMQ sends from where a frame was packed, in a thread of its own; when it has
// done so the memory serves the next one. What a fresh page costs at first touch is thus paid once a run.
#pragma once

#include <flatbuffers/flatbuffers.h>

#include <atomic>
#include <list>
#include <utility>
#include <zmq.hpp>

#include "bridge/wire/codec.hpp"

namespace blockweir::channel {

/// ZeroMQ lets go of the memory when it has sent it.
inline zmq::message_t sent_from(wire::Part& part) {
  const auto let_go = [](void*, void* keeper) { delete static_cast<wire::Keeper*>(keeper); };
  return {const_cast<void*>(part.data), part.size, let_go, new wire::Keeper(std::move(part.keeper))};
}

/// Must outlive the context that sends its frames.
class Outgoing {
 public:
  /// The frame that `pack(builder)` makes.
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

  std::list<Buffer> buffers_;  ///< two, where messages go to and fro
};

}  // namespace blockweir::channel
