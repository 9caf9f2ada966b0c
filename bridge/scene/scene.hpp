// SPDX-License-Identifier: GPL-3.0-or-later
// The content of a scene file, as plain data in SI units, per metre of thickness. How the file is written is in
// read.hpp, and what is physically possible in check.hpp.
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
  std::optional<double> damping_ratio{};  ///< of a block's lowest strain mode; default: applied only while it slides
  Eigen::Vector3d initial_stress_pa = Eigen::Vector3d::Zero();  ///< (xx, yy, xy) at zero strain
  bool operator==(const Material&) const = default;
};

struct Joint {
  std::string name;
  std::array<int, 2> between;  ///< indices into Scene::blocks
  JointLaw law;
  std::string set{};  ///< the joint set, cut or region edge that it belongs to; empty: none
  bool operator==(const Joint&) const = default;
};

struct Block {
  std::string name;
  int material = 0;             ///< index into Scene::materials
  std::vector<Point> vertices;  ///< m, counter-clockwise
  bool fixed = false;           ///< does not move; no degrees of freedom
  bool rigid = false;           ///< moves, but does not strain
  Point initial_velocity_m_per_s = Point::Zero();
  double initial_spin_deg_per_s = 0;
  std::optional<Eigen::Vector3d> initial_stress_pa{};  ///< default: the material's
  double mesh_size_m = 0;  ///< of the triangles that the block is meshed with; 0: no mesh, uniform strain
  int line = 0;            ///< where the scene file states it
  bool operator==(const Block&) const = default;
};

/// A bar between two blocks, or between a block and the ground: elastic, then plastic at constant force.
struct Bolt {
  std::string name;
  std::array<int, 2> blocks{-1, -1};  ///< of from_m and to_m; -1: the ground
  Point from_m;
  Point to_m;
  double stiffness_n_per_m2 = 0;  ///< force over elongation, per metre of thickness
  double prestress_n_per_m = 0;   ///< tension at time 0, in the geometry as drawn
  std::optional<double> yield_n_per_m;
  bool takes_compression = false;
  bool operator==(const Bolt&) const = default;
};

enum class AnalysisKind { dynamic, quasi_static, at_rest };
enum class Integrator { shi, trapezoidal, generalized_alpha };
enum class Plane { strain, stress };

/// Initial state. equilibrium: weight and first loads settle with all joints held, which are released at time 0;
/// unstressed: no stress and no contact force.
enum class Start { equilibrium, unstressed };

/// Which blocks are rigid: the named ones, all, none, or (automatic) the named ones and those whose contact forces
/// follow from equilibrium alone and whose own strain hardly moves them.
enum class Rigid { named, automatic, all, none };

struct Analysis {
  AnalysisKind kind = AnalysisKind::dynamic;
  Integrator integrator = Integrator::shi;
  double spectral_radius = 0.8;  ///< generalized-alpha only, 0..1
  Plane plane = Plane::strain;
  Start start = Start::equilibrium;
  double duration_s = 1;
  double step_s = 0.01;                  ///< the largest step
  double max_displacement_ratio = 0.01;  ///< in a step, over half the larger side of the box around all moving blocks
  double gravity_m_per_s2 = 9.81;
  double gravity_tilt_deg = 0;           ///< turns gravity about the origin, as if the ground dipped downstream
  double mass_damping_per_s = 0;         ///< drag force on all motion, per unit mass
  double rest_speed_m_per_s = 1e-5;      ///< a block slower than this counts as at rest; default: 7e-7 sqrt(g L)
  double failure_displacement_m = 0.02;  ///< a longer motion without rest is a failure; default: 1e-3 L
  bool stop_at_failure = false;          ///< end the run once the failure is certain
  bool stop_at_breach = false;           ///< end the run once open water passes the structure
  bool islands = true;                   ///< solve groups of blocks in contact separately
  bool sleep = true;                     ///< skip islands at rest under constant loads
  bool skip_searches = true;             ///< do not search for contacts while nothing has moved
  bool reuse_factors = true;             ///< reuse factorized matrices
  Rigid rigid = Rigid::named;
  double residual_tolerance = 1e-8;  ///< for "at_rest": largest unbalanced force over the weight of all moving blocks

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
  bool measure_condition = false;                  ///< report the largest condition number of the solved systems
  double penetration_tolerance_m = 1e-9;           ///< default: 5e-11 L, L the structure's size (structure_size.hpp)
  double force_tolerance = 1e-10;                  ///< of the weight of all moving blocks
  int max_iterations = 200;
  bool operator==(const Contact&) const = default;
};

struct Output {
  double frame_every_s = 0.1;      ///< interval of VTK files
  double history_every_s = 0.01;   ///< interval of rows in history.csv
  bool reservoir = false;          ///< also write the reservoir's mesh and pressures, reservoir.pvd
  double checkpoint_every_s = 60;  ///< of wall time; 0: only on a request to stop
  bool operator==(const Output&) const = default;
};

/// A ring of equal voussoirs; the scene's blocks include them.
struct Arch {
  std::string name;
  Point centre_m = Point::Zero();
  double mean_radius_m = 0;
  double thickness_m = 0;
  double embrace_deg = 180;  ///< angle of the whole ring; the crown is above the centre
  int voussoirs = 0;
  bool operator==(const Arch&) const = default;
};

struct Scene {
  std::filesystem::path file;
  std::string title;
  std::string note;  ///< provenance: what is published, what is reconstructed
  std::vector<Material> materials;
  std::vector<Block> blocks;
  std::vector<Arch> arches;  ///< formed by some of the blocks
  JointLaw default_joint;
  std::vector<Joint> joints;  ///< pairs that are not listed have the law default_joint
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
  std::vector<Expectation> water_expectations;  ///< of OpenFOAM's water; one value each
  std::vector<Variant> variants;
  Studies studies;
  std::vector<std::string> warnings;  ///< from the reader: keys without effect, unusual magnitudes
  std::string text;                   ///< the file as read, with overrides: the digest is computed from it
  std::string digest;                 ///< 16 hexadecimal digits
  bool operator==(const Scene&) const = default;
};

}  // namespace blockweir::scene
