// SPDX-License-Identifier: GPL-3.0-or-later
// All that a step changes.
#pragma once

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

/// How blocks move and where they are, and what holds them: a copy is the undo of steps that were only looked at.
struct Standing {
  std::vector<BlockState> blocks;     ///< the scene's, then the triangles of meshes
  std::vector<Placement> placements;  ///< of them
  std::vector<ContactPoint> contacts;
  std::vector<Support> supports;
  std::vector<Bolt> bolts;
};

/// Its serialization is the checkpoint.
struct State : Standing {
  /// Of Shi's scheme, after a step in which contacts have changed: its acceleration is that of the forces that act,
  /// which a rule of second order goes on from.
  static constexpr int smooth_steps_before_restart = 1;

  /// The scene as it is drawn, blocks that touch joined by bonds.
  explicit State(Model& model);

  bool contacts_stand = false;  ///< nothing has moved since they were searched
  double next_dt = 0;           ///< step that the last window ended with [s]
  bool started = false;
  double time_s = 0;                    ///< of blocks
  Rest rest;                            ///< of a static analysis
  std::vector<Vector6> held_by_ground;  ///< what has held each part at rest on a viscous boundary; none without one
  Sleep sleep;
  AddedMassGuard guard;
  WaterWork water_work;
  EnergyBalance energy;
  int smooth_steps = 0;  ///< since the last in which contacts changed, where the integrator is of second order
  ContactSearch search;
  Backoff whole_law;    ///< of Coulomb, by Newton's method: fails where friction has to lag or contacts to be swept
  Backoff finish;       ///< by Newton's method, of what sweeps have found
  Backoff multipliers;  ///< of Lagrange, in motion: fail where the substitute makes the step
  Backoff lagging;      ///< friction, where sweeps end far from their laws

  void stand_as(const Standing& before);
  /// Nothing has a velocity, nor an acceleration.
  void stop();
  [[nodiscard]] long touching_contacts() const;
  /// Where the vertex of a contact is now [m].
  [[nodiscard]] Point place(const ContactPoint& c) const {
    return placements[static_cast<std::size_t>(c.vertex_part)].position(c.vertex_at);
  }
  /// Largest displacement of any vertex since the scene's outline, against the base [m].
  [[nodiscard]] double largest_displacement_m(const Model& model) const;
  /// Longest way that a contact has slipped [m].
  [[nodiscard]] double largest_slip_m() const;
  /// Of any block's centre [m/s].
  [[nodiscard]] double fastest_m_per_s() const;
  /// After blocks have been read from a checkpoint.
  void place_blocks(const Model& model);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(blocks, contacts, contacts_stand, next_dt, started, time_s, rest, sleep, guard, water_work, energy,
            smooth_steps, search, whole_law, finish, multipliers, lagging, held_by_ground);
    for (Support& support : supports) archive(support);
    for (Bolt& bolt : bolts) archive(bolt);
  }

 private:
  double take_out_rounding(const Model& model);
  void bond_touching_contacts(const JointLaws& laws);
};

}  // namespace blockweir::solid
