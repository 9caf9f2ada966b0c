// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_schedule
// When the solid writes its results: each once, while the fluid works on the next motion; and its checkpoint, when the
// fluid fails.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "bridge/schedule/run.hpp"

namespace blockweir::schedule::schedule_record_test {
namespace {

enum class Fails { never, told, heard };

/// Both sides note what they do by a letter: t told, h heard, s started, a advanced, r recorded, p prepared.
class Fluid final : public FluidLine {
 public:
  Fluid(std::string& done, Fails fails) : done_(done), fails_(fails) {}
  void send(const wire::Motion& motion) override {
    load_.window = motion.window;
    fail_in(Fails::told);
    done_ += 't';
  }
  void receive(wire::Load& load) override {
    fail_in(Fails::heard);
    done_ += 'h';
    load = load_;
  }
  [[nodiscard]] std::string name() const override { return "fluid"; }

 private:
  /// With the third motion.
  void fail_in(Fails now) const {
    if (fails_ == now && load_.window == 2) throw channel::PeerError("the fluid is lost");
  }
  std::string& done_;
  Fails fails_;
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
  void prepare() override { done_ += 'p'; }
  [[nodiscard]] bool finished() const override { return false; }

 private:
  std::string& done_;
  bool recorded_ = true;
};

scene::Scene three_windows(scene::Schedule schedule) {
  scene::Scene scene;
  scene.analysis.duration_s = 0.3;
  scene.coupling.window_s = 0.1;
  scene.coupling.schedule = schedule;
  scene.coupling.skip_exchanges = false;
  return scene;
}

std::string done_in(scene::Schedule schedule, bool dry) {
  const scene::Scene scene = three_windows(schedule);
  std::string done;
  Fluid fluid(done, Fails::never);
  Solid solid(done);
  checkpoint::Checkpoints none("", "solid", "", 0);
  run_solid(dry ? nullptr : &fluid, scene, none, 0, solid);
  return done;
}

TEST(Recording, GoesOnWhileTheFluidAnswersAndMissesNoWindow) {
  EXPECT_EQ(done_in(scene::Schedule::serial, false), "tphsatrphatrphar");
  EXPECT_EQ(done_in(scene::Schedule::parallel, false), "tphstahtrahrar");
  EXPECT_EQ(done_in(scene::Schedule::improved, false), "tphstphatrphatrphar");
}

/// Windows to go on from, and what was done until then.
std::pair<std::vector<std::uint64_t>, std::string> left_by(scene::Schedule schedule, Fails fails) {
  const auto folder = std::filesystem::temp_directory_path() / ("blockweir-lost-" + std::to_string(::getpid()));
  const scene::Scene scene = three_windows(schedule);
  std::string done;
  Fluid fluid(done, fails);
  Solid solid(done);
  checkpoint::Checkpoints checkpoints(folder, "solid", "", 0);
  EXPECT_THROW(run_solid(&fluid, scene, checkpoints, 0, solid), channel::PeerError);
  const std::vector<std::uint64_t> left = checkpoint::windows(folder, "solid");
  std::filesystem::remove_all(folder);
  return {left, done};
}

TEST(Recording, OfAFluidThatIsLostLeavesACheckpointWhereTheSolidHasNotGoneOn) {
  using scene::Schedule;
  using testing::ElementsAre;
  using testing::IsEmpty;
  using testing::Pair;
  EXPECT_THAT(left_by(Schedule::serial, Fails::told), Pair(ElementsAre(2), "tphsatrphar"));
  EXPECT_THAT(left_by(Schedule::serial, Fails::heard), Pair(ElementsAre(2), "tphsatrphatrp"));
  EXPECT_THAT(left_by(Schedule::improved, Fails::told), Pair(ElementsAre(2), "tphstphar"));
  EXPECT_THAT(left_by(Schedule::improved, Fails::heard), Pair(ElementsAre(2), "tphstphatrp"));
  EXPECT_THAT(left_by(Schedule::parallel, Fails::told), Pair(ElementsAre(2), "tphstahr"));
  EXPECT_THAT(left_by(Schedule::parallel, Fails::heard), Pair(IsEmpty(), "tphstahtra"));
}

TEST(Recording, NeedsNoFluid) {
  EXPECT_EQ(done_in(scene::Schedule::serial, true), "sararar");
}

}  // namespace
}  // namespace blockweir::schedule::schedule_record_test
