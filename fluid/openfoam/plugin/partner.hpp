// SPDX-License-Identifier: GPL-3.0-or-later
// The solid process as all ranks of interFoam see it: the master talks to it, the others hear what was said.
#pragma once

#include <memory>
#include <optional>

#include "bridge/channel/channel.hpp"
#include "fluid/openfoam/plugin/interface.hpp"

namespace blockweir::openfoam {

/// What goes wrong ends all ranks with one line, through OpenFOAM's FatalError.
class Partner {
 public:
  explicit Partner(const Interface& interface);
  ~Partner();
  Partner(const Partner&) = delete;
  Partner& operator=(const Partner&) = delete;

  /// Motion of window `window`, on all ranks; nothing when the solid has ended the run.
  std::optional<wire::Motion> receive(std::uint64_t window);

  /// The master's load is sent.
  void send(const wire::Load& load);

  /// The master says how far the window's steps have come, where the solid would else wait for long.
  void come_further(const std::string& text) {
    if (channel_) channel_->send(wire::Progress{text});
  }

  /// Ends the run on all ranks; the solid is told why.
  [[noreturn]] void fail(const std::string& text);

  /// Seconds of the master so far: waiting, packing and unpacking, handing frames over.
  [[nodiscard]] double waited_s() const { return channel_ ? channel_->waited_s() : 0; }
  [[nodiscard]] double packed_s() const { return channel_ ? channel_->packed_s() : 0; }
  [[nodiscard]] double wire_s() const { return channel_ ? channel_->wire_s() : 0; }

 private:
  template <class Action>
  void on_master(Action action);

  std::unique_ptr<channel::Channel> channel_;  ///< the master's; none elsewhere
};

}  // namespace blockweir::openfoam
