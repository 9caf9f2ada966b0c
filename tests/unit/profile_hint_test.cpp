// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture
// What `blockweir profile` advises where the two processes wait for each other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bridge/picture/profile.hpp"

namespace blockweir::profile_hint_test {
namespace {

using testing::HasSubstr;

/// A run of 10 s whose water works for 3 s of the `waited_s` that the solid waits.
std::string tree(double waited_s) {
  return blockweir::picture::profile_tree(
      {{"wall_time_s", 10.0},
       {"profile_s",
        {{"solve", 10 - waited_s}, {"wait_for_fluid", waited_s}, {"fluid_step", 3.0}, {"fluid_wait", 7.0}}}});
}

TEST(ProfileHint, NamesInprocAndFewerJobsWhereBothProcessesWait) {
  EXPECT_THAT(tree(8), HasSubstr("50 % of the time both processes waited"));
  EXPECT_THAT(tree(8), HasSubstr("--inproc"));
  EXPECT_THAT(tree(4), testing::Not(HasSubstr("both processes waited")));
}

}  // namespace
}  // namespace blockweir::profile_hint_test
