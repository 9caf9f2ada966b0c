// SPDX-License-Identifier: GPL-3.0-or-later
// A solid and a reservoir that answers, in one process, on the scene's schedule.
#pragma once

#include <vector>

#include "bridge/schedule/run.hpp"
#include "fluid/reservoir/reservoir_model.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// The solid, without what a run watches and writes.
class Blocks final : public schedule::SolidSide {
 public:
  explicit Blocks(const scene::Scene& scene) : solid(scene), water_(static_cast<int>(scene.coupling.load_in_window)) {}

  void place(wire::Motion& motion) override { predict(0, motion); }
  void predict(double ahead_s, wire::Motion& motion) override {
    motion.displacement.own().resize(solid.described());
    motion.velocity.own().resize(solid.described());
    for (std::size_t b = 0; b < solid.described(); ++b) {
      const BlockState& s = solid.states()[b];
      Vector6::Map(motion.displacement.own()[b].data()) =
          s.displacement + ahead_s * s.velocity + ahead_s * ahead_s / 2 * s.acceleration;
      Vector6::Map(motion.velocity.own()[b].data()) = s.velocity + ahead_s * s.acceleration;
    }
  }
  void start(const wire::Load& load) override { take(load); }
  void advance(const wire::Load& load, const wire::Motion& told, double from_s, double to_s) override {
    if (load.window > 0) take(load);
    std::vector<Eigen::Vector3d> velocities;
    for (const auto& v : told.velocity) velocities.emplace_back(v[0], v[1], v[2]);
    solid.advance(from_s, to_s, water_, {masses, velocities, told.time_s});
  }
  [[nodiscard]] bool finished() const override { return false; }

  Solid solid;
  AddedMasses masses;

 private:
  void take(const wire::Load& load) {
    std::vector<Panel> panels;
    for (std::size_t i = 0; i < load.block.size(); ++i) {
      panels.push_back({static_cast<int>(load.block[i]), static_cast<int>(load.edge[i]), load.s_from[i], load.s_to[i],
                        load.pressure_from_pa[i], load.pressure_to_pa[i]});
    }
    water_.add(load.time_s, std::move(panels));
    masses = {};
    for (const auto& [xx, xy, xr, yy, yr, rr] : load.added_mass) {
      masses.own.push_back((Eigen::Matrix3d() << xx, xy, xr, xy, yy, yr, xr, yr, rr).finished());
    }
    for (std::size_t i = 0; i < load.coupled.size(); ++i) {
      const auto [a, b] = load.coupled[i];
      masses.pairs.push_back({static_cast<int>(a), static_cast<int>(b),
                              Eigen::Matrix<double, 3, 3, Eigen::RowMajor>::Map(load.added_mass_between[i].data())});
    }
  }
  WaterCourse water_;
};

/// The reservoir.
class Water final : public schedule::FluidLine {
 public:
  explicit Water(const scene::Scene& scene) : model_(scene) {}
  void send(const wire::Motion& motion) override {
    load_.window = motion.window;
    load_.time_s = motion.time_s;
    model_.advance(motion, motion.time_s, load_);
  }
  void receive(wire::Load& load) override { load = load_; }
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
