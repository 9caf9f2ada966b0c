// SPDX-License-Identifier: GPL-3.0-or-later
// What stays constant during a run of a scene.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/block/base_motion.hpp"
#include "solid/block/loads.hpp"
#include "solid/block/moving_parts.hpp"
#include "solid/block/viscous_boundary.hpp"
#include "solid/block/water_motions.hpp"
#include "solid/contact/contact_point.hpp"
#include "solid/contact/formulation.hpp"
#include "solid/contact/joint_laws.hpp"
#include "solid/step/newmark.hpp"

namespace blockweir::solid {

/// The scene must outlive the object.
struct Model {
  explicit Model(const scene::Scene& scene);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const scene::Scene& scene;
  MovingParts parts;
  const std::vector<Block>& blocks;  ///< of the parts: the scene's blocks, then the triangles of meshes
  JointLaws laws;
  Loads loads;
  BaseMotion base;
  ViscousBoundary boundary;
  WaterMotions water_motions;
  double size_m = 0;          ///< half the height of the moving blocks, at least half their width
  double weight_n_per_m = 0;  ///< of all moving blocks
  Newmark scheme;             ///< the scene's integrator
  /// Estimate of how far corners move relative to each other by block strain or contact springs, under their weight and
  /// as much again from water and wedging [m]; at most a hundredth of a block's width. Known once blocks are rigid.
  double give_under_weight_m = 0;

  [[nodiscard]] std::size_t described() const { return scene.blocks.size(); }  ///< number of the scene's blocks
  [[nodiscard]] bool is(scene::AnalysisKind kind) const { return scene.analysis.kind == kind; }
  [[nodiscard]] FormulationSettings contact_settings() const;
  /// Median over the moving blocks of the smaller side of each one's bounding box [m].
  [[nodiscard]] double typical_width_m() const;
  /// A step much longer than every elastic period, so that inertia only regularizes: 2 M/dt^2 is 1e-4 of the elastic
  /// modulus [s].
  [[nodiscard]] double pseudo_step_s() const;
  /// The time whose loads apply while settling: for a static analysis, that of its end.
  [[nodiscard]] double settling_time_s() const;
  /// Makes blocks rigid as the scene requests, judged by the initial contacts.
  void make_rigid(const std::vector<ContactPoint>& contacts);

 private:
  [[nodiscard]] double find_give() const;
};

}  // namespace blockweir::solid
