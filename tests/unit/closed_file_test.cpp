// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_results
#include "bridge/results/closed_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace blockweir::results::closed_file_test {
namespace {

namespace fs = std::filesystem;

class ClosedFileTest : public testing::Test {
 protected:
  ClosedFileTest() : path(fs::temp_directory_path() / ("closed-" + std::to_string(getpid()))) {}
  ~ClosedFileTest() override { fs::remove(path); }
  [[nodiscard]] std::string text() const {
    std::ostringstream all;
    all << std::ifstream(path).rdbuf();
    return all.str();
  }
  const fs::path path;
};

TEST_F(ClosedFileTest, IsWholeWheneverItHasGrown) {
  std::ofstream(path) << "of a run before, and longer than what is to come";
  ClosedFile file(path, "<", ">");
  file.put("a");
  EXPECT_EQ(text(), "<a>");
  file.put("abc");
  EXPECT_EQ(text(), "<abc>");
  file.put("abcd");
  EXPECT_EQ(text(), "<abcd>");
}

TEST_F(ClosedFileTest, ADiskThatIsFullLeavesItAsItWas) {
  ClosedFile file(path, "<", ">");
  file.put("abc");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit full{8, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &full);
  EXPECT_THROW(file.put("abcdefghij"), std::runtime_error);
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(text(), "<abc>");
  file.put("abcdefghij");
  EXPECT_EQ(text(), "<abcdefghij>");
}

}  // namespace
}  // namespace blockweir::results::closed_file_test
