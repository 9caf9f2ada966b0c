// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_checkpoint bridge_schedule
// State comes back as it was; files that are no checkpoint of this run are refused by name; windows grow and shrink.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/checkpoint/checkpoints.hpp"
#include "bridge/schedule/windows.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::checkpoint_test {
namespace {

namespace fs = std::filesystem;
using checkpoint::Checkpoints;
using testing::HasSubstr;

TEST(Archive, GivesBackWhatItTook) {
  const std::vector<Eigen::Vector3d> vectors{{1, 2, 3}, {-0.0, 1e-300, 5}};
  const std::map<int, std::optional<std::string>> names{{1, "one"}, {2, std::nullopt}};
  std::vector<Eigen::Vector3d> vectors_back;
  std::map<int, std::optional<std::string>> names_back;
  const std::string bytes = checkpoint::pack(vectors, names);
  checkpoint::unpack(bytes, vectors_back, names_back);
  EXPECT_EQ(vectors, vectors_back);
  EXPECT_EQ(names, names_back);
  EXPECT_THROW(checkpoint::unpack(bytes.substr(0, bytes.size() - 1), vectors_back, names_back), cereal::Exception);
}

class Files : public test::OwnFolder {
 protected:
  static std::string refusal(const Checkpoints& checkpoints, std::uint64_t window) {
    try {
      static_cast<void>(checkpoints.read(window));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(Files, TheLastTwoAreKept) {
  Checkpoints checkpoints(folder, "solid", "abc", 0);
  for (const int window : {3, 20, 100}) checkpoints.write(static_cast<std::uint64_t>(window), std::to_string(window));
  EXPECT_EQ(checkpoint::windows(folder, "solid"), (std::vector<std::uint64_t>{20, 100}));
  EXPECT_EQ(checkpoints.read(100), "100");
  EXPECT_TRUE(checkpoint::windows(folder, "other").empty());
  EXPECT_FALSE(checkpoints.due());
  checkpoint::forget(folder);
  EXPECT_TRUE(checkpoint::windows(folder, "solid").empty());
}

TEST_F(Files, WhatIsNotAsItWasWrittenIsRefused) {
  Checkpoints checkpoints(folder, "solid", "abc", 0);
  checkpoints.write(7, "state\nof the solid");
  EXPECT_THAT(refusal(checkpoints, 8), HasSubstr("no such checkpoint"));
  EXPECT_THAT(refusal(Checkpoints(folder, "solid", "abd", 0), 7),
              HasSubstr("solid-7: the scene was changed since: it has digest abd now, expected abc; put scene.toml of "
                        "the run back as it was, or begin a new run in another folder"));
  const fs::path file = folder / "checkpoint/solid-7";
  std::string whole;
  std::ifstream stream(file);
  std::getline(stream, whole, '\0');
  std::string format;
  std::istringstream(whole) >> format >> format >> format;  // "blockweir checkpoint <format> ..."
  const auto with = [&](const std::string& text) {
    std::ofstream(file) << text;
    return refusal(checkpoints, 7);
  };
  EXPECT_THAT(with(whole.substr(0, whole.size() - 3)), HasSubstr("15 bytes, 18 expected"));
  EXPECT_THAT(with(whole.substr(0, whole.size() - 1) + "e"), HasSubstr("its content has changed"));
  EXPECT_THAT(with("nothing of the kind"), HasSubstr("not a checkpoint; run anew"));
  checkpoints.write(6, "before");
  EXPECT_THAT(with("nothing of the kind"), HasSubstr("delete it to go on from the checkpoint before it, or run anew"));
  EXPECT_THAT(with("blockweir checkpoint 9 solid 7 abc 0 0\n"), HasSubstr("format 9, this blockweir reads " + format));
  EXPECT_THAT(with("blockweir checkpoint " + format + " solid 6 abc 0 0\n"), HasSubstr("holds window 6 of solid"));
  EXPECT_EQ(with(whole), "");
}

class Calm : public schedule::SolidSide {
 public:
  void place(wire::Motion& /*motion*/) override {}
  void predict(double /*ahead_s*/, wire::Motion& /*motion*/) override {}
  void start(const wire::Load& /*load*/) override {}
  void advance(const wire::Load& /*load*/, const wire::Motion& /*told*/, double /*from_s*/, double /*to_s*/) override {}
  [[nodiscard]] bool at_rest() const override { return is_at_rest; }
  [[nodiscard]] bool finished() const override { return false; }
  bool is_at_rest = true;
};

TEST(Windows, AreEqualUnlessTheyMayGrow) {
  scene::Scene scene;
  scene.analysis.duration_s = 0.35;
  scene.coupling.window_s = 0.1;
  schedule::Windows windows(scene);
  const Calm solid;
  std::vector<double> ends;
  for (;; windows.next(solid)) {
    ends.push_back(windows.to_s());
    if (windows.last()) break;
  }
  EXPECT_EQ(ends, (std::vector<double>{0.1, 0.2, 3 * 0.1, 0.35}));
}

TEST(Windows, DoubleWhileNothingMovesAndAreShortAtOnceWhenSomethingDoes) {
  scene::Scene scene;
  scene.analysis.duration_s = 100;
  scene.coupling.window_s = 0.5;
  scene.coupling.longest_window_s = 2;
  schedule::Windows windows(scene);
  Calm solid;
  std::vector<double> lengths;
  for (const bool calm : {true, true, true, false, true, true}) {
    lengths.push_back(windows.to_s() - windows.from_s());
    solid.is_at_rest = calm;
    windows.next(solid);
  }
  EXPECT_EQ(lengths, (std::vector<double>{0.5, 1, 2, 2, 0.5, 1}));
}

/// Ends of the windows of a run of 0.4 s in windows of 0.1 s, or longer ones.
std::vector<double> ends_under(const scene::TimeTable& level, double longest_s = 0) {
  scene::Scene scene;
  scene.fluid = scene::FluidModel::hydrostatic;
  scene.water.upstream_level_m = level;
  scene.analysis.duration_s = 0.4;
  scene.coupling.window_s = 0.1;
  scene.coupling.longest_window_s = longest_s;
  schedule::Windows windows(scene);
  const Calm solid;
  std::vector<double> ends;
  for (double from_s = 0;; windows.next(solid)) {
    EXPECT_EQ(windows.from_s(), std::exchange(from_s, windows.to_s()));
    ends.push_back(windows.to_s());
    if (windows.last()) return ends;
  }
}

TEST(Windows, AreCutAtTheRowsOfALevelThatPeaksWithin) {
  const std::vector<double> uncut = {0.1, 0.2, 3 * 0.1, 0.4};
  EXPECT_EQ(ends_under({.time_s = {0, 0.12, 0.15, 0.18}, .value = {5, 5, 6, 5}}),
            (std::vector<double>{0.1, 0.12, 0.15, 0.18, 0.2, 3 * 0.1, 0.4}));
  EXPECT_EQ(ends_under({.time_s = {0, 0.35, 0.37}, .value = {5, 6, 5}, .stepwise = true}),
            (std::vector<double>{0.1, 0.2, 3 * 0.1, 0.35, 0.37, 0.4}));
  EXPECT_EQ(ends_under({.time_s = {0, 0.25}, .value = {5, 6}}), uncut);
  EXPECT_EQ(ends_under({.time_s = {0, 0.2, 0.4}, .value = {5, 6, 5}}), uncut);
  EXPECT_EQ(ends_under({.time_s = {0, 0.12, 0.15, 0.18, 0.4}, .value = {5, 5, 5.0005, 5, 6}}), uncut)
      << "not for what is less than a thousandth of what the level goes through";
}

TEST(Windows, ThatHaveGrownAreCutAtAPeakThatTheirEndsDoNotSee) {
  EXPECT_EQ(ends_under({.time_s = {0, 0.2, 0.4}, .value = {5, 6, 5}}, 0.4),
            (std::vector<double>{0.1, 0.2, 3 * 0.1, 0.4}));
  EXPECT_EQ(ends_under({.time_s = {0, 0.15, 0.3}, .value = {5, 6, 5}}, 0.4),
            (std::vector<double>{0.1, 0.15, 3 * 0.1, 0.4}));
}

}  // namespace
}  // namespace blockweir::checkpoint_test
