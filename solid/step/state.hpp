// SPDX-License-Identifier: GPL-3.0-or-later
// The state: everything that a step changes.
#pragma once

#include <optional>
#include <stdexcept>
#include <vector>

#include "solid/block/motion.hpp"
#include "solid/contact/bolt.hpp"
#include "solid/contact/contact_point.hpp"
#include "solid/contact/search.hpp"
#include "solid/contact/support.hpp"
#include "solid/solve/backoff.hpp"
#include "solid/step/added_mass_guard.hpp"
#include "solid/step/counts.hpp"
#include "solid/step/energy_balance.hpp"
#include "solid/step/model.hpp"
#include "solid/step/sleep.hpp"
#include "solid/step/water_work.hpp"

namespace blockweir::solid {

/// Positions and velocities of blocks, and their contacts; a copy of it undoes trial steps.
struct Standing {
  std::vector<BlockState> blocks;     ///< the scene's blocks, then the triangles of meshes
  std::vector<Placement> placements;  ///< of them
  std::vector<ContactPoint> contacts;
  std::vector<Support> supports;
  std::vector<Bolt> bolts;
};

/// The whole state; its serialization is the checkpoint.
struct State : Standing {
  /// Steps of Shi's scheme after one in which contacts changed, until its acceleration is that of the acting forces,
  /// from which a second-order scheme can continue.
  static constexpr int smooth_steps_before_restart = 1;

  /// The scene as drawn, with bonds between touching blocks.
  explicit State(Model& model);

  bool contacts_stand = false;  ///< nothing has moved since the last contact search
  /// Of a search that is ahead of its step: how many contacts touched before it.
  std::optional<long> touched_before;
  double next_dt = 0;  ///< length of the last step of the last window [s]
  bool started = false;
  double time_s = 0;                    ///< of the blocks
  Rest rest;                            ///< of a static analysis
  std::vector<Vector6> held_by_ground;  ///< holding force of each part on a viscous boundary; empty without one
  Sleep sleep;
  AddedMassGuard guard;
  WaterWork water_work;
  EnergyBalance energy;
  bool has_fallen = false;  ///< a block has been faster than a fall through its step
  int smooth_steps = 0;     ///< second-order schemes: steps since the last change of contacts
  ContactSearch search;
  Backoff whole_law;  ///< Newton's method with the full Coulomb law; fails if friction must lag or sweeps are needed
  Backoff finish;     ///< Newton's method started from the result of sweeps
  Backoff moving_forces;  ///< of slow motion, found for all contacts at once
  Backoff multipliers;    ///< Lagrange multipliers in motion; fail if the substitute makes the step
  Backoff lagging;        ///< lagged friction, used if sweeps end far from the contact laws

  void restore(const Standing& before);
  /// Sets all velocities and accelerations to zero.
  void stop();
  [[nodiscard]] long touching_contacts() const;
  /// Present position of a contact's vertex [m].
  [[nodiscard]] Point place(const ContactPoint& c) const {
    return placements[static_cast<std::size_t>(c.vertex_part)].position(c.vertex_at);
  }
  /// Largest displacement of any vertex from the scene as drawn, relative to the base [m].
  [[nodiscard]] double largest_displacement_m(const Model& model) const;
  /// Largest slip of a contact [m].
  [[nodiscard]] double largest_slip_m() const;
  /// Largest speed of a centroid [m/s].
  [[nodiscard]] double fastest_m_per_s() const;
  /// Call after blocks have been read from a checkpoint.
  void place_blocks(const Model& model);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(blocks, contacts, contacts_stand, touched_before, next_dt, started, time_s, rest, sleep, guard, water_work,
            energy, smooth_steps, search, whole_law, finish, moving_forces, multipliers, lagging, held_by_ground,
            has_fallen);
    for (Support& support : supports) archive(support);
    for (Bolt& bolt : bolts) archive(bolt);
  }

 private:
  double take_out_rounding(const Model& model);
  void bond_touching_contacts(const JointLaws& laws);
};

}  // namespace blockweir::solid
