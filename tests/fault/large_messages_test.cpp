// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_channel cppzmq
// Messages whose large columns are parts of their own, over a real line: as they were sent, or refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <future>

#include "bridge/channel/channel.hpp"
#include "bridge/wire/codec.hpp"
#include "tests/fault/relay.hpp"

namespace blockweir::test::large_messages_test {
namespace {

using From = Relay::From;

constexpr std::size_t blocks = 10'000;
constexpr std::size_t panels = 40'000;
/// Frames of one load: the first, and a part for each column of doubles.
constexpr std::size_t frames_a_load = 5;

std::string at(const char* name) {
  return "ipc:///tmp/blockweir-large-" + std::to_string(::getpid()) + name;
}

wire::Motion motion(std::uint64_t window) {
  wire::Motion motion;
  motion.window = window;
  motion.displacement.assign(blocks, {1, 2, 3, 4, 5, static_cast<double>(window)});
  motion.velocity = motion.displacement;
  return motion;
}

void set(wire::Load& load, std::uint64_t window) {
  load.window = window;
  load.block.assign(panels, 3);
  load.edge.assign(panels, 1);
  load.s_from.assign(panels, 0);
  load.s_to.assign(panels, 1);
  load.pressure_from_pa.assign(panels, 1e3 * static_cast<double>(window));
  load.pressure_to_pa.assign(panels, 2e3 * static_cast<double>(window));
}

/// The fluid's side: answers `windows` motions, from one load that it fills anew each time.
void answer(const std::string& endpoint, std::uint64_t windows) {
  channel::Channel line(
      {.side = channel::Side::connects, .endpoint = endpoint, .partner = "solid", .timeout_s = 2, .open_timeout_s = 5});
  wire::Hello hello;
  hello.block_names.resize(blocks);
  (void)line.handshake(hello);
  wire::Motion heard;
  wire::Load said;
  for (std::uint64_t window = 0; window < windows; ++window) {
    line.receive(heard);
    EXPECT_EQ(heard.displacement, motion(window).displacement);
    EXPECT_EQ(heard.velocity, motion(window).velocity);
    set(said, window);
    line.send(said);
    set(said, 99);  // on its way it stays what it was
  }
}

/// The solid's side: what it is told, or why it is not.
std::string exchange(const std::string& endpoint, std::uint64_t windows) {
  channel::Channel line(
      {.side = channel::Side::listens, .endpoint = endpoint, .partner = "fluid", .timeout_s = 2, .open_timeout_s = 5});
  wire::Hello hello;
  hello.block_names.resize(blocks);
  try {
    (void)line.handshake(hello);
    wire::Load heard;
    wire::Load due;
    for (std::uint64_t window = 0; window < windows; ++window) {
      line.send(motion(window));
      line.receive(heard);
      set(due, window);
      EXPECT_EQ(heard.window, window);
      EXPECT_EQ(heard.block, due.block);
      EXPECT_EQ(heard.s_to, due.s_to);
      EXPECT_EQ(heard.pressure_from_pa, due.pressure_from_pa);
      EXPECT_EQ(heard.pressure_to_pa, due.pressure_to_pa);
    }
  } catch (const channel::PeerError& error) {
    return error.what();
  }
  return "";
}

TEST(LargeMessages, ArriveAsTheyWereSent) {
  const auto fluid = std::async(std::launch::async, [] { answer(at("a"), 20); });
  EXPECT_EQ(exchange(at("a"), 20), "");
}

/// What the solid says where frame `number` of the fluid's (0: Hello) becomes what `tamper` makes of it.
std::string refusal(std::size_t number, const std::function<Frame(const std::vector<Frame>& sent)>& tamper) {
  auto solid = std::async(std::launch::async, [] { return exchange(at("b"), 4); });
  const Relay relay(at("b"), at("c"),
                    [&](From from, std::size_t n, const std::vector<Frame>& sent) -> std::vector<Frame> {
                      return {from == From::fluid && n == number ? tamper(sent) : sent.back()};
                    });
  const auto fluid = std::async(std::launch::async, [] {
    try {
      answer(at("c"), 4);
    } catch (const channel::PeerError&) {  // the solid has gone
    }
  });
  return solid.get();
}

TEST(LargeMessages, APartWithAFlippedBitIsRefused) {
  EXPECT_THAT(refusal(1 + 2 * frames_a_load + 3,
                      [](const std::vector<Frame>& sent) {
                        Frame frame = sent.back();
                        frame[200'000] ^= 4;
                        return frame;
                      }),
              testing::HasSubstr("320000 bytes that are damaged, or not the pressure_from_pa of window 2"));
}

TEST(LargeMessages, APartOfAnotherWindowIsRefused) {
  EXPECT_THAT(refusal(1 + 2 * frames_a_load + 4,
                      [](const std::vector<Frame>& sent) { return sent[sent.size() - 1 - frames_a_load]; }),
              testing::HasSubstr("320000 bytes that are damaged, or not the pressure_to_pa of window 2"));
}

TEST(LargeMessages, APartCutShortIsRefused) {
  EXPECT_THAT(refusal(1 + frames_a_load + 1,
                      [](const std::vector<Frame>& sent) { return Frame(sent.back().begin(), sent.back().end() - 3); }),
              testing::HasSubstr("319997 bytes of s_from where 320000 were due, in window 1"));
}

TEST(LargeMessages, AMessageWithMorePartsThanItSaysIsRefused) {
  EXPECT_THAT(refusal(1 + frames_a_load,
                      [](const std::vector<Frame>&) {
                        flatbuffers::FlatBufferBuilder without;
                        std::vector<wire::Part> none;
                        wire::encode(wire::Load{.window = 1}, without, none);
                        return Frame(without.GetBufferPointer(), without.GetBufferPointer() + without.GetSize());
                      }),
              testing::HasSubstr("more parts than its header states"));
}

}  // namespace
}  // namespace blockweir::test::large_messages_test
