// SPDX-License-Identifier: GPL-3.0-or-later
// The script ./blockweir where nothing is built yet: what needs no build is told without one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <string>

#include "tests/own_folder.hpp"

namespace blockweir::launcher_test {
namespace {

namespace fs = std::filesystem;

/// A source tree with as much of it as the script reads.
class Launcher : public blockweir::test::OwnFolder {
 protected:
  Launcher() {
    const fs::path source = BLOCKWEIR_SOURCE;
    fs::create_directories(folder / "bridge/launch");
    for (const char* file : {"blockweir", "CMakeLists.txt", "bridge/launch/commands.hpp"}) {
      fs::copy_file(source / file, folder / file);
    }
  }
  [[nodiscard]] std::string output_of(const std::string& options) const {
    std::FILE* pipe = ::popen(((folder / "blockweir").string() + " " + options + " 2>&1").c_str(), "r");
    std::string text;
    std::array<char, 4096> part;
    while (const std::size_t read = std::fread(part.data(), 1, part.size(), pipe)) text.append(part.data(), read);
    EXPECT_EQ(::pclose(pipe), 0);
    return text;
  }
};

TEST_F(Launcher, HelpListsTheCommandsAndBuildsNothing) {
  for (const char* options : {"--help", "-h", ""}) {
    EXPECT_THAT(output_of(options), testing::AllOf(testing::HasSubstr("run        run a scene and report whether it "),
                                                   testing::HasSubstr("test       set up, build and run every test")));
  }
  EXPECT_FALSE(fs::exists(folder / "build"));
}

TEST_F(Launcher, TheVersionNeedsNoBuild) {
  EXPECT_THAT(output_of("--version"), testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+\n"));
  EXPECT_FALSE(fs::exists(folder / "build"));
}

TEST_F(Launcher, HelpOnTheTestsIsItsOwn) {
  EXPECT_THAT(output_of("test --help"), testing::HasSubstr("test       set up, build and run every test"));
  EXPECT_FALSE(fs::exists(folder / "build"));
}

/// Calls that are short wait for each other without a word.
TEST_F(Launcher, ACallThatWaitsForAnotherSaysSoAfterASecond) {
  fs::create_directories(folder / "build");
  const auto waited = [&](const char* seconds) {  // while this shell holds the lock
    const std::string held = "exec 9>" + (folder / "build/.lock").string() + "; flock 9; timeout " + seconds + " ";
    std::FILE* pipe = ::popen(("bash -c '" + held + (folder / "blockweir").string() + " check' 2>&1").c_str(), "r");
    std::string text;
    std::array<char, 4096> part;
    while (const std::size_t read = std::fread(part.data(), 1, part.size(), pipe)) text.append(part.data(), read);
    ::pclose(pipe);
    return text;
  };
  EXPECT_EQ(waited("0.7"), "");
  EXPECT_THAT(waited("4"), testing::HasSubstr("waiting for another ./blockweir that sets up"));
}

/// Another user's copy.
TEST_F(Launcher, WhoMayNotWriteRunsWhatIsBuilt) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become another user";
  fs::permissions(folder, fs::perms::all);
  fs::create_directories(folder / "build");
  fs::permissions(folder / "build", fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec);
  const std::string as_nobody = "setpriv --reuid=65534 --regid=65534 --clear-groups " + (folder / "blockweir").string();
  const auto said = [&](const std::string& options) {
    std::FILE* pipe = ::popen((as_nobody + " " + options + " 2>&1").c_str(), "r");
    std::string text;
    std::array<char, 4096> part;
    while (const std::size_t read = std::fread(part.data(), 1, part.size(), pipe)) text.append(part.data(), read);
    return text + (::pclose(pipe) == 0 ? "" : "failed\n");
  };
  EXPECT_THAT(said("check"), testing::MatchesRegex("blockweir: you may not write to .*/build, where the program is "
                                                   "built; expected .*\nfailed\n"));
  const fs::path built = folder / "build/release/bin/blockweir";
  fs::create_directories(built.parent_path());
  std::ofstream(built) << "#!/bin/sh\necho built \"$@\"\n";
  fs::permissions(built, fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec);
  EXPECT_EQ(said("check a.toml"), "built check a.toml\n");
  EXPECT_THAT(said("test"), testing::EndsWith("failed\n"));
}

}  // namespace
}  // namespace blockweir::launcher_test
