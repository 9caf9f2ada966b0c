// SPDX-License-Identifier: GPL-3.0-or-later
// The solid process as seen by all ranks of interFoam: the master communicates with it and broadcasts its messages.
#pragma once

#include <memory>
#include <optional>

#include "bridge/channel/channel.hpp"
#include "fluid/openfoam/plugin/interface.hpp"

namespace blockweir::openfoam {

/// Errors end all ranks with one line, through OpenFOAM's FatalError.
class Partner {
 public:
  explicit Partner(const Interface& interface);
  ~Partner();
  Partner(const Partner&) = delete;
  Partner& operator=(const Partner&) = delete;

  /// Motion of window `window`, on all ranks; none if the solid has ended the run.
  std::optional<wire::Motion> receive(std::uint64_t window);

  /// Sends the master's load.
  void send(const wire::Load& load);

  /// The master reports the progress of a long window, so that the solid does not time out.
  void come_further(const std::string& text) {
    if (channel_) channel_->send(wire::Progress{text});
  }

  /// Ends the run on all ranks and tells the solid the reason.
  [[noreturn]] void fail(const std::string& text);

  /// The master's seconds so far: waiting, packing and unpacking, passing frames to ZeroMQ.
  [[nodiscard]] double waited_s() const { return channel_ ? channel_->waited_s() : 0; }
  [[nodiscard]] double packed_s() const { return channel_ ? channel_->packed_s() : 0; }
  [[nodiscard]] double wire_s() const { return channel_ ? channel_->wire_s() : 0; }

 private:
  template <class Action>
  void on_master(Action action);

  std::unique_ptr<channel::Channel> channel_;  ///< on the master; null elsewhere
};

}  // namespace blockweir::openfoam
