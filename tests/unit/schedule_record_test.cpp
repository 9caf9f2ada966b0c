// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_schedule
// When the solid writes its results: each once, while the fluid works on the next motion.
#include <gtest/gtest.h>

#include "bridge/schedule/run.hpp"

namespace blockweir::schedule {
namespace {

/// Both sides note what they do by a letter: t told, h heard, s started, a advanced, r recorded.
class Fluid final : public FluidLine {
 public:
  explicit Fluid(std::string& done) : done_(done) {}
  void tell(const wire::Motion& motion) override {
    done_ += 't';
    load_.window = motion.window;
  }
  void hear(wire::Load& load) override {
    done_ += 'h';
    load = load_;
  }

 private:
  std::string& done_;
  wire::Load load_;
};

class Solid final : public SolidSide {
 public:
  explicit Solid(std::string& done) : done_(done) {}
  void place(wire::Motion& /*motion*/) override {}
  void predict(double /*ahead_s*/, wire::Motion& /*motion*/) override {}
  void start(const wire::Load& /*load*/) override { done_ += 's'; }
  void advance(const wire::Load& /*load*/, const wire::Motion& /*told*/, double /*from_s*/, double /*to_s*/) override {
    done_ += 'a';
    recorded_ = false;
  }
  void record() override {
    if (!recorded_) done_ += 'r';
    recorded_ = true;
  }
  [[nodiscard]] bool finished() const override { return false; }

 private:
  std::string& done_;
  bool recorded_ = true;
};

std::string done_in(scene::Schedule schedule, bool dry) {
  scene::Scene scene;
  scene.analysis.duration_s = 0.3;
  scene.coupling.window_s = 0.1;
  scene.coupling.schedule = schedule;
  scene.coupling.skip_exchanges = false;
  std::string done;
  Fluid fluid(done);
  Solid solid(done);
  checkpoint::Checkpoints none("", "solid", "", 0);
  run_solid(dry ? nullptr : &fluid, scene, none, 0, solid);
  return done;
}

TEST(Recording, GoesOnWhileTheFluidAnswersAndMissesNoWindow) {
  EXPECT_EQ(done_in(scene::Schedule::serial, false), "thsatrhatrhar");
  EXPECT_EQ(done_in(scene::Schedule::parallel, false), "thstahtrahrar");
  EXPECT_EQ(done_in(scene::Schedule::improved, false), "thsthatrhatrhar");
}

TEST(Recording, NeedsNoFluid) {
  EXPECT_EQ(done_in(scene::Schedule::serial, true), "sararar");
}

}  // namespace
}  // namespace blockweir::schedule
