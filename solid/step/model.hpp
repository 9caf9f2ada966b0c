// SPDX-License-Identifier: GPL-3.0-or-later
// What stays as it is while a scene is run.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/block/base_motion.hpp"
#include "solid/block/loads.hpp"
#include "solid/block/parts.hpp"
#include "solid/block/viscous_boundary.hpp"
#include "solid/block/water_motions.hpp"
#include "solid/contact/contact_point.hpp"
#include "solid/contact/formulation.hpp"
#include "solid/contact/joint_laws.hpp"
#include "solid/step/newmark.hpp"

namespace blockweir::solid {

/// The scene must outlive it.
struct Model {
  explicit Model(const scene::Scene& scene);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const scene::Scene& scene;
  Parts parts;
  const std::vector<Block>& blocks;  ///< of the parts: the scene's, then the triangles of meshes
  JointLaws laws;
  Loads loads;
  BaseMotion base;
  ViscousBoundary boundary;
  WaterMotions water_motions;
  double size_m = 0;          ///< half the height of what can move, at least half its width
  double weight_n_per_m = 0;  ///< of all that can move
  Newmark scheme;             ///< the scene's integrator

  [[nodiscard]] std::size_t described() const { return scene.blocks.size(); }  ///< number of the scene's blocks
  [[nodiscard]] bool is(scene::AnalysisKind kind) const { return scene.analysis.kind == kind; }
  [[nodiscard]] FormulationSettings contact_settings() const;
  /// Median over the movable blocks of the lesser side of the box around each [m].
  [[nodiscard]] double typical_width_m() const;
  /// At most about as much as corners move against each other where blocks strain, or contacts are springs, under their
  /// weight and as much again of water and wedging [m]; at most a hundredth of a block's width.
  [[nodiscard]] double give_under_weight_m() const;
  /// Of a step long against every elastic period, so that inertia only regularizes: 2 M/dt^2 is 1e-4 of the elastic
  /// modulus [s].
  [[nodiscard]] double pseudo_step_s() const;
  /// The time whose loads settle: a static analysis has those of its end.
  [[nodiscard]] double settling_time_s() const;
  /// Blocks whose stiffness does not matter, as the scene lets them choose by the contacts that it begins with.
  void make_rigid(const std::vector<ContactPoint>& contacts);
};

}  // namespace blockweir::solid
