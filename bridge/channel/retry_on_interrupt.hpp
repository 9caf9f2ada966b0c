// SPDX-License-Identifier: GPL-3.0-or-later
// A signal may end any call of ZeroMQ before it has begun; what was asked for is then asked again.
#pragma once

#include <cerrno>
#include <zmq.hpp>

namespace blockweir::channel {

template <class Call>
auto retry_on_interrupt(Call call) {
  for (;;) {
    try {
      return call();
    } catch (const zmq::error_t& error) {
      if (error.num() != EINTR) throw;
    }
  }
}

}  // namespace blockweir::channel
