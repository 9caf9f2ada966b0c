// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// What is wrong with settings that a scene states itself: told at the file and line of the entry that states them.
#include "bridge/scene/read/collected_errors.hpp"
#include "bridge/scene/read/entry.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_entry_test {
namespace {

using namespace blockweir::scene;

class SceneEntries : public sample::SceneFolder {
 protected:
  /// The sample with a variant at line 56.
  [[nodiscard]] std::filesystem::path with_variant(const std::string& set) const {
    return write("s.toml", sample::text + "[[variant]]\nname = 'v'\nset = [" + set + "]\n");
  }
  static std::string error_of_variant(const std::filesystem::path& file,
                                      const std::vector<std::string>& overrides = {}) {
    CollectedErrors wrong;
    wrong.from([&] { read_variant(file, "v", overrides); });
    try {
      wrong.report();
    } catch (const SceneError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(SceneEntries, AWrongKeyOfAVariantIsToldAtItsLine) {
  EXPECT_THAT(error_of_variant(with_variant("'analysis.stp_s=0.1'")),
              testing::AllOf(testing::HasSubstr("s.toml:56: error: [[variant]] \"v\" sets analysis.stp_s=0.1: unknown "
                                                "key \"stp_s\" in [analysis]"),
                             testing::HasSubstr("did you mean \"step_s\"?")));
}

TEST_F(SceneEntries, ASettingThatNamesNoKeyIsToldAtItsLine) {
  EXPECT_THAT(error_of_variant(with_variant("'nokey'")),
              testing::HasSubstr("s.toml:56: error: [[variant]] \"v\" sets nokey: this gives no value"));
  EXPECT_THAT(error_of_variant(with_variant("'=3'")),
              testing::HasSubstr("s.toml:56: error: [[variant]] \"v\" sets =3: this names no key"));
}

TEST_F(SceneEntries, TheRemedyOfWhatAVariantSetsDoesNotSpeakOfTheCommandLine) {
  for (const char* set :
       {"'nokey'", "'=3'", "'analysis..step_s=1'", "'analysis.step_s.x=1'", "'block.none.fixed=true'"}) {
    EXPECT_THAT(error_of_variant(with_variant(set)),
                testing::AllOf(testing::HasSubstr("s.toml:56: error: "), testing::Not(testing::HasSubstr("--set"))))
        << set;
  }
}

/// A key that is wrong is so with each of a study's values; values that are wrong are each told.
TEST_F(SceneEntries, AKeyThatIsWrongWithSeveralValuesIsToldOnce) {
  const auto file = write("s.toml", sample::text);
  const auto errors_with = [&](const std::string& key) {
    CollectedErrors wrong;
    for (const char* value : {"=-1", "=-2", "=-3"}) {
      wrong.from([&] { read_entry(file, {"[[study]] \"s\"", 56, {key + value}}, {key + value}); });
    }
    try {
      wrong.report();
    } catch (const SceneError& error) {
      return error.diagnostics().size();
    }
    return std::size_t{0};
  };
  EXPECT_EQ(errors_with("analysis.stp_s"), 1U);
  EXPECT_EQ(errors_with("anlysis.step_s"), 1U);
  EXPECT_EQ(errors_with("analysis.step_s"), 3U);
}

TEST_F(SceneEntries, WhatAVariantMakesWrongElsewhereNamesTheVariantToo) {
  EXPECT_THAT(error_of_variant(with_variant("'analysis.duration_s=0.015'")),
              testing::ContainsRegex("s.toml:[0-9]+: error: with \\[\\[variant\\]\\] \"v\": "));
}

TEST_F(SceneEntries, WhatTheCommandLineSetsOverAVariantStaysItsOwn) {
  EXPECT_THAT(error_of_variant(with_variant("'analysis.step_s=0.1'"), {"analysis.stp_s=1"}),
              testing::StartsWith("--set analysis.stp_s=1: error: "));
}

TEST_F(SceneEntries, AWarningOfWhatAVariantSetsIsToldAtItsLine) {
  const auto read = read_variant(with_variant("'analysis.gravity_m_per_s2=10.1'"), "v");
  ASSERT_THAT(read.warnings, testing::SizeIs(1));
  EXPECT_EQ(read.warnings[0].line, 56);
}

TEST_F(SceneEntries, AVariantIsOneSceneWithoutVariantsAndStudies) {
  const auto file = write("s.toml", sample::text +
                                        "[[variant]]\nname = 'v'\nset = ['analysis.step_s=0.02']\n[[bench]]\nname = "
                                        "'b'\nkey = 'analysis.step_s'\nvalues = [0.01, 0.02]\n");
  EXPECT_THAT(read(file).scene.variants, testing::SizeIs(1));
  const Scene scene = read_variant(file, "v").scene;
  EXPECT_THAT(scene.variants, testing::IsEmpty());
  EXPECT_THAT(scene.studies.benches, testing::IsEmpty());
  EXPECT_THAT(scene.text, testing::Not(testing::AnyOf(testing::HasSubstr("variant"), testing::HasSubstr("bench"))));
  EXPECT_EQ(read_text(scene.text, "v.toml").scene.analysis.step_s, 0.02);
}

TEST_F(SceneEntries, AVariantCannotSetVariantsAndStudies) {
  for (const char* set : {"variant.0.name='w'", "bench.0.key='x'", "study.a.set=[]", "bench_motion.until_s=1"}) {
    try {
      read(with_variant(std::string("\"") + set + "\""));
      ADD_FAILURE() << set;
    } catch (const SceneError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("s.toml:58: error: [[variant]] \"v\" sets \"" + std::string(set) +
                                                   "\"; expected keys of the scene itself"));
    }
  }
}

TEST_F(SceneEntries, TheCommandLineCannotSetVariantsOfAVariant) {
  const auto file = with_variant("'analysis.step_s=0.02'");
  EXPECT_THAT(error_of_variant(file, {"variant.v.set=[]"}),
              testing::HasSubstr("--set variant.v.set=[]: error: this changes the file's variants and studies"));
  EXPECT_NO_THROW(read(file, {"variant.v.set=[\"analysis.step_s=0.03\"]"}));
}

TEST_F(SceneEntries, AStudyCannotVaryVariantsAndStudies) {
  const auto file =
      write("s.toml", sample::text + "[[bench]]\nname = 'b'\nkey = 'variant.0.name'\nvalues = ['u', 'w']\n");
  try {
    read(file);
    ADD_FAILURE();
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr("s.toml:57: error: [[bench]] \"b\" varies \"variant.0.name\"; expected "
                                   "keys of the scene itself, not of its variants and studies"));
  }
}

TEST_F(SceneEntries, ErrorsOfSeveralReadingsAreGatheredEachOnce) {
  const auto file = with_variant("'nokey'");
  CollectedErrors wrong;
  for (int i = 0; i < 2; ++i) wrong.from([&] { read_variant(file, "v"); });
  wrong.from([&] { read(file, {"other"}); });
  try {
    wrong.report();
    FAIL() << "errors were expected";
  } catch (const SceneError& error) {
    EXPECT_THAT(error.diagnostics(), testing::SizeIs(2));
  }
}

}  // namespace
}  // namespace blockweir::scene_entry_test
