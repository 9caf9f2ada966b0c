// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_results
// Places for results that cannot be are refused in one line, and nothing is left behind.
#include "bridge/results/folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <iostream>
#include <stdexcept>

#include "tests/own_folder.hpp"

namespace blockweir::results::folder_test {
namespace {

namespace fs = std::filesystem;

using Folder = test::OwnFolder;

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "";
}

TEST_F(Folder, IsMadeWithWhatIsMissingAboveIt) {
  make_folder(folder / "a/b/c");
  EXPECT_TRUE(fs::is_directory(folder / "a/b/c"));
  make_folder(folder / "a/b/c");
}

TEST_F(Folder, BelowAFileIsRefused) {
  std::ofstream(folder / "file") << "x";
  EXPECT_EQ(refusal([&] { make_folder(folder / "file/out"); }),
            "--out " + (folder / "file/out").string() + ": " + (folder / "file").string() +
                " is no folder; expected a folder that can be made and written; choose another --out");
}

TEST_F(Folder, WhereNoneCanBeMadeIsRefused) {
  EXPECT_EQ(refusal([] { make_folder("/proc/blockweir/out"); }),
            "--out /proc/blockweir/out: cannot be made (No such file or directory); expected a folder that can be made "
            "and written; choose another --out");
}

TEST_F(Folder, WhatThisUserMayNotWriteInIsRefused) {
  fs::permissions(folder,
                  fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
  const auto as_a_user = [&] {
    constexpr uid_t nobody = 65534;
    if (::geteuid() == 0 && ::setuid(nobody) != 0) ::_exit(1);  // root may write anywhere
    std::cerr << refusal([&] { make_folder(folder / "out"); });
    ::_exit(0);
  };
  EXPECT_EXIT(as_a_user(), testing::ExitedWithCode(0),
              "cannot write in " + folder.string() + " \\(Permission denied\\); expected a folder that can be made");
}

TEST_F(Folder, AFileThatIsAFolderOrInNoneIsRefused) {
  require_writable_file("--json", folder / "table.json", {".json"});
  EXPECT_EQ(refusal([&] { require_writable_file("--json", folder, {".json"}); }),
            "--json " + folder.string() + ": this is a folder; expected a file that can be written; choose another");
  EXPECT_EQ(refusal([&] { require_writable_file("--json", folder / "no/table.json", {".json"}); }),
            "--json " + (folder / "no/table.json").string() + ": " + (folder / "no").string() +
                " is no folder; expected a file that can be written; choose another");
}

/// Else a scene, or a record, would be overwritten by a slip of the hand.
TEST_F(Folder, AFileOfAnotherKindOfNameIsRefused) {
  std::ofstream(folder / "w.toml") << "title = \"mine\"\n";
  for (const char* name : {"w.toml", "new.toml", "record.csv", "none"}) {
    const fs::path file = folder / name;
    EXPECT_EQ(refusal([&] {
                require_writable_file("--out", file, {".html", ".htm"});
              }),
              "--out " + file.string() + ": expected a name that ends in .html or .htm; choose such a name");
  }
  require_writable_file("--json", "/dev/null", {".json"});
}

}  // namespace
}  // namespace blockweir::results::folder_test
