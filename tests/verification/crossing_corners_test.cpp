// SPDX-License-Identifier: GPL-3.0-or-later
// links: blockweir_independent solid_process fluid_hydrostatic nlohmann_json::nlohmann_json
// Where joints cross, corners touch corners. What slides along one of the joints passes them all: which edge a corner
// meets is not for round-off, strains or springs to say.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/independent/random_structures.hpp"
#include "tests/own_folder.hpp"
#include "tests/run_scene.hpp"
#include "tests/verification/campaign.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::test::crossing_corners_test {
namespace {

using independent::Random;
using solid::Point;

constexpr double degree = std::numbers::pi / 180;
constexpr double gravity = 9.81;

/// One or two blocks on a plane that joints cut, at any place, scale, slope and angle of the joints.
struct Slide {
  scene::Scene scene;
  double acceleration;
  double length_m;  ///< of a block
  int blocks;
  std::string text;
};

Slide random_slide(std::uint64_t seed) {
  Random random(seed, "slide");
  const double slope = random.between(15, 40) * degree;
  const double friction = slope * random.between(0, 0.8);
  const double size = random.between_orders(0.1, 100);
  const Point origin(random.between(-10, 10) * size, random.between(-10, 10) * size);
  const double below = random.between(25, 155) * degree;  // of joints, against the plane
  const double above = random.between(25, 155) * degree;
  const int bricks = random.chance(0.5) ? 1 : 6;
  Slide slide{solid::empty_scene(), gravity * (std::sin(slope) - std::cos(slope) * std::tan(friction)), 3 * size,
              random.chance(0.5) ? 1 : 2, ""};
  const Eigen::Rotation2Dd downhill(-slope);
  const auto add = [&](std::vector<Point> outline, bool fixed) {
    for (Point& p : outline) p = origin + downhill * p;
    solid::add(slide.scene, std::move(outline), fixed);
  };
  const Point down = size / std::sin(below) * Point(std::cos(below), -std::sin(below));
  const Point up = size / std::sin(above) * Point(std::cos(above), std::sin(above));
  const auto part = [](double from, double to, const Point& side) {
    std::vector<Point> outline = {Point(from, 0), Point(to, 0), Point(to, 0) + side, Point(from, 0) + side};
    if (side.y() < 0) std::reverse(outline.begin(), outline.end());
    return outline;
  };
  add(part(-5 * size, 0, down), true);
  for (int k = 0; k < bricks; ++k) add(part(12 * size * k / bricks, 12 * size * (k + 1) / bricks, down), true);
  for (int k = 0; k < slide.blocks; ++k) add(part((k - 1) * slide.length_m, k * slide.length_m, up), false);
  slide.scene.default_joint.friction_angle_deg = slide.scene.default_joint.residual_friction_angle_deg =
      friction / degree;
  slide.scene.analysis.rigid = random.chance(0.5) ? scene::Rigid::all : scene::Rigid::named;
  slide.scene.contact.formulation =
      random.of(std::vector{scene::ContactFormulation::augmented_lagrangian, scene::ContactFormulation::penalty,
                            scene::ContactFormulation::lagrange_multiplier});
  slide.scene.contact.penetration_tolerance_m = 1e-10 * size;
  slide.text = fmt::format(
      "seed {}, slope {:.4g}, friction {:.4g}, joints at {:.4g} and {:.4g} deg, size {:.3g} m, {} of {}, {}", seed,
      slope / degree, friction / degree, below / degree, above / degree, size, slide.blocks, bricks,
      slide.scene.analysis.rigid == scene::Rigid::all ? "rigid" : "straining");
  return slide;
}

TEST(CrossingCorners, ArePassedByWhatSlidesOnOneOfTheJoints) {
  for (int seed = 1; seed <= campaign(40); ++seed) {
    Slide slide = random_slide(static_cast<std::uint64_t>(seed));
    const double way_m = 0.4 * slide.length_m;
    const double duration_s = std::sqrt(2 * way_m / slide.acceleration);
    slide.scene.analysis.step_s = duration_s / 100;
    solid::Solid solid(slide.scene);
    solid.settle({});
    solid::run(solid, duration_s);
    for (int k = 0; k < slide.blocks; ++k) {
      const auto b = slide.scene.blocks.size() - 1 - static_cast<std::size_t>(k);
      EXPECT_NEAR(solid.states()[b].displacement.head<2>().norm() / way_m, 1, 0.01) << slide.text;
    }
  }
}

class CrossedSections : public OwnFolder {};

/// A dam of triangular shape with a crest, its foot in the ground, cut by a plane that dips downstream and by a steep
/// one that crosses it.
struct CrossedSection {
  double height_m, base_m, crest_m;
  double mouth_m, slope, friction;  ///< of the plane
  double foot_m, steepness;         ///< of the steep cut
  std::string rigid, formulation;

  explicit CrossedSection(Random random)
      : height_m(random.between_orders(2, 100)),
        base_m(random.between(0.6, 0.9) * height_m),
        crest_m(random.between(0.1, 0.3) * height_m),
        mouth_m(random.between(0.25, 0.45) * height_m),
        slope(random.between(0.05, 0.25)),
        friction(std::atan(slope) + random.between(10, 22) * degree),
        foot_m(random.between(0.05, 0.35) * base_m),
        steepness(random.between(2, 8)),
        rigid(random.chance(0.5) ? "all" : "named"),
        formulation(random.of(std::vector<std::string>{"augmented-lagrangian", "penalty", "lagrange-multiplier"})) {}

  [[nodiscard]] double lean() const { return (base_m - crest_m) / height_m; }
  /// Where the plane comes out of the downstream face.
  [[nodiscard]] Point end() const {
    const double x = (base_m - lean() * mouth_m) / (1 - lean() * slope);
    return {x, mouth_m - slope * x};
  }
  /// At which all above the plane slides on it: half rho g h^2 = W tan(friction - dip), h above the plane's mouth.
  [[nodiscard]] double level_m() const {
    const double area = ((end().x() + crest_m) * (height_m - end().y()) - end().x() * (mouth_m - end().y())) / 2;
    const double push = 2400 * gravity * area * std::tan(friction - std::atan(slope));
    return mouth_m + std::sqrt(2 * push / (1000 * gravity));
  }
  [[nodiscard]] std::string text() const {
    const auto far = 3 * height_m;
    return fmt::format(
        R"([analysis]
duration_s = 10
step_s = {step}
stop_at_failure = true
rigid = "{rigid}"
[contact]
formulation = "{formulation}"
[material.m]
youngs_modulus_pa = 20e9
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[joint]
friction_angle_deg = {friction}
[section]
material = "m"
outline_m = [[0, 0], [{base}, 0], [{crest}, {height}], [0, {height}]]
[[block]]
name = "ground"
material = "m"
fixed = true
vertices_m = [[-{far}, -{height}], [{far}, -{height}], [{far}, {toe_y}], [{toe_x}, {toe_y}], [{base}, 0], [0, 0],
              [0, {heel_y}], [-{far}, {heel_y}]]
[[cut]]
name = "plane"
points_m = [[-{far}, {plane_left}], [{far}, {plane_right}]]
[[cut]]
name = "steep"
points_m = [[{steep_left}, -{steep_up}], [{steep_right}, {steep_up}]]
[water]
upstream_level_m = {{ table = [[0, {low}], [10, {high}]] }}
[output]
frame_every_s = 10
)",
        fmt::arg("step", 0.01 * std::sqrt(height_m / 10)), fmt::arg("rigid", rigid),
        fmt::arg("formulation", formulation), fmt::arg("base", base_m), fmt::arg("crest", crest_m),
        fmt::arg("height", height_m), fmt::arg("far", far), fmt::arg("toe_x", base_m - lean() * end().y() / 2),
        fmt::arg("toe_y", end().y() / 2), fmt::arg("heel_y", 0.8 * mouth_m), fmt::arg("friction", friction / degree),
        fmt::arg("plane_left", mouth_m + slope * far), fmt::arg("plane_right", mouth_m - slope * far),
        fmt::arg("steep_left", foot_m - height_m), fmt::arg("steep_right", foot_m + height_m),
        fmt::arg("steep_up", steepness * height_m), fmt::arg("low", 0.98 * level_m()),
        fmt::arg("high", 1.02 * level_m()));
  }
};

TEST_F(CrossedSections, FailOnThePlaneWhateverCrossesIt) {
  int told = 0;
  for (int seed = 1; seed <= campaign(8); ++seed) {
    const CrossedSection section(Random(static_cast<std::uint64_t>(seed), "crossed"));
    if (1.02 * section.level_m() > section.height_m) continue;
    ++told;
    const Verdict verdict = run_scene(section.text(), folder, 120);
    EXPECT_EQ(verdict.mode + " on " + verdict.joint, "sliding on plane") << "seed " << seed << verdict.trouble;
    EXPECT_NEAR(verdict.level_m / section.level_m(), 1, 1e-3) << "seed " << seed << "\n" << section.text();
  }
  EXPECT_GT(told, 2);
}

}  // namespace
}  // namespace blockweir::test::crossing_corners_test
