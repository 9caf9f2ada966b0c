// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_process
// Private folders of processes that were killed are gone when the next one is made; those of the living stay.
#include "bridge/process/temporary_folder.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "tests/own_folder.hpp"

namespace blockweir::process::temporary_folder_test {
namespace {

namespace fs = std::filesystem;

class TemporaryFolders : public test::OwnFolder {
 protected:
  TemporaryFolders() { ::setenv("TMPDIR", folder.c_str(), 1); }
  ~TemporaryFolders() override { ::unsetenv("TMPDIR"); }
};

TEST_F(TemporaryFolders, OfTheDeadAreRemovedAndOfTheLivingKept) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const TemporaryFolder theirs;
    const std::string path = theirs.path().string();
    (void)!::write(ready[1], path.data(), path.size());
    for (;;) ::pause();
  }
  std::string path(4096, '\0');
  path.resize(static_cast<std::size_t>(::read(ready[0], path.data(), path.size())));
  { const TemporaryFolder ours; }
  EXPECT_TRUE(fs::exists(path));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(path));
  { const TemporaryFolder ours; }
  EXPECT_FALSE(fs::exists(path));
}

/// As those of a study whose runs begin side by side: one that is not locked yet was taken for one that was left.
TEST_F(TemporaryFolders, MadeAtTheSameTimeAreAllKept) {
  std::vector<pid_t> children;
  for (int k = 0; k < 4; ++k) {
    children.push_back(::fork());
    if (children.back() != 0) continue;
    int lost = 0;
    for (int i = 0; i < 40; ++i) {
      const TemporaryFolder ours;
      if (!fs::exists(ours.path() / results::FolderLock::file)) ++lost;
    }
    ::_exit(lost == 0 ? 0 : 1);
  }
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
}

TEST_F(TemporaryFolders, WhatIsNotOneIsLeftAlone) {
  for (const char* name : {"blockweir-notes-1", "blockweir-abcdef", "other"}) fs::create_directory(folder / name);
  std::ofstream(folder / "blockweir-notes-1" / ".lock") << 1;
  { const TemporaryFolder ours; }
  for (const char* name : {"blockweir-notes-1", "blockweir-abcdef", "other"}) EXPECT_TRUE(fs::exists(folder / name));
}

}  // namespace
}  // namespace blockweir::process::temporary_folder_test
