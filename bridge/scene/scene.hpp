// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene file says, as plain data in SI units, per metre of thickness.
// Nothing here knows how the file is written (read.hpp) or what is physically sound (check.hpp).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "bridge/scene/joint_flow.hpp"
#include "bridge/scene/joint_law.hpp"
#include "bridge/scene/loads.hpp"
#include "bridge/scene/studies.hpp"
#include "bridge/scene/uplift.hpp"
#include "bridge/scene/water.hpp"

namespace blockweir::scene {

struct Material {
  std::string name;
  double youngs_modulus_pa = 0;
  double poissons_ratio = 0;
  double density_kg_per_m3 = 0;
  std::optional<double> damping_ratio{};  ///< of a block's lowest natural frequency of strain; default: while it slides
  Eigen::Vector3d initial_stress_pa = Eigen::Vector3d::Zero();  ///< (xx, yy, xy) where there is no strain
  bool operator==(const Material&) const = default;
};

struct Joint {
  std::string name;
  std::array<int, 2> between;  ///< indices into Scene::blocks
  JointLaw law;
  std::string set{};  ///< the joint set, cut or region edge that it is a piece of; empty: none
  bool operator==(const Joint&) const = default;
};

struct Block {
  std::string name;
  int material = 0;             ///< index into Scene::materials
  std::vector<Point> vertices;  ///< m, counter-clockwise
  bool fixed = false;           ///< does not move and has no degrees of freedom
  bool rigid = false;           ///< moves, but does not strain
  Point initial_velocity_m_per_s = Point::Zero();
  double initial_spin_deg_per_s = 0;
  std::optional<Eigen::Vector3d> initial_stress_pa{};  ///< default: the material's
  double mesh_size_m = 0;  ///< of the triangles that the solid cuts it into; 0: none, one strain for all of it
  int line = 0;            ///< where the scene file states it
  bool operator==(const Block&) const = default;
};

/// A bar between two blocks, or between a block and the ground: elastic, then plastic at a constant force.
struct Bolt {
  std::string name;
  std::array<int, 2> blocks{-1, -1};  ///< of from_m and to_m; -1: the ground
  Point from_m;
  Point to_m;
  double stiffness_n_per_m2 = 0;  ///< force over elongation, per metre of thickness
  double prestress_n_per_m = 0;   ///< tension at time 0 as the scene draws it
  std::optional<double> yield_n_per_m;
  bool takes_compression = false;
  bool operator==(const Bolt&) const = default;
};

enum class AnalysisKind { dynamic, quasi_static, at_rest };
enum class Integrator { shi, trapezoidal, generalized_alpha };
enum class Plane { strain, stress };

/// What state the run starts from: `equilibrium` lets weight and first loads settle with all joints
/// held, then releases them at time 0; `unstressed` starts without any stress or contact force.
enum class Start { equilibrium, unstressed };

/// Which blocks have no strains: those that the scene names, all, none, or beside the named ones those whose contact
/// forces follow from equilibrium alone and whose own strain moves them little (automatic).
enum class Rigid { named, automatic, all, none };

struct Analysis {
  AnalysisKind kind = AnalysisKind::dynamic;
  Integrator integrator = Integrator::shi;
  double spectral_radius = 0.8;  ///< generalized-alpha only, 0..1
  Plane plane = Plane::strain;
  Start start = Start::equilibrium;
  double duration_s = 1;
  double step_s = 0.01;                  ///< the largest step
  double max_displacement_ratio = 0.01;  ///< of a step, over half the larger side of the box around all that can move
  double gravity_m_per_s2 = 9.81;
  double gravity_tilt_deg = 0;       ///< gravity turned about the origin, as if the ground dipped downstream by as much
  double mass_damping_per_s = 0;     ///< drag on all motion, over the mass
  double rest_speed_m_per_s = 1e-5;  ///< below it a block counts as at rest; read: 7e-7 of sqrt(g L)
  double failure_displacement_m = 0.02;  ///< an unbroken motion longer than this is a failure; read: 1e-3 L
  bool stop_at_failure = false;          ///< end the run once the failure is certain
  bool islands = true;                   ///< solve groups of blocks in contact apart
  bool sleep = true;                     ///< leave islands at rest under unchanging loads as they are
  bool skip_searches = true;             ///< while nothing has moved, contacts are not searched anew
  bool reuse_factors = true;             ///< factors of matrices serve again
  Rigid rigid = Rigid::named;
  double residual_tolerance = 1e-8;  ///< at_rest: largest unbalanced force over the weight of all that can move

  /// Acceleration of gravity [m/s2].
  [[nodiscard]] Point gravity() const {
    const double tilt = gravity_tilt_deg * std::numbers::pi / 180;
    return gravity_m_per_s2 * Point(std::sin(tilt), -std::cos(tilt));
  }
  bool operator==(const Analysis&) const = default;
};

enum class ContactFormulation { augmented_lagrangian, lagrange_multiplier, penalty };

struct Contact {
  ContactFormulation formulation = ContactFormulation::augmented_lagrangian;
  std::optional<double> initial_penalty_n_per_m2;  ///< augmented Lagrangian; default: chosen from the blocks
  std::optional<double> stiffness_n_per_m2;        ///< penalty method: of a contact's spring, per metre of thickness
  double dashpot_ratio = 0;                        ///< penalty method: of the spring's critical damping
  bool measure_condition = false;                  ///< report the largest condition number of the systems solved
  double penetration_tolerance_m = 1e-9;           ///< read: 5e-11 L, L the structure's size (structure_size.hpp)
  double force_tolerance = 1e-10;                  ///< of the weight of all that can move
  int max_iterations = 200;
  bool operator==(const Contact&) const = default;
};

struct Output {
  double frame_every_s = 0.1;      ///< a VTK file each
  double history_every_s = 0.01;   ///< a row of history.csv each
  bool reservoir = false;          ///< the reservoir's mesh and pressures too, reservoir.pvd
  double checkpoint_every_s = 60;  ///< of wall time; 0: only when asked to stop
  bool operator==(const Output&) const = default;
};

/// A ring of equal voussoirs; the scene's blocks hold them too.
struct Arch {
  std::string name;
  Point centre_m = Point::Zero();
  double mean_radius_m = 0;
  double thickness_m = 0;
  double embrace_deg = 180;  ///< of the whole ring, its crown being above the centre
  int voussoirs = 0;
  bool operator==(const Arch&) const = default;
};

struct Scene {
  std::filesystem::path file;
  std::string title;
  std::string note;  ///< provenance: what is published, what reconstructed
  std::vector<Material> materials;
  std::vector<Block> blocks;
  std::vector<Arch> arches;  ///< that some of the blocks form
  JointLaw default_joint;
  std::vector<Joint> joints;  ///< pairs that are not listed follow default_joint
  std::vector<Support> supports;
  std::vector<ViscousFace> viscous_faces;
  std::vector<PointLoad> point_loads;
  std::vector<FacePressure> face_pressures;
  std::vector<LineLoad> line_loads;
  std::vector<BodyLoad> body_loads;
  std::vector<Bolt> bolts;
  std::optional<BaseMotion> base_motion;
  Analysis analysis;
  Contact contact;
  Water water;
  JointFlow joint_flow;
  FluidModel fluid = FluidModel::none;
  OpenFoam openfoam;
  Reservoir reservoir;
  Column column;
  External external;
  Coupling coupling;
  Output output;
  std::vector<Expectation> expectations;
  std::vector<Expectation> water_expectations;  ///< of OpenFOAM's water; a value each
  std::vector<Variant> variants;
  Studies studies;
  std::vector<std::string> warnings;  ///< of the reader: what has no effect, or an unusual magnitude
  std::string text;                   ///< the file as read, overrides applied: what the digest covers
  std::string digest;                 ///< 16 hexadecimal digits
  bool operator==(const Scene&) const = default;
};

}  // namespace blockweir::scene
