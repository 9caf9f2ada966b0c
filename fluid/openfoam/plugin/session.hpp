// SPDX-License-Identifier: GPL-3.0-or-later
// The coupling of one run: windows, their time steps, and the exchange at the end of each.
#pragma once

#include <regIOobject.H>

#include <chrono>
#include <memory>

#include "bridge/checkpoint/checkpoints.hpp"
#include "fluid/openfoam/plugin/added_mass.hpp"
#include "fluid/openfoam/plugin/breach.hpp"
#include "fluid/openfoam/plugin/edge_pressures.hpp"
#include "fluid/openfoam/plugin/open_end.hpp"
#include "fluid/openfoam/plugin/partner.hpp"
#include "fluid/openfoam/plugin/water_at_rest.hpp"
#include "fluid/openfoam/plugin/water_levels.hpp"
#include "fluid/openfoam/plugin/water_record.hpp"

namespace blockweir::openfoam {

/// Positions and velocities of all blocks at both ends of a window.
struct Course {
  std::vector<Pose> start;
  std::vector<Pose> start_velocity;
  std::vector<Pose> end;
  std::vector<Pose> end_velocity;
  double duration_s = 0;
};

/// The fluid's side in every schedule: it receives a motion and its time, interFoam steps there, and it sends the
/// pressures.
class Session : public Foam::regIOobject {
 public:
  TypeName("blockweirSession")

      /// Connects, sends the first pressures or resumes from a checkpoint, and receives the positions of the blocks at
      /// the end of the next window. Errors end the run.
      explicit Session(const Foam::fvMesh& mesh);
  ~Session() override;

  /// The mesh's session; null if there is none.
  static Session* of(const Foam::fvMesh& mesh);

  /// Called whenever the momentum equation is assembled; the first call in a step moves the blocks to its end.
  void begin_step();
  /// A time step is complete: continues the window, or exchanges data at its end.
  void end_step();
  /// The function object that calls end_step() exists.
  void attach() { attached_ = true; }

  [[nodiscard]] const ImmersedBlocks& blocks() const { return blocks_; }
  [[nodiscard]] double water_density() const { return water_.water_density(); }
  /// Acceleration of the ground, and with it of the mesh [m/s2], at the end of the step.
  [[nodiscard]] Foam::vector ground_acceleration() const;

  bool writeData(Foam::Ostream&) const override { return true; }

 private:
  void check_agreement();
  void place_blocks();
  void exchange();
  void sample();
  void say();
  void resume();
  std::optional<wire::Motion> await_motion();
  void save();
  void pass(const wire::Motion& motion);
  void start_window(const wire::Motion& motion);
  void write_report() const;
  [[nodiscard]] double crossings_per_s() const;

  const Foam::fvMesh& mesh_;
  Foam::Time& time_;
  Foam::IOdictionary dict_;
  Interface interface_;
  Partner partner_;
  checkpoint::Checkpoints checkpoints_;
  ImmersedBlocks blocks_;
  WaterState water_;
  WaterLevels levels_;
  std::vector<OpenEnd> open_ends_;
  EdgePressures edges_;
  std::unique_ptr<JointFlow> flow_;  ///< null: no water flows through joints
  AddedMass added_mass_;
  Breach breach_;
  WaterAtRest rest_;
  WaterRecord record_;
  Foam::autoPtr<Foam::Function1<Foam::scalar>> ground_x_;
  Foam::autoPtr<Foam::Function1<Foam::scalar>> ground_y_;

  std::uint64_t window_ = 0;  ///< number of the motion received last
  double time_s_ = 0;         ///< its time
  int step_ = 0;              ///< steps made towards it
  int steps_ = 1;             ///< steps to be made
  Course course_;
  std::vector<Pose> step_start_;
  std::vector<Pose> step_end_;
  Foam::label placed_at_ = -1;  ///< time index of the step to which the blocks were moved
  bool attached_ = false;
  wire::Load load_;
  double mapping_s_ = 0;  ///< blocks to cells, pressures to edges
  double output_s_ = 0;
  double steps_s_ = 0;                           ///< interFoam's own time in the windows' steps
  std::chrono::steady_clock::time_point begun_;  ///< of the window
  double mapped_before_s_ = 0;
  long windows_ = 0;  ///< in which interFoam has made steps
  long passed_ = 0;   ///< those without steps, since nothing happened
};

}  // namespace blockweir::openfoam
