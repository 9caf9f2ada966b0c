// SPDX-License-Identifier: GPL-3.0-or-later
// One body of water as it answers accelerations: its mesh, its equation and what it remembers.
#pragma once

#include <memory>

#include "bridge/wire/message.hpp"
#include "fluid/reservoir/added_mass.hpp"
#include "fluid/reservoir/window_ahead.hpp"

namespace blockweir::reservoir {

class AnsweringWater {
 public:
  /// Beside faces that move by `moves`; `fixed` blocks are ground. Windows of `window_s`.
  AnsweringWater(WaterMesh mesh, const WaterPhysics& physics, const process::FaceMotion& moves,
                 const std::vector<bool>& fixed, double window_s);

  [[nodiscard]] const WaterAnswer& answer() const { return answer_; }
  [[nodiscard]] const WaterMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const PressureState& state() const { return state_; }
  [[nodiscard]] bool at_rest() const;
  /// Onto `mesh`, that of before with its nodes moved. What the water remembers stays at the nodes.
  void move_to(WaterMesh mesh, const process::FaceMotion& moves, double window_s);
  void go_on_from(PressureState state) { state_ = std::move(state); }
  /// Where its mesh was made anew: what waves had lifted is still lifted.
  void keep(const LiftedWater& lifted) { equation_->keep(lifted, state_); }
  [[nodiscard]] LiftedWater lifted() const { return equation_->lifted(state_); }
  /// One window with `accelerations`, one a mode of the answer. `kept`: the water is that of the window before.
  void advance(const Eigen::VectorXd& accelerations, bool kept);
  /// Turns the pressures into the load of the coming window (WindowAhead), with the accelerations a_n, and those of the
  /// ground that are known of the window.
  void look_ahead(const Eigen::VectorXd& accelerations, const Eigen::VectorXd& of_ground, const WindowAhead& weights,
                  bool kept);
  void add_panels(wire::Load& load) const;
  /// Beyond that of still water, at the mesh's nodes, at the end of the window before [Pa].
  [[nodiscard]] Eigen::VectorXd pressure_at_nodes() const;

 private:
  [[nodiscard]] Eigen::VectorXd response(const Eigen::VectorXd& accelerations, bool kept);

  std::unique_ptr<WaterMesh> mesh_;  ///< the equation refers to it
  std::unique_ptr<PressureEquation> equation_;
  WaterAnswer answer_;
  Eigen::MatrixXd responses_;  ///< WaterAnswer::pressures, where water was kept
  bool remembers_;
  PressureState state_;            ///< of water that remembers
  Eigen::VectorXd pressure_;       ///< on the answer's panels
  Eigen::VectorXd accelerations_;  ///< of the window before
};

}  // namespace blockweir::reservoir
