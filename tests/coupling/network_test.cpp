// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Two machines: two network namespaces with a cable between them, which the tests lay themselves. Needs root and "ip".
#include <sys/stat.h>

#include "tests/processes.hpp"

namespace blockweir::test::network_test {
namespace {

using testing::HasSubstr;

class Network : public Processes {
 protected:
  Network() : tag_("bw" + std::to_string(getpid() % 100000)) {
    laid_ =
        sh("ip netns add " + tag_ + "a && ip netns add " + tag_ + "b && ip link add " + tag_ + "a netns " + tag_ +
           "a type veth peer name " + tag_ + "b netns " + tag_ + "b && ip -n " + tag_ + "a addr add 10.77.0.1/24 dev " +
           tag_ + "a && ip -n " + tag_ + "b addr add 10.77.0.2/24 dev " + tag_ + "b && ip -n " + tag_ + "a link set " +
           tag_ + "a up && ip -n " + tag_ + "b link set " + tag_ + "b up") == 0;
  }
  ~Network() override { (void)sh("ip netns del " + tag_ + "a; ip netns del " + tag_ + "b"); }

  void SetUp() override {
    if (!laid_)
      GTEST_SKIP() << "no network namespaces here (as root, with iproute2, they can be made): " << text("out");
    ASSERT_EQ(shell(programs + "/blockweir keys k"), 0) << text("out");
  }
  [[nodiscard]] int sh(const std::string& line) const { return shell("sh -c '" + line + "'"); }
  [[nodiscard]] pid_t solid(const std::string& more, const std::string& log = "solid") const {
    return start("ip netns exec " + tag_ + "a " + programs + "/blockweir-solid " + scene +
                     " --endpoint tcp://10.77.0.1:5555 --out o " + more,
                 log);
  }
  [[nodiscard]] pid_t fluid(const std::string& more, const std::string& log = "fluid") const {
    return start("ip netns exec " + tag_ + "b " + programs + "/blockweir-hydrostatic " + scene +
                     " --endpoint tcp://10.77.0.1:5555 " + more,
                 log);
  }
  void expect_launchers_result() const {
    ASSERT_EQ(shell(programs + "/blockweir run " + scene + " --quiet --out run"), 0) << text("out");
    EXPECT_EQ(text("o/history.csv"), text("run/history.csv"));
  }

  const std::string scene = cases + "monolith-slides --set analysis.duration_s=1 --set coupling.timeout_s=4";

 private:
  std::string tag_;
  bool laid_ = false;
};

TEST_F(Network, WithKeysTwoMachinesGiveTheLaunchersResult) {
  const pid_t b = fluid("--keys k/fluid");
  const pid_t a = solid("--keys k/solid");
  EXPECT_EQ(end_of(a, 60), 0) << text("solid");
  EXPECT_EQ(end_of(b, 10), 0) << text("fluid");
  expect_launchers_result();
}

TEST_F(Network, AStrangersKeyIsTurnedAwayAndThePartnerStillComesIn) {
  ASSERT_EQ(shell(programs + "/blockweir keys other"), 0);
  // Knows whom to ask for, but is not who may come; and one who has no keys at all.
  fs::copy(folder / "k/fluid", folder / "half");
  fs::copy_file(folder / "other/fluid/own-secret", folder / "half/own-secret", fs::copy_options::overwrite_existing);
  const pid_t a = solid("--keys k/solid");
  for (const auto& [keys, says] :
       {std::pair{"--keys half", "its key is not the partner's"},
        std::pair{"--insecure", "its keys are not those expected, or it has none although they are required"}}) {
    EXPECT_EQ(end_of(fluid(keys, "stranger"), 4), 1) << keys;
    EXPECT_THAT(text("stranger"), HasSubstr(says)) << keys;
    EXPECT_THAT(text("stranger"), HasSubstr("are both sides given --keys of one \"blockweir keys\"?")) << keys;
  }
  EXPECT_THAT(text("solid"), testing::ContainsRegex("refused a client from 10.77.0.2:[0-9]+ at "
                                                    "tcp://10.77.0.1:5555: its key is not the partner's\n"));
  const pid_t b = fluid("--keys k/fluid");
  EXPECT_EQ(end_of(a, 60), 0) << text("solid");
  EXPECT_EQ(end_of(b, 10), 0) << text("fluid");
  expect_launchers_result();
}

TEST_F(Network, WithTheWrongKeyBothEndInTime) {
  ASSERT_EQ(shell(programs + "/blockweir keys other"), 0);
  const pid_t a = solid("--keys k/solid");
  const pid_t b = fluid("--keys other/fluid");
  EXPECT_EQ(end_of(a, 6), 1);
  EXPECT_EQ(end_of(b, 6), 1);
  EXPECT_THAT(text("solid"), HasSubstr("refused a client from 10.77.0.2:"));
  EXPECT_THAT(text("solid"), HasSubstr("other clients were there); is it running"));
  EXPECT_THAT(text("fluid"), HasSubstr("--keys of the same make"));
}

TEST_F(Network, PlainTcpNeedsASwitch) {
  EXPECT_EQ(end_of(solid(""), 4), 2);
  EXPECT_EQ(end_of(fluid(""), 4), 2);
  for (const char* log : {"solid", "fluid"}) {
    EXPECT_THAT(text(log), HasSubstr("blockweir keys FOLDER")) << log;
    EXPECT_THAT(text(log), HasSubstr("or allow it with --insecure")) << log;
  }
  const pid_t b = fluid("--insecure");
  const pid_t a = solid("--insecure");
  EXPECT_EQ(end_of(a, 60), 0) << text("solid");
  EXPECT_EQ(end_of(b, 10), 0) << text("fluid");
  expect_launchers_result();
}

}  // namespace
}  // namespace blockweir::test::network_test
