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
  struct Said {
    std::string text;
    int status;
  };
  [[nodiscard]] static Said said(const std::string& command) {
    std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    std::string text;
    std::array<char, 4096> part;
    while (const std::size_t read = std::fread(part.data(), 1, part.size(), pipe)) text.append(part.data(), read);
    return {text, ::pclose(pipe)};
  }
  [[nodiscard]] std::string output_of(const std::string& options) const {
    const Said all = said((folder / "blockweir").string() + " " + options);
    EXPECT_EQ(all.status, 0);
    return all.text;
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

/// It configured the caller's folder.
TEST_F(Launcher, ALinkToItFindsItsTree) {
  fs::create_directories(folder / "bin");
  fs::create_symlink(folder / "blockweir", folder / "bin/dams");
  const Said linked = said("cd " + (folder / "bin").string() + " && ./dams --version");
  EXPECT_EQ(linked.status, 0);
  EXPECT_EQ(linked.text, output_of("--version"));
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
    return said("bash -c '" + held + (folder / "blockweir").string() + " check'").text;
  };
  EXPECT_EQ(waited("0.7"), "");
  EXPECT_THAT(waited("4"), testing::HasSubstr("waiting for another ./blockweir that sets up"));
}

/// Another user's copy.
TEST_F(Launcher, WhoMayNotWriteRunsWhatIsBuilt) {
  const fs::perms readable =
      fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec;
  const std::string as_nobody = ::geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
  const auto called = [&](const std::string& options) {
    fs::permissions(folder / "build", readable);
    const Said all = said(as_nobody + (folder / "blockweir").string() + " " + options);
    fs::permissions(folder / "build", fs::perms::owner_all);
    return all;
  };
  fs::permissions(folder, readable | fs::perms::owner_write);
  const fs::path built = folder / "build/release/bin/blockweir";
  fs::create_directories(built.parent_path());
  const Said unbuilt = called("check");
  EXPECT_THAT(unbuilt.text, testing::MatchesRegex("blockweir: you may not write to .*/build, where the program is "
                                                  "built; expected .*\n"));
  EXPECT_NE(unbuilt.status, 0);
  std::ofstream(built) << "#!/bin/sh\necho built \"$@\"\n";
  fs::permissions(built, readable);
  EXPECT_EQ(called("check a.toml").text, "built check a.toml\n");
  EXPECT_NE(called("test").status, 0);
}

}  // namespace
}  // namespace blockweir::launcher_test
