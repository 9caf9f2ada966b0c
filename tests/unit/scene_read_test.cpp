// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// What a sound scene says is what is read, with its defaults; and files that cannot be read.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/read/nearest.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_read_test {
using namespace blockweir::scene;
using sample::text;
using sample::with;
using testing::HasSubstr;

namespace {

Scene scene_of(const std::string& scene) {
  return read_text(scene, "s.toml").scene;
}

TEST(SceneRead, EveryValueArrives) {
  const Scene s = scene_of(text);
  EXPECT_EQ(s.file, "s.toml");
  EXPECT_EQ(s.title, "sample");
  EXPECT_EQ(s.note, "made up");
  EXPECT_EQ(s.analysis.duration_s, 2.0);
  EXPECT_EQ(s.contact.max_iterations, 100);
  ASSERT_EQ(s.materials.size(), 1u);
  EXPECT_EQ(s.materials[0].name, "concrete");
  EXPECT_EQ(s.materials[0].youngs_modulus_pa, 50e9);
  EXPECT_EQ(s.materials[0].poissons_ratio, 0.2);
  EXPECT_EQ(s.materials[0].density_kg_per_m3, 2500);
  ASSERT_EQ(s.blocks.size(), 3u);
  EXPECT_TRUE(s.blocks[0].fixed);
  EXPECT_EQ(s.blocks[2].name, "top");
  EXPECT_EQ(s.blocks[2].vertices[2], Point(3, 4));
  EXPECT_EQ(s.blocks[2].line, 23);
  ASSERT_EQ(s.joints.size(), 1u);
  EXPECT_EQ(s.joints[0].between, (std::array{1, 2}));
  EXPECT_EQ(s.joints[0].law.cohesion_pa, 1e5);
  EXPECT_EQ(s.supports[0].block, 1);
  EXPECT_EQ(s.supports[0].displacement_x_m->at(1), 0);
  EXPECT_FALSE(s.supports[0].displacement_y_m);
  EXPECT_EQ(s.point_loads[0].force_x_n_per_m.at(0), 100);
  EXPECT_EQ(s.point_loads[0].force_y_n_per_m.at(0), -200);
  EXPECT_EQ(s.face_pressures[0].pressure_from_pa.at(0), 1000);
  EXPECT_EQ(s.face_pressures[0].pressure_to_pa.at(0), 1000);
  EXPECT_EQ(s.water.upstream_level_m->at(1), 2);
  EXPECT_EQ(s.fluid, FluidModel::hydrostatic);
  EXPECT_EQ(s.coupling.window_s, 0.02);
  EXPECT_EQ(s.output.frame_every_s, 0.5);
  EXPECT_EQ(s.expectations[0].of, "crack");
  EXPECT_EQ(s.expectations[0].value, 1.0);
}

TEST(SceneRead, AbsentSectionsTakeTheirDefaults) {
  const Scene s = scene_of(text.substr(0, text.find("[[joints]]")));
  EXPECT_EQ(s.fluid, FluidModel::none);
  EXPECT_EQ(s.coupling.window_s, s.analysis.step_s);
  EXPECT_TRUE(s.coupling.added_mass_guard);
  EXPECT_EQ(s.contact.force_tolerance, Contact{}.force_tolerance);
  EXPECT_TRUE(s.joints.empty());
}

TEST(SceneRead, WordsBecomeTheirMeaning) {
  const Scene s = scene_of(with("step_s = 0.01",
                                "kind = \"quasi-static\"\nintegrator = \"trapezoidal\"\nplane = \"stress\"\n"
                                "start = \"unstressed\"\nstop_at_failure = true",
                                with("[water]", "[water]\natmosphere = \"wet-faces\"\nnodal_rule = \"lumped\"")));
  EXPECT_EQ(s.analysis.kind, AnalysisKind::quasi_static);
  EXPECT_EQ(s.analysis.integrator, Integrator::trapezoidal);
  EXPECT_EQ(s.analysis.plane, Plane::stress);
  EXPECT_EQ(s.analysis.start, Start::unstressed);
  EXPECT_TRUE(s.analysis.stop_at_failure);
  EXPECT_EQ(s.water.atmosphere, Atmosphere::wet_faces);
  EXPECT_EQ(s.water.nodal_rule, NodalRule::lumped);
}

TEST(SceneRead, AJointFollowsTheDefaultLawWhereItSaysNothing) {
  const Scene s = scene_of(with("friction_angle_deg = 30", "friction_angle_deg = 35\nuplift = \"full\""));
  EXPECT_EQ(s.joints[0].law.friction_angle_deg, 35);
  EXPECT_EQ(s.joints[0].law.uplift, Uplift::full);
}

TEST(SceneRead, TheResidualAngleIsThePeakAngleUnlessStated) {
  EXPECT_EQ(scene_of(with("cohesion_pa = 1e5", "friction_angle_deg = 20")).joints[0].law.residual_friction_angle_deg,
            20);
  const std::string stated =
      with("friction_angle_deg = 30", "friction_angle_deg = 30\nresidual_friction_angle_deg = 18");
  EXPECT_EQ(
      scene_of(with("cohesion_pa = 1e5", "friction_angle_deg = 20", stated)).joints[0].law.residual_friction_angle_deg,
      18);
}

using SceneFile = sample::SceneFolder;

TEST_F(SceneFile, IsGivenAsAFileOrAsItsFolder) {
  const auto file = write("scene.toml", text);
  EXPECT_EQ(read(file).scene.text, text);
  EXPECT_EQ(read(folder_).scene.file, file);
}

TEST_F(SceneFile, ThatIsNotThereIsRefused) {
  EXPECT_THAT(error(folder_ / "no.toml"), HasSubstr("no.toml: error: there is no such file; expected a scene file"));
}

TEST_F(SceneFile, AFolderWithoutASceneIsRefused) {
  EXPECT_THAT(error(folder_), HasSubstr("scene.toml: error: there is no such file; expected a scene file, or a folder "
                                        "that holds scene.toml"));
}

TEST_F(SceneFile, WhatIsNoFileIsRefused) {
  const auto pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(error(pipe), HasSubstr("pipe: error: this is not a file"));
}

TEST_F(SceneFile, ThatMayNotBeReadIsRefused) {
  const auto file = write("secret.toml", text);
  std::filesystem::permissions(file, std::filesystem::perms::none);
  const uid_t user = geteuid();
  constexpr uid_t nobody = 65534;
  if (user == 0) {  // root may read everything
    ASSERT_EQ(seteuid(nobody), 0);
  }
  const std::string said = error(file);
  ASSERT_EQ(seteuid(user), 0);
  EXPECT_THAT(said, HasSubstr("secret.toml: error: the file cannot be read; "));
}

TEST_F(SceneFile, OfMoreThan16MegabytesIsRefused) {
  const auto file = write("large.toml", "#");
  std::filesystem::resize_file(file, (16U << 20U) + 1);
  EXPECT_THAT(error(file), HasSubstr("large.toml: error: the file is larger than 16 MB"));
}

TEST_F(SceneFile, ThatIsNotTextIsRefused) {
  EXPECT_THAT(error(write("binary.toml", "\x7f\x45LF\x01\xff\xfe")),
              HasSubstr("binary.toml:1: error: a byte 0xff that is no character; expected text in UTF-8"));
}

TEST_F(SceneFile, InAnotherEncodingSaysHowToSaveIt) {
  EXPECT_THAT(error(write("latin1.toml", "title = 'x'\nnote = 'H\xf6he'\n")),
              HasSubstr("latin1.toml:2: error: a byte 0xf6 that is no character; expected text in UTF-8; save the file "
                        "as UTF-8"));
  EXPECT_THAT(error(write("utf16.toml", std::string("\xff\xfet\0i\0", 6))),
              HasSubstr("utf16.toml:1: error: text in UTF-16; expected text in UTF-8; save the file as UTF-8"));
  EXPECT_THAT(error(write("utf16-without-a-mark.toml", std::string("t\0i\0", 4))), HasSubstr("save the file as UTF-8"));
  EXPECT_EQ(read(write("utf8.toml", "\xef\xbb\xbf" + text + "# H\xc3\xb6he \xe5\xa0\xb0\n")).scene.title, "sample");
}

TEST_F(SceneFile, WarningsStandBesideErrors) {
  const std::string wrong =
      with("youngs_modulus_pa = 50e9\npoissons_ratio = 0.2", "youngs_modulus_pa = 50\npoissons_ratio = 20");
  try {
    read_text(wrong, "s.toml");
    FAIL() << "Poisson's ratio of 20 was read";
  } catch (const SceneError& error) {
    ASSERT_EQ(error.diagnostics().size(), 2U) << error.what();
    EXPECT_THAT(error.diagnostics()[0].text(), HasSubstr("error: poissons_ratio"));
    EXPECT_THAT(error.diagnostics()[1].text(),
                testing::AllOf(HasSubstr("warning: youngs_modulus_pa"), HasSubstr("if it is in GPa, write 50e9")));
  }
}

TEST_F(SceneFile, AVariantSetsItsKeysAndTheCommandLineItsOwnOverThem) {
  const auto file = write("v.toml", text + R"([[variant]]
name = "slow"
set = ["analysis.duration_s=9", "analysis.step_s=0.02"]
)");
  EXPECT_EQ(read(file).scene.analysis.duration_s, 2.0);
  const Scene slow = read_variant(file, "slow", {"analysis.step_s=0.03"}).scene;
  EXPECT_EQ(slow.analysis.duration_s, 9.0);
  EXPECT_EQ(slow.analysis.step_s, 0.03);
  EXPECT_EQ(read_variant(file, "").scene, read(file).scene);
  try {
    read_variant(file, "slwo");
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(), HasSubstr("there is no variant \"slwo\"; expected one of slow; did you mean \"slow\"?"));
  }
}

TEST(SceneCases, OfTheRepositoryAreSound) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(BLOCKWEIR_SOURCE "/cases")) {
    if (!entry.is_directory() || !std::filesystem::exists(entry.path() / "scene.toml")) continue;
    EXPECT_NO_THROW({
      for (const Variant& variant : read(entry.path()).scene.variants) read_variant(entry.path(), variant.name);
    }) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 0);
}

TEST(Nearest, FindsWhatWasProbablyMeant) {
  const std::vector<std::string> words{"run", "check", "validate", "plot"};
  EXPECT_EQ(nearest("rnu", words), "run");
  EXPECT_EQ(nearest("chek", words), "check");
  EXPECT_EQ(nearest("vladiate", words), "validate");
  EXPECT_EQ(nearest("zebra", words), "");
  EXPECT_EQ(nearest("", words), "");
  EXPECT_EQ(nearest("run", {}), "");
}

TEST(Nearest, NamesThatHoldACommaStandInQuotationMarks) {
  EXPECT_EQ(one_of({"run", "check"}), "one of run, check");
  EXPECT_EQ(one_of({"crack", "crack, downstream half"}), "one of \"crack\", \"crack, downstream half\"");
}

TEST(Polygon, AreaAndCentroidKeepTheirDigitsFarAway) {
  const std::vector<Point> square{{1e6, 1e6}, {1e6 + 2, 1e6}, {1e6 + 2, 1e6 + 1}, {1e6, 1e6 + 1}};
  EXPECT_EQ(geometry::signed_area(square), 2);
  EXPECT_EQ(geometry::centroid(square), Point(1e6 + 1, 1e6 + 0.5));
  const std::vector<Point> top{{0, 15}, {9.4175, 11.6361}, {4, 22}, {0, 22}};  // the upper crack's block
  EXPECT_NEAR(geometry::signed_area(top), 53.69, 0.005);
  EXPECT_NEAR(geometry::centroid(top).x(), 3.654, 5e-4);
  EXPECT_NEAR(geometry::centroid(top).y(), 17.113, 5e-4);
}

}  // namespace
}  // namespace blockweir::scene_read_test
