// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_process
// What a run says of its way in a pipe.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

#include "bridge/process/progress.hpp"

namespace blockweir::process::progress_test {
namespace {

class ProgressLines : public testing::Test {
 protected:
  ProgressLines() : progress(open_pipe(), 10, /*quiet=*/false) {}
  ~ProgressLines() override {
    ::close(ends[0]);
    ::close(ends[1]);
  }
  /// What is printed when the solid says `line`.
  std::string shown(const std::string& line) {
    EXPECT_EQ(::write(ends[1], line.data(), line.size()), static_cast<ssize_t>(line.size()));
    testing::internal::CaptureStderr();
    begun = progress.update();
    return testing::internal::GetCapturedStderr();
  }
  int open_pipe() {
    EXPECT_EQ(::pipe2(ends, O_NONBLOCK), 0);
    return ends[0];
  }
  int ends[2] = {-1, -1};
  Progress progress;
  bool begun = false;
};

TEST_F(ProgressLines, AWindowThatTakesLongSaysWhereItIsEachTimeItsSolutionsHaveDoubled) {
  EXPECT_EQ(shown("solving 333 3.31 90\n"), "");
  EXPECT_EQ(shown("solving 333 3.31 4000\n"), "window 333, 3.31 s: 4,000 solutions so far\n");
  EXPECT_EQ(shown("solving 333 3.31 6300\n"), "");
  EXPECT_EQ(shown("solving 333 3.32 1234567\n"), "window 333, 3.32 s: 1,234,567 solutions so far\n");
  EXPECT_EQ(shown("solving 334 3.33 150\n"), "window 334, 3.33 s: 150 solutions so far\n");
}

TEST_F(ProgressLines, AStructureThatSettlesHasNotBegun) {
  EXPECT_EQ(shown("settling 1500\n"), "settling: 1,500 linear systems solved\n");
  EXPECT_FALSE(begun);
  EXPECT_EQ(shown("1 nan 0.001\n"), " 10 %  1.00 s  moved 0.001 m\n");
  EXPECT_TRUE(begun);
}

}  // namespace
}  // namespace blockweir::process::progress_test
