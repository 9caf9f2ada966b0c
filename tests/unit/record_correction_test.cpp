// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Baselines and filters of records against closed forms, and what the reader says of records that have none.
#include "bridge/scene/read/record_correction.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene::record_correction_test {
namespace {

using sample::expect_error;
using testing::HasSubstr;
using RecordFile = sample::SceneFolder;

constexpr double two_pi = 2 * std::numbers::pi;

TimeTable rows_of(double step_s, int steps, const std::function<double(double)>& value) {
  TimeTable record;
  for (int i = 0; i <= steps; ++i) {
    record.time_s.push_back(step_s * i);
    record.value.push_back(value(step_s * i));
  }
  return record;
}

TEST(RecordCorrection, ARecordThatIsItsBaselineAloneBecomesZero) {
  const TimeTable drift = rows_of(0.01, 1000, [](double t) { return 0.3 - 0.2 * t + 0.05 * t * t; });
  for (const double value : corrected(drift, {.baseline_terms = 3}).value) EXPECT_NEAR(value, 0, 1e-11);
}

/// sin on whole periods has no final velocity: the constant that is taken out is the one that was added.
TEST(RecordCorrection, AConstantIsTheFinalVelocityOverTheTime) {
  const auto wave = [](double t) { return 2 * std::sin(two_pi * t); };
  const TimeTable shifted = rows_of(0.001, 10'000, [&](double t) { return wave(t) + 0.25; });
  const TimeTable mended = corrected(shifted, {.baseline_terms = 1});
  for (std::size_t i = 0; i + 1 < mended.value.size(); i += 100)
    EXPECT_NEAR(mended.value[i], wave(mended.time_s[i]), 1e-12);
  EXPECT_EQ(mended.time_s.back(), 10.001);
  EXPECT_EQ(mended.value.back(), 0);
}

/// After a unit velocity from the start the line that stops it at T = 1 leaves v = 1 - t^2 + a0 (t - t^2), whose square
/// has its least integral at a0 = -7/2; the line is then a0 - 2 (1 + a0) t.
TEST(RecordCorrection, ALineLeavesTheSmallestVelocity) {
  TimeTable kick = rows_of(1e-4, 10'000, [](double) { return 0.0; });
  kick.value[0] = 2e4;  // a triangle of area 1 in the first step
  const TimeTable mended = corrected(kick, {.baseline_terms = 2});
  EXPECT_NEAR(mended.value[1], -3.5, 5e-3);
  EXPECT_NEAR(mended.value[10'000], -3.5 + 5, 5e-3);
}

TEST(RecordCorrection, TheGroundStopsWhateverTheRecord) {
  const TimeTable rough = rows_of(0.005, 2000, [](double t) { return std::sin(17 * t) * std::exp(-t / 4) + 0.02 * t; });
  EXPECT_GT(std::abs(ground_end(rough).velocity), 0.5);
  for (int terms = 1; terms <= 3; ++terms) {
    for (const std::optional<double> low : {std::optional<double>(), std::optional(0.2)}) {
      const GroundEnd end = ground_end(corrected(rough, {.baseline_terms = terms, .highpass_hz = low}));
      EXPECT_NEAR(end.velocity, 0, 1e-12) << terms;
      if (terms > 1) EXPECT_LT(std::abs(end.displacement), 0.5) << terms;
    }
  }
}

/// Where the ends do not reach, a wave keeps its phase, and its amplitude is multiplied by the filter's gain.
TEST(RecordCorrection, AFilterMultipliesByButterworthsGainAndDelaysNothing) {
  for (const double frequency : {0.5, 1.0, 2.0, 4.0, 6.0}) {
    const TimeTable wave = rows_of(0.01, 6000, [&](double t) { return std::sin(two_pi * frequency * t); });
    const TimeTable low = corrected(wave, {.lowpass_hz = 4});
    const TimeTable high = corrected(wave, {.highpass_hz = 1});
    for (std::size_t i = 2900; i < 3100; ++i) {
      EXPECT_NEAR(low.value[i], wave.value[i] / (1 + std::pow(frequency / 4, 8)), 2e-5) << frequency;
      EXPECT_NEAR(high.value[i], wave.value[i] / (1 + std::pow(1 / frequency, 8)), 2e-5) << frequency;
    }
  }
}

TEST(RecordCorrection, RowsMayBeRoundedButNotUneven) {
  EXPECT_TRUE(equal_steps({.time_s = {0, 0.0333, 0.0667, 0.1}, .value = {0, 1, 2, 0}}));
  EXPECT_FALSE(equal_steps({.time_s = {0, 0.03, 0.07, 0.1}, .value = {0, 1, 2, 0}}));
}

std::string shaken(const std::string& keys, const std::string& rows = "[0, 1], [0.1, 2], [0.2, 0], [0.3, 1]") {
  return sample::text + "[base_motion]\n" + keys + "\nacceleration_x_m_per_s2 = { table = [" + rows + "] }\n";
}

TEST(RecordCorrection, AGapIsSeenWhereRowsAreElseEquallyFarApart) {
  TimeTable record{{}, {}};
  for (int i = 0; i < 100; ++i) {
    record.time_s.push_back(0.01 * i);
    record.value.push_back(std::sin(0.3 * i));
  }
  EXPECT_FALSE(row_before_gap(record));
  record.time_s.back() = 5;  // a last row may be far off
  EXPECT_FALSE(row_before_gap(record));
  TimeTable gap = record;
  gap.time_s.erase(gap.time_s.begin() + 49);
  gap.value.erase(gap.value.begin() + 49);
  EXPECT_EQ(row_before_gap(gap), 48U);
  gap.value[48] = gap.value[49] = 0;  // the ground is still
  EXPECT_FALSE(row_before_gap(gap));
  gap.value[48] = 1;
  for (double& time_s : gap.time_s) time_s *= time_s;  // no two steps are alike
  EXPECT_FALSE(row_before_gap(gap));
}

TEST(RecordCorrection, TheSceneHasTheCorrectedRowsAndSaysWhatChanged) {
  const Scene raw = read_text(shaken(""), "s.toml").scene;
  EXPECT_EQ(raw.base_motion->correction, "");
  EXPECT_EQ(raw.base_motion->acceleration_x_m_per_s2.value.size(), 4U);
  const Scene scene = read_text(shaken("baseline = \"linear\""), "s.toml").scene;
  EXPECT_EQ(scene.base_motion->acceleration_x_m_per_s2.value.size(), 5U);
  EXPECT_NEAR(ground_end(scene.base_motion->acceleration_x_m_per_s2).velocity, 0, 1e-14);
  EXPECT_THAT(scene.base_motion->correction,
              HasSubstr("baseline linear; acceleration_x_m_per_s2: final velocity 0.3 to "));
  EXPECT_THAT(read_text(shaken("highpass_hz = 4\nlowpass_hz = 5"), "s.toml").scene.base_motion->correction,
              HasSubstr("baseline none, high-pass 4 Hz, low-pass 5 Hz; "));
}

TEST(RecordCorrection, WhatCannotBeCorrectedIsRefused) {
  expect_error(sample::text + "[base_motion]\nbaseline = \"linear\"\nacceleration_x_m_per_s2 = 3\n", 58,
               {"is no record that a baseline or filter can be taken from", "three rows or more"});
  expect_error(shaken("baseline = \"linear\"", "[0.1, 1], [0.2, 2], [0.3, 0]"), 58, {"the first at time 0"});
  expect_error(shaken("baseline = \"cubic\""), 57, {"one of none, constant, linear, quadratic"});
  expect_error(shaken("lowpass_hz = 6"), 57, {"show nothing above 5 Hz", "lower lowpass_hz"});
  expect_error(shaken("highpass_hz = 1"), 57, {"a period longer than the record of 0.3 s", "at least 3.33 Hz"});
  expect_error(shaken("highpass_hz = 4\nlowpass_hz = 4"), 57, {"highpass_hz below lowpass_hz"});
  expect_error(shaken("lowpass_hz = 4", "[0, 1], [0.1, 2], [0.25, 0]"), 58, {"not equally far apart"});
  expect_error(shaken("lowpass_hz = 0"), 57, {"a number above 0"});
  std::string rows = "[0, 0]";
  for (int i = 1; i < 16; ++i) rows += i == 9 ? "" : fmt::format(", [{:.1f}, {}]", 0.1 * i, i % 3);
  expect_error(shaken("", rows), 58,
               {"acceleration_x_m_per_s2 in [base_motion] has a gap after row 9, from 0.8 to 1 s", "fill in the rows"});
}

/// A remark and a heading stand above the rows of a file.
TEST_F(RecordFile, AGapIsNamedByTheLineOfItsFile) {
  std::string rows = "# synthetic\ntime_s,a\n";
  for (int i = 0; i < 16; ++i) rows += i == 9 ? "" : fmt::format("{:.1f},{}\n", 0.1 * i, i % 3);
  (void)write("r.csv", rows);
  EXPECT_THAT(error(write("s.toml", sample::text + "[base_motion]\nacceleration_x_m_per_s2 = { file = 'r.csv' }\n")),
              HasSubstr("acceleration_x_m_per_s2 in [base_motion] has a gap after line 11 of r.csv, from 0.8 to 1 s"));
}

}  // namespace
}  // namespace blockweir::scene::record_correction_test
