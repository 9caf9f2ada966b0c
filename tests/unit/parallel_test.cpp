// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_block
// Loops on several threads do what loops on one do.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <limits>
#include <numeric>
#include <thread>
#include <vector>

#include "solid/block/parallel.hpp"

namespace blockweir::solid::parallel_test {
namespace {

class Parallel : public testing::TestWithParam<std::size_t> {
 protected:
  Parallel() : before_(threads()) { set_threads(GetParam()); }
  ~Parallel() override { set_threads(before_); }
  static constexpr std::size_t count = 10 * many + 7;

 private:
  std::size_t before_;
};

std::vector<int> visits(std::size_t count) {
  std::vector<int> visited(count, 0);
  for_each(count, [&](std::size_t i) { ++visited[i]; });
  return visited;
}

TEST_P(Parallel, EachIndexIsVisitedOnce) {
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}, many - 1, many, many + 1, count}) {
    EXPECT_EQ(visits(n), std::vector<int>(n, 1)) << n;
  }
}

TEST_P(Parallel, TheLargestIsFoundWhereverItIs) {
  std::vector<double> values(count, 1);
  for (const std::size_t place : {std::size_t{0}, count / 3, count - 1}) {
    values[place] = 2 + static_cast<double>(place);
    EXPECT_EQ(largest(count, [&](std::size_t i) { return values[i]; }), values[place]);
  }
  EXPECT_EQ(largest(count, [](std::size_t) { return -1.0; }), 0);
}

TEST_P(Parallel, WhatIsNoNumberIsNotOverlooked) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const std::size_t place : {std::size_t{0}, count / 3, count - 1}) {
    EXPECT_EQ(largest(count, [&](std::size_t i) { return i == place ? infinity : 1; }), infinity);
    EXPECT_TRUE(std::isnan(largest(count, [&](std::size_t i) { return i == place ? none : 1; })));
  }
}

TEST_P(Parallel, AllOfThemHoldOrOneDoesNot) {
  EXPECT_TRUE(all_of(count, [](std::size_t) { return true; }));
  for (const std::size_t place : {std::size_t{0}, count / 3, count - 1}) {
    EXPECT_FALSE(all_of(count, [&](std::size_t i) { return i != place; }));
  }
}

/// Each has its turn with the workers or goes on alone.
TEST_P(Parallel, LoopsOfTwoThreadsAtATimeAndOneInAnotherEnd) {
  bool other_fine = true;
  std::thread other([&] {
    for (int k = 0; k < 100; ++k) other_fine = other_fine && visits(count) == std::vector<int>(count, 1);
  });
  for (int k = 0; k < 100; ++k) EXPECT_EQ(visits(count), std::vector<int>(count, 1));
  other.join();
  EXPECT_TRUE(other_fine);
  std::atomic<int> inner = 0;
  for_each(many, [&](std::size_t i) {
    if (i % 1000 == 0) for_each(many, [&](std::size_t) { ++inner; });
  });
  EXPECT_EQ(inner, static_cast<int>(many / 1000 * many));
}

std::atomic<int> stops_taken = 0;

/// A thread that waits with the signal blocked finds it; one of the loops' would have ended the process.
TEST_P(Parallel, WhatStopsTheProcessIsLeftToTheThreadThatWaits) {
  stops_taken = 0;
  EXPECT_EQ(visits(count), std::vector<int>(count, 1));
  struct sigaction counts {};
  counts.sa_handler = [](int) { ++stops_taken; };
  struct sigaction before {};
  ::sigaction(SIGTERM, &counts, &before);
  sigset_t stop;
  sigset_t mask_before;
  sigemptyset(&stop);
  sigaddset(&stop, SIGTERM);
  ::pthread_sigmask(SIG_BLOCK, &stop, &mask_before);
  ::kill(::getpid(), SIGTERM);
  const timespec soon{.tv_sec = 0, .tv_nsec = 100'000'000};
  EXPECT_EQ(::sigtimedwait(&stop, nullptr, &soon), SIGTERM);
  EXPECT_EQ(stops_taken, 0);
  ::pthread_sigmask(SIG_SETMASK, &mask_before, nullptr);
  ::sigaction(SIGTERM, &before, nullptr);
}

INSTANTIATE_TEST_SUITE_P(OnThreads, Parallel, testing::Values(1, 2, 3, 8), testing::PrintToStringParamName());

}  // namespace
}  // namespace blockweir::solid::parallel_test
