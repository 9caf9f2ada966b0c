// SPDX-License-Identifier: GPL-3.0-or-later
// links: blockweir_independent nlohmann_json::nlohmann_json
// --engine slurm on a real queue, which these tests start and end: see tests/slurm.sh. They fail where it does not
// start.
#include "tests/block_on_plane.hpp"
#include "tests/independent/upper_crack.hpp"
#include "tests/processes.hpp"

namespace blockweir::test::slurm_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Slurm : public Processes {
 protected:
  void SetUp() override {
    ASSERT_EQ(shell(script + " up queue"), 0) << text("out");
    ::setenv("SLURM_CONF", (folder / "queue/slurm.conf").c_str(), 1);
  }
  void TearDown() override {
    EXPECT_EQ(shell(script + " down queue"), 0) << text("out");
    ::unsetenv("SLURM_CONF");
  }
  void write_scene(int samples) const {
    std::ofstream(folder / "scene.toml") << independent::UncertainCrack().scene()
                                         << "[reliability]\nlevel_m = 21.5\nmethods = ['none']\nsamples = " << samples
                                         << "\n";
  }
  [[nodiscard]] static std::string command(const std::string& out, const std::string& options = "") {
    return programs + "/blockweir reliability scene.toml --out " + out + " " + options;
  }
  const std::string script = std::string(BLOCKWEIR_SOURCE) + "/tests/slurm.sh";
};

TEST_F(Slurm, GivesTheSameBitsAsTheMachineItself) {
  write_scene(300);
  ASSERT_EQ(shell(command("here")), 0) << text("out");
  ASSERT_EQ(shell(command("queue-out", "--engine slurm --batch 50")), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("in the queue: 6 tasks of 50"));
  EXPECT_EQ(text("queue-out/samples.csv"), text("here/samples.csv"));
  EXPECT_FALSE(fs::exists(folder / "queue-out/reliability.slurm"));
}

TEST_F(Slurm, ByDefaultTheFirstRunsShowHowManyMakeTenMinutes) {
  write_scene(30);
  ASSERT_EQ(shell(command("there", "--engine slurm")), 0) << text("out");
  EXPECT_THAT(text("out"),
              testing::AllOf(HasSubstr("8 tasks of 1, to see how long one takes"), HasSubstr("1 task of 22\n")));
}

/// Tasks of seconds, so that they are met even where a look at all processes takes that long; fewer kills than the
/// three jobs without an answer after which the engine gives up, even where each kill meets all tasks of a job.
TEST_F(Slurm, KilledTasksLoseNothingAndCountNothingTwice) {
  write_scene(3000);
  ASSERT_EQ(shell(command("here")), 0) << text("out");
  const pid_t launcher = start(command("there", "--engine slurm --batch 1500"), "killed");
  int kills = 0;
  int status = -1;
  for (const auto begun = std::chrono::steady_clock::now();  // tasks die as they come
       status < 0 && std::chrono::steady_clock::now() - begun < std::chrono::seconds(200);
       status = end_of(launcher, 0.1)) {
    if (kills < 2) kills += shell("pkill -KILL -f '[b]lockweir work " + folder.string() + "'") == 0 ? 1 : 0;
  }
  EXPECT_GE(kills, 1);
  ASSERT_EQ(status, 0) << text("killed");
  ASSERT_EQ(shell(command("there", "--engine slurm")), 0) << text("killed") << text("out");
  EXPECT_EQ(text("there/samples.csv"), text("here/samples.csv"));
}

TEST_F(Slurm, ALostLauncherFindsItsJobAgainAndCtrlCTakesItOutOfTheQueue) {
  write_scene(2000);
  const pid_t lost = start(command("there", "--engine slurm --batch 200"), "lost");
  for (int i = 0; i < 400 && !fs::exists(folder / "there/reliability.slurm/job"); ++i) usleep(50'000);
  ::kill(lost, SIGKILL);
  EXPECT_EQ(end_of(lost, 10), 128 + SIGKILL);
  // What the lost one has asked of the queue may outlive it by a moment, and holds the folder.
  constexpr int held = 2;
  pid_t again = 0;
  int status = held;
  for (int i = 0; i < 20 && status == held; ++i) {
    again = start(command("there", "--engine slurm"), "again");
    status = end_of(again, 1);
  }
  if (status < 0) {
    ::kill(again, SIGINT);
    status = end_of(again, 60);
  }
  if (status != 0) {  // else it had been done by then
    EXPECT_EQ(status, 130) << text("again");
    EXPECT_THAT(text("again"), HasSubstr("stopped on request; the same command continues"));
    for (int i = 0; i < 40 && shell("test -z \"$(squeue --noheader)\"") != 0; ++i) usleep(250'000);
    EXPECT_EQ(shell("test -z \"$(squeue --noheader)\""), 0) << "the job is still in the queue";
  }
  ASSERT_EQ(shell(command("there", "--engine slurm")), 0) << text("out");
  ASSERT_EQ(shell(command("here")), 0) << text("out");
  EXPECT_EQ(text("there/samples.csv"), text("here/samples.csv"));
}

TEST_F(Slurm, StudiesRunThereToo) {
  std::ofstream(folder / "scene.toml")
      << "[analysis]\nduration_s = 0.3\ngravity_tilt_deg = 20\nfailure_displacement_m "
         "= 0.002\nstop_at_failure = true\n"
      << block_on_plane
      << "[[study]]\nname = 'slope'\nkind = 'map'\nx_key = 'analysis.gravity_tilt_deg'\n"
         "x_values = [20, 40]\ny_key = 'joint.friction_angle_deg'\ny_values = [25, 30]\n";
  ASSERT_EQ(shell(programs + "/blockweir study scene.toml --out there --engine slurm"), 0) << text("out");
  ASSERT_EQ(shell(programs + "/blockweir study scene.toml --out here"), 0) << text("out");
  EXPECT_EQ(json::parse(text("there/slope.json"))["answer"], json::parse(text("here/slope.json"))["answer"]);
}

TEST_F(Slurm, CasesAreValidatedThereToo) {
  const auto figures = [&](const std::string& options, const std::string& file) {
    EXPECT_EQ(shell(programs + "/blockweir validate " + cases + "incline --json " + file + " " + options), 0)
        << text("out");
    json all = json::parse(text(file));
    for (json& figure : all) figure.erase("wall_time_s");
    return all;
  };
  const json here = figures("", "here.json");
  EXPECT_GT(here.size(), 1U);
  EXPECT_EQ(figures("--engine slurm", "there.json"), here);
}

TEST_F(Slurm, ErrorsOfABenchComeFromThereToo) {
  const auto errors = [&](const std::string& out, const std::string& options) {
    EXPECT_EQ(shell(programs + "/blockweir bench " + cases + "incline --short --untimed --out " + out + " " + options),
              0)
        << text("out");
    return json::parse(text(out + "/bench.json"));
  };
  const json here = errors("here", "");
  EXPECT_GT(here[0]["points"].size(), 2U);
  EXPECT_EQ(errors("there", "--engine slurm --batch 4"), here);
}

TEST_F(Slurm, AQueueThatRefusesSaysWhyAndWhatToDo) {
  write_scene(20);
  EXPECT_EQ(shell(command("r", "--engine slurm --sbatch=--partition=nowhere")), 1);
  EXPECT_THAT(text("out"), testing::AllOf(HasSubstr("the queue refused"), HasSubstr("invalid partition specified"),
                                          HasSubstr("state other options of sbatch with --sbatch")));
}

class NoSlurm : public Processes {};

TEST_F(NoSlurm, IsToldWithWhatToDo) {
  std::ofstream(folder / "scene.toml") << independent::UncertainCrack().scene();
  fs::create_directory(folder / "bin");
  for (const char* tool : {"sh", "timeout"}) {
    EXPECT_EQ(shell(std::string("ln -s \"$(command -v ") + tool + ")\" bin/"), 0);
  }
  EXPECT_EQ(shell("env PATH=" + (folder / "bin").string() + " " + programs +
                  "/blockweir reliability scene.toml --out r --engine slurm"),
            1);
  EXPECT_THAT(text("out"),
              testing::AllOf(HasSubstr("found no sbatch, squeue and scancel on this machine"),
                             HasSubstr("log in to the cluster's front end"), HasSubstr("leave --engine out")));
}

}  // namespace
}  // namespace blockweir::test::slurm_test
