// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_launch
// What a command started and left behind does not outlive the call: mpirun may end before its ranks do.
#include "bridge/launch/supervisor.hpp"
#include "tests/processes.hpp"

namespace blockweir::test {
namespace {

class Supervisor : public Processes {
 protected:
  /// Runs `line` in a shell in this test's folder.
  [[nodiscard]] launch::Supervised run(const std::string& line, double grace_s) const {
    const launch::Command command{"sh", {"sh", "-c", "cd " + folder.string() + " && " + line}};
    return launch::supervise({command}, folder, grace_s, [] { return true; });
  }
};

TEST_F(Supervisor, WhatIsLeftBehindMayEndByItself) {
  EXPECT_TRUE(run("(sleep 0.3; echo done >grandchild) & exit 0", 20).all_fine());
  EXPECT_EQ(text("grandchild"), "done\n");
  EXPECT_FALSE(orphan());
}

TEST_F(Supervisor, WhatIsLeftBehindAndStaysIsKilled) {
  EXPECT_TRUE(run("setsid sleep 250 & exit 0", 0.1).all_fine());
  EXPECT_FALSE(orphan());
}

}  // namespace
}  // namespace blockweir::test
