// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/partner.hpp"

#include <Pstream.H>
#include <error.H>
#include <fmt/format.h>

namespace blockweir::openfoam {

/// Runs `action` on the master; what it throws ends all ranks.
template <class Action>
void Partner::on_master(Action action) {
  Foam::string trouble;
  if (Foam::Pstream::master()) {
    try {
      action();
    } catch (const std::exception& error) {
      trouble = error.what();
    }
  }
  Foam::Pstream::scatter(trouble);
  if (!trouble.empty()) FatalErrorInFunction << trouble.c_str() << Foam::exit(Foam::FatalError);
}

Partner::Partner(const Interface& interface) {
  on_master([&] {
    channel::catch_stop_signals();
    channel::Options options;
    options.side = channel::Side::connects;
    options.endpoint = interface.endpoint;
    options.keys = interface.keys;
    options.insecure = interface.insecure;
    options.partner = "solid process";
    options.timeout_s = interface.timeout_s;
    options.open_timeout_s = interface.open_timeout_s;
    channel_ = std::make_unique<channel::Channel>(options);
    channel_->handshake(interface.hello);
  });
}

Partner::~Partner() = default;

std::optional<wire::Motion> Partner::receive(std::uint64_t window) {
  wire::Motion motion;
  bool ended = false;
  on_master([&] {
    try {
      channel_->receive(motion);
    } catch (const channel::PeerEnded&) {
      ended = true;
      return;
    }
    if (motion.window != window) {
      throw std::runtime_error(fmt::format(
          "the solid process sent window {} where window {} was due; start both sides anew", motion.window, window));
    }
  });
  Foam::Pstream::scatter(ended);
  if (ended) return std::nullopt;
  auto order = static_cast<Foam::label>(motion.order);
  Foam::Pstream::scatter(order);
  Foam::Pstream::scatter(motion.time_s);
  motion.order = static_cast<wire::Order>(order);

  Foam::List<Foam::scalar> flat;
  for (std::size_t b = 0; b < motion.displacement.size(); ++b) {
    for (const double d : motion.displacement[b]) flat.append(d);
    for (const double v : motion.velocity[b]) flat.append(v);
  }
  Foam::Pstream::scatter(flat);
  if (!Foam::Pstream::master()) {
    motion.window = window;
    const auto blocks = static_cast<std::size_t>(flat.size() / 12);
    auto& displacement = motion.displacement.own();
    auto& velocity = motion.velocity.own();
    displacement.resize(blocks);
    velocity.resize(blocks);
    for (std::size_t b = 0; b < blocks; ++b) {
      for (std::size_t k = 0; k < 6; ++k) {
        displacement[b][k] = flat[static_cast<Foam::label>(12 * b + k)];
        velocity[b][k] = flat[static_cast<Foam::label>(12 * b + 6 + k)];
      }
    }
  }
  return motion;
}

void Partner::send(const wire::Load& load) {
  on_master([&] { channel_->send(load); });
}

void Partner::fail(const std::string& text) {
  on_master([&] {
    channel_->send(wire::Failure{text});
    channel_.reset();  // a line that closes waits until its last word has gone out; a process that ends does not
  });
  FatalErrorInFunction << text.c_str() << Foam::exit(Foam::FatalError);
  std::abort();
}

}  // namespace blockweir::openfoam
