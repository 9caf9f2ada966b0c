// SPDX-License-Identifier: GPL-3.0-or-later
// A solid and a reservoir that answers, in one process, on the scene's schedule.
#pragma once

#include <vector>

#include "bridge/schedule/run.hpp"
#include "bridge/schedule/velocities.hpp"
#include "fluid/reservoir/reservoir_model.hpp"
#include "solid/watch/added_mass_watch.hpp"
#include "solid/watch/capture.hpp"
#include "solid/watch/told_motion.hpp"

namespace blockweir::solid {

/// The solid, without what a run watches and writes.
class Blocks : public schedule::SolidSide {
 public:
  explicit Blocks(const scene::Scene& scene) : solid(scene), water_(static_cast<int>(scene.coupling.load_in_window)) {}

  void place(wire::Motion& motion) override { predict(0, motion); }
  void predict(double ahead_s, wire::Motion& motion) override { tell_motion(solid, ahead_s, motion); }
  void start(const wire::Load& load) override { take(load); }
  void advance(const wire::Load& load, const wire::Motion& told, double from_s, double to_s) override {
    if (load.window > 0) take(load);
    solid.advance(from_s, to_s, water_, {masses, schedule::velocities_in(told), told.time_s});
  }
  [[nodiscard]] bool finished() const override { return false; }

  Solid solid;
  AddedMasses masses;

 private:
  void take(const wire::Load& load) {
    water_.add(load.time_s, panels_of(load, solid));
    masses = watch_.look(load, solid);
  }
  WaterCourse water_;
  AddedMassWatch watch_;
};

/// The reservoir.
class Water final : public schedule::FluidLine {
 public:
  explicit Water(const scene::Scene& scene) : model_(scene) {}
  void tell(const wire::Motion& motion) override {
    load_.window = motion.window;
    load_.time_s = motion.time_s;
    model_.advance(motion, motion.time_s, load_);
  }
  void hear(wire::Load& load) override { load = load_; }
  [[nodiscard]] std::string name() const override { return "reservoir"; }

 private:
  reservoir::ReservoirModel model_;
  wire::Load load_;
};

inline void run_with_reservoir(const scene::Scene& scene, Blocks& blocks) {
  Water water(scene);
  checkpoint::Checkpoints none("", "solid", "", 0);
  schedule::run_solid(&water, scene, none, 0, blocks);
}

}  // namespace blockweir::solid
