// SPDX-License-Identifier: GPL-3.0-or-later
// A folder that a test has to itself, and that goes with it.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace blockweir::test {

class OwnFolder : public testing::Test {
 protected:
  OwnFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "blockweir-test-XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~OwnFolder() override { std::filesystem::remove_all(folder); }

  std::filesystem::path folder;
};

}  // namespace blockweir::test
