// SPDX-License-Identifier: GPL-3.0-or-later
// links: fmt::fmt nlohmann_json::nlohmann_json
// A stranger's program as the fluid: in Python, C and Fortran, by the launcher and by hand. It gives the right level of
// failure, is stopped and resumed, and hears what it has said wrong.
#include <fmt/format.h>

#include <fstream>
#include <regex>

#include "tests/processes.hpp"

namespace blockweir::test::external_fluid_test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

const std::string kit = std::string(BLOCKWEIR_SOURCE) + "/bridge/kit/";
const std::string dam = std::string(BLOCKWEIR_SOURCE) +
                        "/cases/cracked-dam-upper --set analysis.stop_at_failure=true --set fluid.model=external ";

constexpr const char* a_stone = R"([[block]]
name = "rock"
material = "stone"
fixed = true
vertices_m = [[-5, -1], [5, -1], [5, 0], [-5, 0]]
[[block]]
name = "stone"
material = "stone"
vertices_m = [[0, 0], [1, 0], [1, 1], [0, 1]]
)";

class ExternalFluid : public Processes {
 protected:
  /// Of `blockweir run` of the upper dam into the folder "run", with a fluid of these words.
  [[nodiscard]] int run(const std::string& words, const std::string& more = "") const {
    fs::remove_all(folder / "run");
    return shell("env PYTHONPATH=" + kit + "python " + programs + "/blockweir run " + dam + more + " --out run" +
                 command(words));
  }
  static std::string command(const std::string& words) { return " --set 'fluid.external.command=[" + words + "]'"; }
  [[nodiscard]] nlohmann::json summary() const { return nlohmann::json::parse(text("run/summary.json")); }
  void expect_failure_head() const {
    ASSERT_TRUE(fs::exists(folder / "run/summary.json")) << text("out");
    const nlohmann::json found = summary();
    ASSERT_EQ(found["outcome"], "fails") << text("out");
    EXPECT_NEAR(found["failure"]["head_m"].get<double>(), 6.99965, 7e-3);
    RecordProperty("head_m", found["failure"]["head_m"].dump());
  }
};

const std::string python = "\"/usr/bin/python3\"";
const std::string in_python = python + ",\"" + kit + "python/upper_dam.py\"";
std::string liar(const std::string& what) {
  return python + ",\"" + std::string(BLOCKWEIR_SOURCE) + "/tests/coupling/liar.py\",\"" + what + "\"";
}

TEST_F(ExternalFluid, InPythonGivesTheFailureHeadOfTheUpperDam) {
  ASSERT_EQ(run(in_python), 0) << text("out") << text("run/external.log");
  expect_failure_head();
  const nlohmann::json found = summary();
  EXPECT_GT(found["profile_s"]["fluid_step"], 0.0);
  EXPECT_GT(found["counts"]["fluid_answers"], 10);
}

TEST_F(ExternalFluid, InCGivesTheFailureHeadOfTheUpperDam) {
  ASSERT_EQ(run("\"" + programs + "/kit_upper_dam_c\""), 0) << text("out") << text("run/external.log");
  expect_failure_head();
  EXPECT_GT(summary()["profile_s"]["fluid_step"], 0.0);
}

TEST_F(ExternalFluid, InFortranGivesTheFailureHeadOfTheUpperDam) {
  ASSERT_TRUE(fs::exists(programs + "/kit_upper_dam_fortran")) << "without gfortran, which ./blockweir test installs";
  ASSERT_EQ(run("\"" + programs + "/kit_upper_dam_fortran\""), 0) << text("out") << text("run/external.log");
  expect_failure_head();
}

/// The examples are a page each.
TEST_F(ExternalFluid, ExamplesHaveAtMost80Lines) {
  for (const char* file : {"python/upper_dam.py", "c/upper_dam.c", "fortran/upper_dam.f90"}) {
    std::ifstream stream(kit + file);
    const auto lines = std::count(std::istreambuf_iterator<char>(stream), {}, '\n');
    EXPECT_GT(lines, 10) << file;
    EXPECT_LE(lines, 80) << file;
  }
}

TEST_F(ExternalFluid, StartedByHandIsToldWhatToConnectTo) {
  const pid_t launcher = start(programs + "/blockweir run " + dam + "--out run", "launcher");
  std::smatch endpoint;
  const std::regex line("export BLOCKWEIR_ENDPOINT=(\\S+)");
  std::string said;
  for (int wait = 0; wait < 2000 && !std::regex_search(said, endpoint, line); ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    said = text("launcher");
  }
  ASSERT_FALSE(endpoint.empty()) << said;
  EXPECT_THAT(said, HasSubstr("waiting up to 600 s for an external fluid"));
  const std::string where = endpoint[1];
  EXPECT_EQ(shell("env BLOCKWEIR_ENDPOINT=" + where + " " + programs + "/kit_upper_dam_c"), 0) << text("out");
  EXPECT_EQ(end_of(launcher, 20), 0) << text("launcher");
  expect_failure_head();
}

TEST_F(ExternalFluid, RunsInASceneWithoutWater) {
  std::ofstream(folder / "dry.toml") << R"(
title = "a block that a stranger's water pushes off its base"
analysis = { duration_s = 0.2, stop_at_failure = true }
coupling = { timeout_s = 86400 }
joint = { friction_angle_deg = 30 }
material.stone = { youngs_modulus_pa = 50e9, poissons_ratio = 0.2, density_kg_per_m3 = 2500 }
fluid = { model = "external", external = { command = ["/usr/bin/python3", "push.py"], remembers = false } }
)" << a_stone;
  std::ofstream(folder / "push.py") << R"(
from blockweir_fluid import Fluid
with Fluid("a push") as fluid:
    while motion := fluid.receive():
        fluid.send([(1, 3, 0, 1, 20000, 20000)])
)";
  EXPECT_EQ(shell("env PYTHONPATH=" + kit + "python " + programs + "/blockweir run dry.toml --out run"), 0)
      << text("out") << text("run/external.log");
  EXPECT_EQ(summary()["outcome"], "fails") << text("out");  // 20 kN over the 14.2 kN that friction takes
  // The copy of the scene knows in which folder the command starts.
  EXPECT_EQ(shell("env PYTHONPATH=" + kit + "python " + programs + "/blockweir run run/scene.toml --out again"), 0)
      << text("out") << text("again/external.log");
  EXPECT_EQ(nlohmann::json::parse(text("again/summary.json"))["outcome"], "fails");
}

/// What a liar hears, and what the user reads.
TEST_F(ExternalFluid, ThatLiesHearsWhy) {
  const std::vector<std::pair<std::string, std::string>> lies = {
      {"digest", "handshake refused: scene digest: solid has "},
      {"panel count", "columns of 1 and 2 panels in window 3"},
      {"damage", "bytes that are damaged, or not of protocol"},
      {"block", "loads block 1000, edge 3, which the scene does not have"},
      {"edge", "loads block 1, edge 7, which the scene does not have"},
      {"nan", "pressure of panel 0 (block 1, edge 3) is nan in window 3"},
      {"backwards", "s_to of panel 0 (block 1, edge 3) is 0.2 in window 3, before its s_from of 0.8"},
      {"window", "sent window 99 where window 3 was due"}};
  for (const auto& [what, why] : lies) {
    SCOPED_TRACE(what);
    EXPECT_EQ(run(liar(what), "--set coupling.timeout_s=5"), 1);
    EXPECT_THAT(text("run/external.log"), HasSubstr("heard: the solid stopped"));
    EXPECT_THAT(text("run/external.log"), HasSubstr(why));
    EXPECT_THAT(text("out"), HasSubstr(why));
    EXPECT_THAT(text("out"), HasSubstr("a liar")) << "who it was";
    EXPECT_THAT(text("out"), Not(AnyOf(HasSubstr("hydrostatic"), HasSubstr("fluid process"))));
    EXPECT_FALSE(orphan());
  }
}

TEST_F(ExternalFluid, ThatFailsSaysWhyToTheUser) {
  EXPECT_EQ(run(liar("raise")), 1);
  EXPECT_THAT(text("out"), HasSubstr("ArithmeticError: the pump has failed"));
  EXPECT_EQ(run(liar("die")), 1);
  EXPECT_THAT(
      text("out"),
      HasSubstr("liar.py die\" ended with exit status 1, its last line: \"out of water\"; all that it wrote is in "
                "external.log"));
  EXPECT_EQ(run(liar("leave")), 1);
  EXPECT_THAT(text("out"), HasSubstr("external fluid \"a liar\" closed the line in window"));
  EXPECT_FALSE(orphan());
}

TEST_F(ExternalFluid, ThatIsNotThereOrNeverConnectsIsToldOf) {
  EXPECT_EQ(run("\"./no-such-program\""), 1);
  EXPECT_THAT(text("out"), HasSubstr("cannot start ./no-such-program: No such file or directory; expected a program "
                                     "that can be run; correct command in [fluid.external]; its paths start in "));
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(run("\"true\""), 1);  // the solid would wait for a minute
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
  EXPECT_THAT(text("out"),
              HasSubstr("the external fluid \"true\" ended with exit status 0 before the run was under way; it has to "
                        "connect to BLOCKWEIR_ENDPOINT and to stay; all that it wrote is in external.log"));
  EXPECT_EQ(run("\"sleep\",\"1000\"", "--set coupling.timeout_s=1"), 1);
  EXPECT_THAT(text("out"), HasSubstr("no connection with the external fluid \"sleep 1000\" at ipc://"));
  EXPECT_FALSE(orphan());
}

TEST_F(ExternalFluid, WhoseReportIsNoReportIsWarnedOf) {
  EXPECT_EQ(run("\"sh\",\"-c\",\"" + programs + "/kit_upper_dam_c; echo [1,2 > $BLOCKWEIR_REPORT\""), 0) << text("out");
  EXPECT_THAT(text("run/summary.json"), HasSubstr("not a table in JSON; left out"));
}

/// Water that counts its windows: resumed without its state it would begin anew.
TEST_F(ExternalFluid, IsStoppedAndGoesOnFromItsOwnCheckpoint) {
  std::ofstream(folder / "counts.py") << R"(
import os, time
from blockweir_fluid import Fluid
n = 0
def save(window): open(fluid.checkpoint_file(window), "w").write(str(n))
def restore(window):
    global n
    n = int(open(os.path.join(os.environ["BLOCKWEIR_FOLDER"], "checkpoint", f"external-{window}")).read())
with Fluid("counter", save=None if os.environ.get("FORGETS") else save, restore=restore) as fluid:
    while motion := fluid.receive():
        n += 1
        time.sleep(0.005)
        fluid.send([(1, 3, 0, 1, n, n)], upstream_level_m=n)
)";
  const std::string counts = python + ",\"" + (folder / "counts.py").string() + "\"";
  const std::string of =
      "run " + dam + "--set coupling.skip_exchanges=false --set analysis.duration_s=6" + command(counts);
  const std::string environment = "env PYTHONPATH=" + kit + "python ";
  ASSERT_EQ(shell(environment + programs + "/blockweir " + of + " --out whole"), 0) << text("out");
  const pid_t launcher = start(environment + programs + "/blockweir " + of + " --out run", "launcher");
  ASSERT_TRUE(under_way("run"));
  kill(launcher, SIGINT);
  EXPECT_EQ(end_of(launcher, 20), 130) << text("launcher");
  EXPECT_THAT(text("launcher"), HasSubstr("continues the run"));
  EXPECT_EQ(shell(environment + programs + "/blockweir resume run"), 0) << text("out") << text("run/external.log");
  EXPECT_EQ(text("run/history.csv"), text("whole/history.csv"));

  const pid_t forgets =
      start("env FORGETS=1 " + environment + programs + "/blockweir " + of + " --out forgets", "launcher");
  ASSERT_TRUE(under_way("forgets"));
  kill(forgets, SIGINT);
  EXPECT_EQ(end_of(forgets, 20), 130);
  EXPECT_THAT(text("launcher"), HasSubstr("its external fluid has written no checkpoint"));
  EXPECT_EQ(shell(programs + "/blockweir resume forgets"), 2);
  EXPECT_THAT(text("out"), HasSubstr("set remembers = false in [fluid.external]"));
}

TEST_F(ExternalFluid, OfNoLevelHasNoLevelOfFailureWithoutARun) {
  std::ofstream(folder / "dry.toml") << R"(
analysis = { duration_s = 1 }
material.stone = { youngs_modulus_pa = 50e9, poissons_ratio = 0.2, density_kg_per_m3 = 2500 }
fluid = { model = "external" }
)" << a_stone;
  EXPECT_NE(shell(programs + "/blockweir level dry.toml"), 0);
  EXPECT_THAT(text("out"),
              HasSubstr("model = \"external\" in [fluid]; expected water whose pressures are known without"));
}

}  // namespace
}  // namespace blockweir::test::external_fluid_test
