// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Keys, and those who come to a port and are not the partner.
#include <arpa/inet.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include "tests/processes.hpp"

namespace blockweir::test::strangers_test {
namespace {

using testing::HasSubstr;

class Strangers : public Processes {
 protected:
  ~Strangers() override {
    for (const int socket : sockets_) close(socket);
  }
  /// Comes to the port once somebody listens there, and says `words`.
  void knock(const std::string& words) {
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockets_.push_back(socket);
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    bool in = false;
    for (int wait = 0; wait < 1000 && !in; ++wait) {
      in = connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
      if (!in) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_TRUE(in);
    ASSERT_EQ(send(socket, words.data(), words.size(), MSG_NOSIGNAL), static_cast<ssize_t>(words.size()));
  }
  void expect_partner_comes_in_after_strangers(const std::string& solid_keys, const std::string& fluid_keys) {
    const std::string scene =
        cases + "monolith-slides --set analysis.duration_s=1 --endpoint tcp://127.0.0.1:" + std::to_string(port);
    const pid_t solid = start(programs + "/blockweir-solid " + scene + " --out o" + solid_keys, "solid");
    knock("");
    knock("GET / HTTP/1.1\r\nHost: x\r\n\r\n");
    knock(std::string(200, '\xff'));
    knock(std::string(64, '\0'));
    std::string noise;
    for (int i = 0; i < 5000; ++i) noise += static_cast<char>(i * i * 31 + i / 7);
    knock(noise);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    const pid_t fluid = start(programs + "/blockweir-hydrostatic " + scene + fluid_keys, "fluid");
    EXPECT_EQ(end_of(solid, 30), 0) << text("solid");
    EXPECT_EQ(end_of(fluid, 5), 0) << text("fluid");
    EXPECT_THAT(text("solid"), HasSubstr("blockweir: refused a client from "));
  }

  const int port = 20000 + getpid() % 20000;

 private:
  std::vector<int> sockets_;
};

TEST_F(Strangers, WhoTalksNoZeroMqDoesNotKeepThePartnerOut) {
  expect_partner_comes_in_after_strangers("", "");
}

TEST_F(Strangers, NorWithKeys) {
  ASSERT_EQ(shell(programs + "/blockweir keys k"), 0) << text("out");
  expect_partner_comes_in_after_strangers(" --keys k/solid", " --keys k/fluid");
}

TEST_F(Strangers, KeysAreForTheirOwnersEyesAndMadeOnce) {
  ASSERT_EQ(shell(programs + "/blockweir keys k"), 0);
  for (const std::string side : {"solid", "fluid"}) {
    struct stat status = {};
    ASSERT_EQ(stat((folder / "k" / side / "own-secret").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0600U) << side;
    EXPECT_EQ(text("k/" + side + "/own-secret").size(), 41U);
    EXPECT_THAT(text("out"), testing::Not(HasSubstr(text("k/" + side + "/own-secret").substr(0, 40))));
  }
  const std::string secret = text("k/solid/own-secret");
  EXPECT_EQ(shell(programs + "/blockweir keys k"), 2);
  EXPECT_THAT(text("out"), HasSubstr("k/solid is there already; choose another folder"));
  EXPECT_EQ(text("k/solid/own-secret"), secret);
}

TEST_F(Strangers, UnfitKeysAreRefused) {
  ASSERT_EQ(shell(programs + "/blockweir keys k"), 0);
  const std::string run = programs + "/blockweir-solid " + cases + "monolith-slides --out o --endpoint ";
  const std::string port_here = "tcp://127.0.0.1:" + std::to_string(port);
  EXPECT_EQ(shell(run + port_here + " --keys k"), 2);
  EXPECT_THAT(text("out"), HasSubstr("k/own-secret: no such file; expected one side's folder"));
  EXPECT_EQ(shell(run + "ipc://" + (folder / "line").string() + " --keys k/solid"), 2);
  EXPECT_THAT(text("out"), testing::AllOf(HasSubstr("which only this machine reaches; expected tcp://HOST:PORT"),
                                          HasSubstr("leave --keys out")));
  fs::permissions(folder / "k/solid/own-secret", fs::perms(0640));
  EXPECT_EQ(shell(run + port_here + " --keys k/solid"), 2);
  EXPECT_THAT(text("out"), HasSubstr("others may read this secret; \"chmod 600 "));
  std::ofstream(folder / "k/fluid/own-secret") << "not a key\n";
  EXPECT_EQ(shell(run + port_here + " --keys k/fluid"), 2);
  EXPECT_THAT(text("out"), HasSubstr("k/fluid/own-secret: not a key; expected a line of 40 characters"));
}

}  // namespace
}  // namespace blockweir::test::strangers_test
