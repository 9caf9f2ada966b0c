// SPDX-License-Identifier: GPL-3.0-or-later
// Repeats a call of ZeroMQ that a signal has interrupted.
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
