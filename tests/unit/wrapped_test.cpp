// SPDX-License-Identifier: GPL-3.0-or-later
// links: fmt::fmt
// Lines as a terminal shows them.
#include "bridge/results/wrapped.hpp"

#include <gtest/gtest.h>

namespace blockweir::results::wrapped_test {
namespace {

TEST(Wrapped, BreaksBetweenWordsAndIndentsWhatGoesOn) {
  EXPECT_EQ(wrapped("STANDS  one two three\nshort\n", 15), "STANDS  one two\n        three\nshort\n");
  EXPECT_EQ(wrapped("STANDS  one two three four five\n", 15),
            "STANDS  one two\n        three\n        four\n        five\n");
}

TEST(Wrapped, AWordThatIsTooLongStaysWhole) {
  const std::string path = "results runs/a-name-that-is-longer-than-the-terminal\n";
  EXPECT_EQ(wrapped(path, 20), path);
  EXPECT_EQ(wrapped("results a/very/long/path-of-a-run (opens)\n", 20),
            "results a/very/long/path-of-a-run\n        (opens)\n");
}

}  // namespace
}  // namespace blockweir::results::wrapped_test
