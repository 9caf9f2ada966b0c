// SPDX-License-Identifier: GPL-3.0-or-later
// The solid's connection to the fluid: over a channel, or by a call within the process.
#pragma once

#include <string>
#include <utility>

#include "bridge/channel/channel.hpp"
#include "bridge/schedule/fluid_turn.hpp"

namespace blockweir::schedule {

class FluidLine {
 public:
  virtual ~FluidLine() = default;
  /// Name for messages.
  [[nodiscard]] virtual std::string name() const = 0;
  virtual void send(const wire::Motion& motion) = 0;
  /// Receives the pressures for the motion sent last. Throws channel::PeerError if there are none.
  virtual void receive(wire::Load& load) = 0;
  virtual void end(const std::string& /*reason*/) {}
  virtual void fail(const std::string& /*text*/) {}
};

class RemoteFluid final : public FluidLine {
 public:
  RemoteFluid(channel::Channel& channel, std::string name) : channel_(channel), name_(std::move(name)) {}
  [[nodiscard]] std::string name() const override { return name_; }
  void send(const wire::Motion& motion) override { channel_.send(motion); }
  void receive(wire::Load& load) override { channel_.receive(load); }
  void end(const std::string& reason) override { channel_.send(wire::Farewell{reason}); }
  void fail(const std::string& text) override { channel_.send(wire::Failure{text}); }

 private:
  channel::Channel& channel_;
  std::string name_;
};

/// A fluid in the same process; it answers at once.
class LocalFluid final : public FluidLine {
 public:
  /// Adds the fluid's computing time to `seconds`.
  LocalFluid(FluidTurn& fluid, double& seconds) : fluid_(fluid), seconds_(seconds) {}
  [[nodiscard]] std::string name() const override { return "the fluid"; }
  void send(const wire::Motion& motion) override;
  void receive(wire::Load& load) override;

 private:
  FluidTurn& fluid_;
  double& seconds_;
  const wire::Load* answer_ = nullptr;
};

}  // namespace blockweir::schedule
