// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_channel
// Endpoints that cannot be used, and what a partner may not say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <future>
#include <thread>

#include "bridge/channel/channel.hpp"
#include "bridge/channel/endpoint.hpp"
#include "bridge/channel/socket.hpp"

namespace blockweir::channel::channel_line_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Line : public testing::Test {
 protected:
  Line() { fs::create_directory(folder); }
  ~Line() override { fs::remove_all(folder); }
  static std::string refusal(const std::string& endpoint, bool listens = true) {
    try {
      check_endpoint(endpoint, listens, false);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }
  const fs::path folder = fs::temp_directory_path() / ("blockweir-line-" + std::to_string(::getpid()));
};

TEST_F(Line, EndpointsThatCannotBeAreRefused) {
  for (const char* endpoint : {"nonsense", "ipc://", "/tmp/line"}) {
    EXPECT_THAT(refusal(endpoint), HasSubstr("expected ipc://PATH or tcp://HOST:PORT")) << endpoint;
  }
  for (const char* endpoint : {"tcp://", "tcp://localhost", "tcp://localhost:", "tcp://localhost:http"}) {
    EXPECT_THAT(refusal(endpoint), HasSubstr("expected tcp://HOST:PORT")) << endpoint;
  }
  for (const char* endpoint : {"tcp://localhost:0", "tcp://localhost:65536", "tcp://localhost:99999999999999999999"}) {
    EXPECT_THAT(refusal(endpoint), HasSubstr("expected a port from 1 to 65535")) << endpoint;
  }
  EXPECT_THAT(refusal("ipc://" + std::string(200, 'x')),
              HasSubstr("the path has 200 bytes, at most 107 fit a socket; choose a shorter one"));
  EXPECT_THAT(refusal("ipc://" + (folder / "no/line").string(), false), HasSubstr("there is no folder"));
}

TEST_F(Line, APatienceMayBeOfAnyLength) {
  for (const double patience_s : {1e-3, 14000.0, 86400.0, 1e300}) {
    zmq::context_t context;
    zmq::socket_t socket(context, zmq::socket_type::pair);
    Options options{Side::connects, "ipc://" + (folder / "line").string(), "nobody", patience_s, patience_s};
    EXPECT_NO_THROW(set_up(socket, options)) << patience_s;
  }
}

TEST_F(Line, AFileThatIsNoSocketIsNotRemoved) {
  const fs::path file = folder / "notes";
  std::ofstream(file) << "mine";
  EXPECT_THAT(refusal("ipc://" + file.string()), HasSubstr("there is a file that is no socket"));
  EXPECT_TRUE(fs::exists(file));
}

TEST_F(Line, AnEndpointInUseIsRefused) {
  const std::string endpoint = "ipc://" + (folder / "line").string();
  const Channel first({Side::listens, endpoint, "partner"});
  EXPECT_THAT(refusal(endpoint), HasSubstr("another process listens there already; choose another --endpoint"));
  EXPECT_EQ(refusal(endpoint, false), "");
}

TEST_F(Line, AMessageOfAnotherKindThanIsDueIsNamedToBothSides) {
  const std::string endpoint = "ipc://" + (folder / "line").string();
  std::thread fluid([&] {
    Channel channel({Side::connects, endpoint, "solid process"});
    static_cast<void>(channel.handshake({}));
    channel.send(wire::Motion{});
    wire::Motion motion;
    try {
      channel.receive(motion);
      ADD_FAILURE();
    } catch (const PeerError& error) {
      EXPECT_THAT(error.what(),
                  HasSubstr("solid process stopped in window 0: fluid process sent a message of another"));
    }
  });
  Channel channel({Side::listens, endpoint, "fluid process"});
  static_cast<void>(channel.handshake({}));
  wire::Load load;
  try {
    channel.receive(load);
    ADD_FAILURE();
  } catch (const PeerError& error) {
    EXPECT_THAT(error.what(), HasSubstr("fluid process sent a message of another kind than the one expected"));
  }
  fluid.join();
}

TEST_F(Line, ASideWithoutASceneAgreesToWhatTheOtherSays) {
  const std::string endpoint = "ipc://" + (folder / "line").string();
  wire::Hello ours;
  ours.role = "solid";
  ours.scene_digest = "0123456789abcdef";
  ours.block_names = {"a"};
  std::thread fluid([&] {
    Channel channel({Side::connects, endpoint, "solid process"});
    const wire::Hello theirs = channel.agree("mine", "1");
    EXPECT_EQ(theirs.scene_digest, ours.scene_digest);
    EXPECT_EQ(theirs.role, "mine");
    wire::Motion motion;
    EXPECT_THROW(channel.receive(motion), PeerEnded);
  });
  Channel channel({Side::listens, endpoint, "fluid process"});
  EXPECT_EQ(channel.handshake(ours).role, "mine");
  channel.send(wire::Farewell{"enough"});
  fluid.join();
}

/// A fluid that says for `steps` quarters of the time-out that it comes further, and then nothing.
TEST_F(Line, APartnerThatComesFurtherIsWaitedForUntilItHangs) {
  constexpr double timeout_s = 0.4;
  constexpr int steps = 10;
  std::promise<void> given_up;
  const auto options = [&](Side side, const char* partner) {
    return Options{
        .side = side, .endpoint = "ipc://" + (folder / "line").string(), .partner = partner, .timeout_s = timeout_s};
  };
  std::thread fluid([&] {
    Channel channel(options(Side::connects, "solid process"));
    static_cast<void>(channel.handshake({}));
    for (int step = 0; step < steps; ++step) {
      std::this_thread::sleep_for(std::chrono::duration<double>(timeout_s * 0.3));
      channel.send(wire::Progress{"window 7: step " + std::to_string(step)});
    }
    given_up.get_future().wait();
  });
  Channel channel(options(Side::listens, "fluid process"));
  static_cast<void>(channel.handshake({}));
  wire::Load load;
  try {
    channel.receive(load);
    ADD_FAILURE();
  } catch (const PeerError& error) {
    EXPECT_THAT(error.what(), HasSubstr("fluid process has been silent for 0.4 s"));
    EXPECT_THAT(error.what(), HasSubstr(": it hangs since window 7: step 9; [coupling] timeout_s sets the patience"));
  }
  EXPECT_GT(channel.waited_s(), 2 * timeout_s);
  given_up.set_value();
  fluid.join();
}

}  // namespace
}  // namespace blockweir::channel::channel_line_test
