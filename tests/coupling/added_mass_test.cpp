// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_schedule
// The solid's process against water, here the test's own, that is heavier than the block it resists.
#include "bridge/scene/read/read.hpp"
#include "bridge/schedule/hello.hpp"
#include "bridge/schedule/run.hpp"
#include "tests/processes.hpp"

namespace blockweir::added_mass_test {
namespace {

constexpr double mass = 2500 * 2;
constexpr double window_s = 0.01;

/// Pushed at 1 m/s2 times its mass.
const char* const gate = R"([analysis]
duration_s = 0.5
step_s = 0.01
gravity_m_per_s2 = 0
max_displacement_ratio = 1
start = "unstressed"
[material.concrete]
youngs_modulus_pa = 50e9
poissons_ratio = 0.2
density_kg_per_m3 = 2500
[[block]]
name = "gate"
material = "concrete"
vertices_m = [[0, 0], [1, 0], [1, 2], [0, 2]]
[[point_load]]
block = "gate"
point_m = [0.5, 1]
force_n_per_m = [5000, 0]
[water]
upstream_level_m = 1
)";

/// Answers the acceleration of the window before, as inertia, on the gate's left face.
class HeavyWater final : public schedule::FluidSide {
 public:
  explicit HeavyWater(double ratio) : inertia_(ratio * mass) {}
  void advance(const wire::Motion& motion, double /*to_s*/, wire::Load& load) override {
    const double speed = motion.velocity[0][0];
    const double pressure = -inertia_ * (speed - speed_) / window_s / 2;
    speed_ = speed;
    load.upstream_level_m = load.downstream_level_m = 1;
    load.block = {0};
    load.edge = {3};
    load.s_from = {0};
    load.s_to = {1};
    load.pressure_from_pa = load.pressure_to_pa = {pressure};
    load.added_mass = {{inertia_, 0, 0, 0, 0, 0}};
  }

 private:
  double inertia_;
  double speed_ = 0;
};

class AddedMass : public test::Processes {
 protected:
  /// Exit status of the solid; what the fluid heard is in `heard`.
  int run(double ratio, const std::string& overrides) {
    std::ofstream(folder / "scene.toml") << gate << overrides;
    const auto scene = scene::read(folder / "scene.toml", {}).scene;
    const std::string endpoint = "ipc://" + (folder / "line").string();
    const pid_t solid = start(test::programs + "/blockweir-solid scene.toml --out r --endpoint " + endpoint, "solid");
    channel::Channel channel(
        {.side = channel::Side::connects, .endpoint = endpoint, .partner = "solid process", .timeout_s = 20});
    HeavyWater water(ratio);
    try {
      channel.handshake(schedule::hello(scene, "hydrostatic"));
      checkpoint::Checkpoints none("", "hydrostatic", scene.digest, 0);
      schedule::run_fluid(channel, none, 0, water);
    } catch (const channel::PeerError& error) {
      heard = error.what();
    }
    return end_of(solid, 20);
  }

  std::string heard;
};

TEST_F(AddedMass, WaterThreeTimesAsHeavyAsTheBlockMovesWithItAsOne) {
  EXPECT_EQ(run(3, ""), 0) << text("solid");
  const auto summary = nlohmann::json::parse(text("r/summary.json"));
  EXPECT_NEAR(summary["largest_displacement_m"].get<double>() / (0.25 * 0.5 * 0.5 / 2), 1, 1e-4);
  EXPECT_EQ(summary["added_mass"]["text"], "added mass 3 of block \"gate\"'s own (guarded)");
  EXPECT_EQ(heard, "");
}

TEST_F(AddedMass, WithoutTheGuardBothSidesAreToldWhyTheRunIsRefused) {
  EXPECT_EQ(run(3, "[coupling]\nadded_mass_guard = false\n"), 1);
  const auto reason = testing::HasSubstr(
      "block \"gate\" has to push water 3 times as heavy as itself; without the added-mass guard the exchange is "
      "unstable "
      "above 1, whatever the step; set [coupling] added_mass_guard = true");
  EXPECT_THAT(text("solid"), reason);
  EXPECT_THAT(heard, reason);
  EXPECT_EQ(nlohmann::json::parse(text("r/summary.json"))["outcome"], "stopped");
}

}  // namespace
}  // namespace blockweir::added_mass_test
