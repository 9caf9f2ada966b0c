// SPDX-License-Identifier: GPL-3.0-or-later
// links: blockweir_independent nlohmann_json::nlohmann_json
// blockweir reliability against limit equilibrium: the upper crack with a friction angle, a cohesion and a density that
// are uncertain.
#include <cmath>

#include "tests/independent/upper_crack.hpp"
#include "tests/processes.hpp"

namespace blockweir::test::reliability_test {
namespace {

using independent::UncertainCrack;
using nlohmann::json;
using testing::HasSubstr;

class Reliability : public Processes {
 protected:
  [[nodiscard]] int reliability(const std::string& scene, const std::string& options = "") const {
    std::ofstream(folder / "scene.toml") << scene;
    return shell(programs + "/blockweir reliability scene.toml --out r " + options);
  }
  [[nodiscard]] json answer() const { return json::parse(text("r/reliability.json")); }
};

constexpr double mouth_m = 15;

TEST_F(Reliability, TheHeadOfTheUpperCrackFollowsItsFormula) {
  const UncertainCrack crack;
  ASSERT_EQ(reliability(crack.scene() + "[reliability]\nlevel_m = 21.5\nsamples = 10000\nmethods = "
                                        "['form', 'sorm', 'importance', 'subset']\n"),
            0)
      << text("out");
  const json found = answer();
  const double exact = crack.below(6.5);
  EXPECT_NEAR(found["form"]["probability"].get<double>(), exact, 1e-4 * exact);
  EXPECT_NEAR(found["sorm"]["breitung"]["probability"].get<double>(), exact, 1e-4 * exact);
  for (const char* method : {"samples", "importance", "subset"}) {
    EXPECT_LE(found[method]["interval"][0], exact) << method;
    EXPECT_GE(found[method]["interval"][1], exact) << method;
  }
  EXPECT_LT(found["samples"]["lost_to_the_engine"], 0.1);
  std::istringstream rows(text("r/samples.csv"));
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "sample,friction,outcome,level_m,head_m,mode,joint,trouble");
  int count = 0;
  for (; std::getline(rows, row); ++count) {
    double sample = 0;
    double friction = 0;
    double level = 0;
    ASSERT_EQ(std::sscanf(row.c_str(), "%lf,%lf,fails,%lf", &sample, &friction, &level), 3) << row;
    EXPECT_NEAR(level - mouth_m, crack.head_m(friction, 0, crack.density_kg_per_m3[0]), 1e-9 * level) << row;
  }
  EXPECT_EQ(count, 10'000);
  for (const json& point : found["curve"]) {  // one ensemble is the whole curve
    const double p = crack.below(point["level_m"].get<double>() - mouth_m);
    EXPECT_NEAR(point["probability"].get<double>(), p, 4 * std::sqrt(p * (1 - p) / 10'000) + 1e-3);
  }
  EXPECT_TRUE(fs::exists(folder / "r/fragility.png"));
}

TEST_F(Reliability, WithCohesionAndDensityUncertainItAgreesWithAQuadrature) {
  const UncertainCrack crack{.cohesion_pa = {20e3, 4e3}, .density_kg_per_m3 = {1820, 60}};
  const double head_m = 8.5;
  const double exact = crack.below(head_m);
  // The interval holds it in 95 of 100 ensembles of samples: not in that of seed 1.
  for (const char* sampling : {"monte-carlo", "latin-hypercube", "quasi-random"}) {
    ASSERT_EQ(reliability(crack.scene() +
                          "[reliability]\nlevel_m = 23.5\nsamples = 1000\nseed = 2\nmethod_samples = "
                          "1000\nsampling = '" +
                          sampling + "'\nmethods = ['sorm', 'sobol']\n"),
              0)
        << text("out");
    const json found = answer();
    EXPECT_LE(found["samples"]["interval"][0], exact) << sampling;
    EXPECT_GE(found["samples"]["interval"][1], exact) << sampling;
    EXPECT_NEAR(found["sorm"]["breitung"]["probability"].get<double>(), exact, 0.01 * exact);
    const UncertainCrack::Indices indices = crack.indices();
    for (std::size_t k = 0; k < 3; ++k) {
      const double half = (found["sobol"]["first_to"][k].get<double>() - found["sobol"]["first_from"][k].get<double>());
      EXPECT_NEAR(found["sobol"]["first"][k].get<double>(), indices.first[k], half) << k;
      EXPECT_NEAR(found["sobol"]["total"][k].get<double>(), indices.total[k], half) << k;
    }
  }
  EXPECT_TRUE(fs::exists(folder / "r/sobol.png"));
}

TEST_F(Reliability, TheSamplesAreTheSameBitsForAnyNumberOfProcessesAndAfterAStop) {
  const std::string scene =
      UncertainCrack().scene() + "[reliability]\nlevel_m = 21.5\nsamples = 1000\nmethods = ['none']\n";
  ASSERT_EQ(reliability(scene, "--jobs 1"), 0) << text("out");
  const std::string one = text("r/samples.csv");
  fs::remove_all(folder / "r");
  std::ofstream(folder / "scene.toml") << scene;
  const pid_t stopped = start(programs +
                                  "/blockweir reliability scene.toml --out r --jobs 3 --set "
                                  "reliability.samples=100000",  // more than it can make before it is stopped
                              "stopped");
  while (text("r/samples.runs.jsonl").size() < 20'000) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ::kill(stopped, SIGKILL);
  EXPECT_EQ(end_of(stopped, 10), 128 + SIGKILL);
  for (int wait = 0; wait < 12'000 && orphan(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_FALSE(orphan());
  ASSERT_EQ(reliability(scene, "--jobs 3"), 0) << text("out");
  EXPECT_LT(answer()["samples"]["made"], 1000);
  EXPECT_EQ(text("r/samples.csv"), one);
}

TEST_F(Reliability, WholeRunsFindTheSameLevels) {
  const std::string scene = UncertainCrack().scene() + "[reliability]\nby = 'runs'\nlevel_m = 21.9\nsamples = 10\n";
  ASSERT_EQ(reliability(scene,
                        "--set 'water.upstream_level_m={table=[[0,20],[4,24]]}' --set analysis.duration_s=4 "
                        "--set analysis.stop_at_failure=true"),
            0)
      << text("out");
  std::istringstream rows(text("r/samples.csv"));
  std::string row;
  std::getline(rows, row);
  while (std::getline(rows, row)) {
    double sample = 0;
    double friction = 0;
    double level = 0;
    ASSERT_EQ(std::sscanf(row.c_str(), "%lf,%lf,fails,%lf", &sample, &friction, &level), 3) << row;
    EXPECT_NEAR(level - mouth_m, UncertainCrack().head_m(friction, 0, UncertainCrack().density_kg_per_m3[0]), 0.1)
        << row;
  }
  EXPECT_THAT(text("out"), HasSubstr("whole runs: "));
  EXPECT_THAT(text("out"), HasSubstr("limit analysis: "));
}

/// W d = rho g h^3/6 + rho g h B^2/2: the head at which the crack of Bouzey runs through.
double bouzey_head_m(double width_m, double density) {
  constexpr double crest_m = 4;
  constexpr double height_m = 10.5;
  const double area = height_m * (width_m + crest_m) / 2;
  const double moment = height_m * (width_m * width_m + width_m * crest_m + crest_m * crest_m) / 6;
  const double holds = density / 1000 * (area * width_m - moment);
  double head = 10;
  for (int i = 0; i < 20; ++i) {
    head -= (head * head * head / 6 + head * width_m * width_m / 2 - holds) / (head * head / 2 + width_m * width_m / 2);
  }
  return head;
}

TEST_F(Reliability, TheFragilityCurveOfBouzeyIsThatOfItsBands) {
  ASSERT_EQ(shell(programs + "/blockweir reliability " + cases +
                  "bouzey-1895 --out r --set reliability.samples=500 --set 'reliability.methods=[\"none\"]'"),
            0)
      << text("out");
  std::istringstream rows(text("r/samples.csv"));
  std::string row;
  std::getline(rows, row);
  while (std::getline(rows, row)) {
    double sample = 0;
    double width = 0;
    double density = 0;
    double level = 0;
    ASSERT_EQ(std::sscanf(row.c_str(), "%lf,%lf,%lf,fails,%lf", &sample, &width, &density, &level), 4) << row;
    EXPECT_NEAR(level, bouzey_head_m(width, density), 1e-6) << row;
  }
  const json found = answer();
  EXPECT_GT(found["samples"]["probability"], 0.98) << "at the level at which it failed";
  constexpr int points = 100;
  std::vector<double> heads;
  for (int i = 0; i < points * points; ++i) {
    heads.push_back(bouzey_head_m(5 + 0.6 * (i % points + 0.5) / points, 2000 + 200 * (i / points + 0.5) / points));
  }
  for (const json& point : found["curve"]) {
    const double level_m = point["level_m"];
    const auto count = std::count_if(heads.begin(), heads.end(), [&](double head) { return head <= level_m; });
    const double below = static_cast<double>(count) / (points * points);
    EXPECT_NEAR(point["probability"].get<double>(), below, 4 * std::sqrt(below * (1 - below) / 500) + 5e-3);
  }
}

TEST_F(Reliability, WhatCannotBeAnsweredIsTold) {
  EXPECT_EQ(shell(programs + "/blockweir reliability " + cases + "cracked-dam-upper --out r"), 2);
  EXPECT_THAT(text("out"), HasSubstr("found no [[random]]; expected one for each number that is uncertain"));
  const std::string scene = UncertainCrack().scene();
  EXPECT_EQ(reliability(scene + "[[random]]\nkey = 'joints.crack.cohesion_pa'\ndistribution = 'normal'\nmean = 1e3\n"
                                "deviation = 1e3\n"),
            2);
  EXPECT_THAT(text("out"), HasSubstr("[[random]] \"joints.crack.cohesion_pa\" sets joints.crack.cohesion_pa=-"));
  EXPECT_EQ(reliability(scene, "--batch 3"), 2);
  EXPECT_THAT(text("out"), HasSubstr("--batch and --sbatch are of --engine slurm"));
  EXPECT_EQ(
      reliability(UncertainCrack{.friction_deg = {50, 2}}.scene() + "[reliability]\nlevel_m = 40\nsamples = 50\n"), 2);
  EXPECT_THAT(text("out"), HasSubstr("samples that stand at 27 m, the highest level that is looked at"));
  EXPECT_EQ(reliability(scene + "[reliability]\nby = 'runs'\nlevel_m = 25\n"), 2);
  EXPECT_THAT(text("out"), HasSubstr("runs that do not end at that level"));
}

}  // namespace
}  // namespace blockweir::test::reliability_test
