// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// A user's own OpenFOAM case as the fluid: taken as it is, left as it was, and refused where it does not fit the scene.
#include "tests/openfoam.hpp"

namespace blockweir::test::openfoam_own_case_test {
namespace {

using testing::HasSubstr;

class OwnCase : public OpenFoam {
 protected:
  void SetUp() override {
    OpenFoam::SetUp();
    fs::copy(cases + "own-openfoam-case", folder / "scene", fs::copy_options::recursive);
  }
  [[nodiscard]] std::string contents(const std::string& name) const {
    EXPECT_EQ(shell("sh -c 'find " + name + " -type f | sort | xargs sha256sum'"), 0);
    return text("out");
  }
  void change(const std::string& command) const { ASSERT_EQ(shell("sh -c \"" + command + "\""), 0) << text("out"); }
  /// The run ends with status 1, and says so.
  void expect_refused(const std::string& what, const std::string& more = "") const {
    EXPECT_EQ(run("scene", "o", more), 1);
    EXPECT_THAT(text("out"), HasSubstr(what));
    EXPECT_FALSE(orphan());
  }
};

TEST_F(OwnCase, IsLeftAsItWas) {
  const std::string before = contents("scene");
  EXPECT_EQ(run("scene", "o", set("analysis.duration_s=0.02")), 0) << text("out");
  EXPECT_EQ(contents("scene"), before);
  EXPECT_THAT(text("o/openfoam/system/controlDict"), HasSubstr("sampling"));  // the user's own function object
  EXPECT_TRUE(fs::exists(folder / "o/openfoam/postProcessing/gauge"));
}

TEST_F(OwnCase, IsWrittenByTheCommandCase) {
  EXPECT_EQ(shell(programs + "/blockweir case scene --out c"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("a copy of scene/basin with the blocks"));
  for (const char* file : {"constant/blockweir", "system/fvOptions", "constant/polyMesh/points", "0/alpha.water"}) {
    EXPECT_TRUE(fs::exists(folder / "c" / file)) << file;
  }
}

/// Neither by a copy nor by a case that the scene has written.
TEST_F(OwnCase, IsNotOverwritten) {
  const std::string before = contents("scene/basin");
  for (const std::string& name : {std::string("scene"), cases + "cracked-dam-upper-openfoam"}) {
    EXPECT_EQ(shell(programs + "/blockweir case " + name + " --out scene/basin"), 2);
    EXPECT_THAT(text("out"), HasSubstr("scene/basin: not empty and not a case that blockweir has written; choose"));
    EXPECT_EQ(contents("scene/basin"), before);
  }
  EXPECT_EQ(shell(programs + "/blockweir case scene --out c"), 0);
  EXPECT_EQ(shell(programs + "/blockweir case scene --out c"), 0) << text("out");
}

/// By a slip of 1 cm, for which 1 s is long enough.
TEST_F(OwnCase, FailsAtTheHeadOfTheCaseThatTheSceneWrites) {
  const std::string scene = cases + "cracked-dam-upper-openfoam" + set("analysis.duration_s=1") +
                            set("analysis.failure_displacement_m=0.01") +
                            set("water.upstream_level_m={table=[[0,21.9],[1,22.4]]}");
  EXPECT_EQ(shell(programs + "/blockweir run " + scene + set("fluid.cells_in_depth=10") + " --quiet --out written"), 0)
      << text("out");
  EXPECT_EQ(shell(programs + "/blockweir case " + scene + set("fluid.cells_in_depth=10") + " --out mine"), 0);
  // As if it had never heard of blocks, and with another solver.
  change(
      "cd mine && rm constant/blockweir system/fvOptions grid.json && sed -i '/^libs/d; /^functions/,\\$d' "
      "system/controlDict && sed -i 's/solver GAMG/solver PCG/; s/smoother DIC/preconditioner DIC/' system/fvSolution");
  EXPECT_EQ(
      shell(programs + "/blockweir run " + scene +
            set("fluid={model=\"openfoam\",case=\"" + (folder / "mine").string() + "\",level_control=\"table\"}") +
            " --quiet --out own"),
      0)
      << text("out");
  EXPECT_THAT(text("own/openfoam/log.interFoam"), HasSubstr("DICPCG:  Solving for p_rgh"));
  const auto head = [&](const std::string& out) {
    return nlohmann::json::parse(text(out + "/summary.json"))["failure"]["head_m"].get<double>();
  };
  EXPECT_NEAR(head("own") / head("written"), 1, 1e-3);
}

/// Two blocks that rise together, one on the other, fill what the one leaves of a cell and the other enters.
TEST_F(OwnCase, HasInItsCellsWhatTheMovingBlocksFillTogether) {
  change("sed -i 's/simpleGrading.*/simpleGrading (1 1 1)/' scene/basin/system/blockMeshDict");
  std::ofstream(folder / "scene/scene.toml", std::ios::app)
      << "[[block]]\nname = \"hat\"\nmaterial = \"concrete\"\ninitial_velocity_m_per_s = [0, 3]\n"
         "vertices_m = [[6, 10.6], [7, 10.6], [7, 11.4], [6, 11.4]]\n";
  EXPECT_EQ(run("scene", "o",
                set("analysis.duration_s=0.1") + set("block.rider.initial_velocity_m_per_s=[0,3]") +
                    set("block.rider.vertices_m=[[6,10],[7,10],[7,10.6],[6,10.6]]")),
            0)
      << text("out");
  std::istringstream field(text("o/openfoam/0.09/blocks"));
  std::string word;
  while (field >> word && word != "nonuniform") {
  }
  std::size_t cells = 0;
  field >> word >> cells >> word;
  double filled = 0;
  for (double f = 0; cells > 0 && field >> f; --cells) filled += f;
  EXPECT_EQ(cells, 0U);
  EXPECT_NEAR(filled * 0.5 * 12 / 22, 8 * 10 + 1.4, 1e-4);  // cells of wall and blocks are all of one size
}

TEST_F(OwnCase, OnTwoProcessesFeelsTheSame) {
  EXPECT_EQ(run("scene", "one", set("analysis.duration_s=0.1")), 0) << text("out");
  EXPECT_EQ(run("scene", "two", set("analysis.duration_s=0.1") + set("fluid.processes=2")), 0) << text("out");
  EXPECT_NEAR(got("two", "water_force_x_n_per_m") / got("one", "water_force_x_n_per_m"), 1, 1e-6);
}

TEST_F(OwnCase, RefusesAFolderThatIsNotThere) {
  expect_refused("scene/nowhere: there is no such folder", set("fluid.case=nowhere"));
}

TEST_F(OwnCase, RefusesAFolderWithoutAControlDictionary) {
  change("rm scene/basin/system/controlDict");
  expect_refused("it has no system/controlDict");
}

TEST_F(OwnCase, RefusesAnotherSolver) {
  change("sed -i 's/application.*/application pimpleFoam;/' scene/basin/system/controlDict");
  expect_refused("its system/controlDict has application pimpleFoam; interFoam is the one that takes blocks");
}

TEST_F(OwnCase, RefusesAFolderWithoutAMesh) {
  change("rm scene/basin/system/blockMeshDict");
  expect_refused("it has neither constant/polyMesh nor system/blockMeshDict");
}

TEST_F(OwnCase, RefusesFieldsWithoutWater) {
  change("mv scene/basin/0.orig/alpha.water scene/basin/0.orig/alpha.oil");
  expect_refused("it has no 0.orig/alpha.water");
}

TEST_F(OwnCase, RefusesAMeshOfMoreThanOneCellAcross) {
  change("sed -i 's/22 1) simple/22 2) simple/' scene/basin/system/blockMeshDict");
  expect_refused("the mesh is not one cell thick between patches of type empty");
}

TEST_F(OwnCase, RefusesAnotherDensityOfWater) {
  change("sed -i 's/rho 1000/rho 1025/' scene/basin/constant/transportProperties");
  expect_refused("water density: constant/transportProperties has 1025 kg/m3, the scene 1000;");
}

TEST_F(OwnCase, RefusesAnotherGravity) {
  expect_refused("gravity: constant/g has (0 -9.81 0) m/s2, the scene (0 -9.8 0);",
                 set("analysis.gravity_m_per_s2=9.8"));
}

TEST_F(OwnCase, RefusesALevelByTableThatTheCaseDoesNotStartWith) {
  expect_refused(" m, upstream_level_m at time 0 is 9 m; make them the same",
                 set("fluid.level_control=table") + set("water.upstream_level_m=9"));
}

TEST_F(OwnCase, RefusesWaterThatIsNotAtItsPressure) {
  change("rm scene/basin/constant/hRef");
  expect_refused("write the still-water level into constant/hRef");
}

TEST_F(OwnCase, RefusesBlocksOutsideOfItsMesh) {
  change(
      "sed -i 's/vertices_m = \\[\\[6, 10\\], \\[7, 10\\], \\[7, 11\\], \\[6, 11\\]\\]/vertices_m = [[6, 10], [7, "
      "10], [7, 13], [6, 13]]/' scene/scene.toml");
  expect_refused("widen the case's mesh");
}

TEST_F(OwnCase, RefusesToBeCopiedIntoItself) {
  EXPECT_EQ(shell(programs + "/blockweir case scene --out scene/basin/copy"), 2);
  EXPECT_THAT(text("out"), HasSubstr("lie within each other"));
}

}  // namespace
}  // namespace blockweir::test::openfoam_own_case_test
