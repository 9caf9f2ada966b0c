// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/schedule/exchange.hpp"

#include <limits>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/schedule/turn.hpp"

namespace blockweir::schedule {

Exchange::Exchange(FluidLine* fluid, checkpoint::Checkpoints& checkpoints, Windows& windows, SolidSide& solid,
                   bool skips)
    : fluid_(fluid), checkpoints_(checkpoints), windows_(windows), solid_(solid), skips_(skips) {
  load_.upstream_level_m = load_.downstream_level_m = std::numeric_limits<double>::quiet_NaN();
}

void Exchange::save() {
  if (number_ == 0) return;  // the start is no place to go on from
  checkpoints_.write(number_, checkpoint::pack(windows_, load_, answered_, skipped_, solid_.state()));
}

void Exchange::save_without_fluid() {
  try {
    solid_.record();
    save();
  } catch (const std::exception&) {
    // The fluid's trouble is what the user is to read.
  }
}

void Exchange::resume(std::uint64_t number) {
  std::string state;
  checkpoint::unpack(checkpoints_.read(number), windows_, load_, answered_, skipped_, state);
  solid_.restore(state);
  number_ = number;
}

bool Exchange::answer_holds(const wire::Motion& motion, double time_s) const {
  return skips_ && number_ > 0 && time_s < load_.holds_until_s && motion.displacement == answered_.displacement &&
         motion.velocity == answered_.velocity && motion.face_velocity == answered_.face_velocity;
}

void Exchange::send(wire::Motion& motion, double time_s) {
  const bool stop = channel::stop_requested();
  silent_ = !stop && !checkpoints_.due() && answer_holds(motion, time_s);
  if (silent_) {
    ++skipped_;
    motion.window = number_ - 1;
    motion.time_s = time_s;
    sent_ = motion;
    solid_.record();
    return;
  }
  motion.window = number_;
  motion.time_s = time_s;
  motion.order = stop ? wire::Order::save : checkpoints_.due() ? wire::Order::save_and_compute : wire::Order::compute;
  try {
    if (fluid_ != nullptr) fluid_->send(motion);
  } catch (const channel::PeerError&) {
    save_without_fluid();
    throw;
  }
  solid_.record();
  if (motion.order != wire::Order::compute) save();
  if (stop) throw channel::Interrupted("asked to stop");
  ++number_;
  sent_ = motion;
}

void Exchange::receive() {
  if (fluid_ == nullptr) {
    answered_.window = sent_.window;
    return;
  }
  if (silent_) {
    load_.time_s = sent_.time_s;
    std::swap(answered_, sent_);
    return;
  }
  fluid_->receive(incoming_);
  require_turn(incoming_.window, number_ - 1, fluid_->name());
  std::swap(load_, incoming_);
  std::swap(answered_, sent_);
}

void Exchange::send_and_receive(wire::Motion& motion, double time_s) {
  send(motion, time_s);
  if (fluid_ != nullptr && !silent_) solid_.prepare();
  try {
    receive();
  } catch (const channel::PeerError&) {
    --number_;
    save_without_fluid();
    throw;
  }
}

}  // namespace blockweir::schedule
