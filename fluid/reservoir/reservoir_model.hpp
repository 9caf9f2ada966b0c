// SPDX-License-Identifier: GPL-3.0-or-later
// Water that answers accelerations: still water and cracks as the reference has them, and the pressure of linear water
// in both pools.
#pragma once

#include "bridge/schedule/sides.hpp"
#include "fluid/hydrostatic/hydrostatic_model.hpp"
#include "fluid/joints/flow_output.hpp"
#include "fluid/reservoir/answering_water.hpp"
#include "fluid/reservoir/face_motions.hpp"
#include "fluid/reservoir/guarded_mass.hpp"
#include "fluid/reservoir/mesh_motion.hpp"
#include "fluid/reservoir/reservoir_output.hpp"
#include "fluid/reservoir/shaking.hpp"

namespace blockweir::reservoir {

class ReservoirModel final : public schedule::FluidSide {
 public:
  /// Pictures of the water, where they are asked for, and what flows through joints go to `folder`, unless that is
  /// empty.
  explicit ReservoirModel(const scene::Scene& scene, const std::filesystem::path& folder = {});

  /// Pressures at to_s. Accelerations are the changes of the velocities told, over the time between or the last window,
  /// and those of the ground that the scene states.
  void advance(const wire::Motion& motion, double to_s, wire::Load& load) override;
  void record(double time_s) override;
  [[nodiscard]] std::string state() const override;
  void restore(const std::string& state) override;
  [[nodiscard]] schedule::FluidReport report() const override;

 private:
  /// Where blocks and levels were when the water was solved for.
  struct Geometry {
    wire::Motion motion;
    double time_s = 0;
    std::vector<std::vector<Point>> outlines;
    std::array<double, 2> levels_m{};
    double window_s = 0;
  };

  using Motions = std::vector<Eigen::Vector3d>;

  void take_accelerations(const wire::Motion& motion, const scene::TimeSpan& window);
  [[nodiscard]] Point ground_acceleration(const scene::TimeSpan& window) const;
  [[nodiscard]] bool outdated(double window_s) const;
  void solve(const hydrostatic::HydrostaticModel& water);
  bool move_meshes(const hydrostatic::HydrostaticModel& water, const FaceMotions& moves);
  void mesh_anew(const hydrostatic::HydrostaticModel& water, const FaceMotions& moves);
  void solve_again(Geometry then);
  [[nodiscard]] bool moves() const;
  /// One a mode: of motions and of the ground.
  [[nodiscard]] Eigen::VectorXd for_modes(const WaterAnswer& answer, const Motions& motions, const Point& ground) const;
  [[nodiscard]] double known_until_s(double told_s) const;
  void look_ahead(const Motions& before, double before_s, bool kept);

  const scene::Scene& scene_;
  const Shaking shaking_;
  hydrostatic::HydrostaticModel still_;
  wire::Load still_load_;
  std::optional<joints::FlowOutput> flow_;
  std::optional<ReservoirOutput> pictures_;  ///< where they are asked for
  std::optional<WindowAhead> ahead_;         ///< where the water answers ahead
  std::vector<bool> fixed_;
  Geometry meshed_;  ///< when the water was last meshed
  Geometry solved_;
  Point ground_m_ = Point::Zero();      ///< where the ground was then, from where it is drawn
  std::vector<AnsweringWater> waters_;  ///< one a body of water that is no film
  std::vector<MeshMotion> motions_;     ///< of their meshes
  double deepest_m_ = 0;                ///< of the bodies
  GuardedMass guarded_;                 ///< of the bodies
  Motions velocities_;                  ///< last told
  Motions accelerations_;               ///< of all motions, in the frame of the scene
  Point ground_ = Point::Zero();        ///< acceleration
  double time_s_ = 0;
  bool told_ = false;
  long solutions_ = 0;
  long meshes_ = 0;  ///< solutions on meshes made anew
  long kept_ = 0;    ///< windows that took the factors of one before
  double solve_s_ = 0;
  double mesh_s_ = 0;
};

}  // namespace blockweir::reservoir
