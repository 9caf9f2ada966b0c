// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_channel
// Signals that come at any moment disturb no exchange.
#include <gtest/gtest.h>
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <thread>

#include "bridge/channel/channel.hpp"

namespace blockweir::channel::signals_test {
namespace {

volatile std::sig_atomic_t signals = 0;

/// A signal every 50 microseconds, as long as this lives.
class Alarms {
 public:
  Alarms() {
    struct sigaction action = {};
    action.sa_handler = [](int) { signals = signals + 1; };
    sigaction(SIGALRM, &action, nullptr);
    every(50);
  }
  ~Alarms() {
    every(0);
    std::signal(SIGALRM, SIG_IGN);
  }
  Alarms(const Alarms&) = delete;
  Alarms& operator=(const Alarms&) = delete;

 private:
  static void every(int microseconds) {
    const itimerval interval{{0, microseconds}, {0, microseconds}};
    setitimer(ITIMER_REAL, &interval, nullptr);
  }
};

TEST(Signals, DisturbNoExchange) {
  const auto path = std::filesystem::temp_directory_path() / ("blockweir-signals-" + std::to_string(getpid()));
  constexpr std::uint64_t windows = 5000;
  const auto options = [&](Side side) { return Options{side, "ipc://" + path.string(), "the other side"}; };
  const wire::Hello hello;
  const Alarms alarms;
  std::uint64_t heard = 0;
  std::thread fluid([&] {
    Channel channel(options(Side::connects));
    EXPECT_NO_THROW(static_cast<void>(channel.handshake(hello)));
    wire::Motion motion;
    wire::Load load;
    EXPECT_NO_THROW(for (; heard < windows; ++heard) {
      channel.receive(motion);
      load.window = motion.window;
      channel.send(load);
    });
  });
  Channel channel(options(Side::listens));
  EXPECT_NO_THROW(static_cast<void>(channel.handshake(hello)));
  wire::Motion motion;
  wire::Load load;
  EXPECT_NO_THROW(for (motion.window = 0; motion.window < windows; ++motion.window) {
    channel.send(motion);
    channel.receive(load);
  });
  fluid.join();
  EXPECT_EQ(heard, windows);
  EXPECT_GT(signals, 100);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace blockweir::channel::signals_test
