// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of one frame on the line between the two sides.
#pragma once

#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "bridge/wire/codec.hpp"
#include "tests/fault/relay.hpp"

namespace blockweir::test {

template <class Message>
inline Frame altered(const Frame& frame, const std::function<void(Message&)>& alter) {
  std::vector<std::uint64_t> aligned(frame.size() / 8 + 1);
  std::memcpy(aligned.data(), frame.data(), frame.size());
  Message message;
  wire::decode({aligned.data(), frame.size()}, message);
  alter(message);
  flatbuffers::FlatBufferBuilder builder;
  if constexpr (std::is_same_v<Message, wire::Hello>) {
    wire::encode(message, builder);
  } else {
    std::vector<wire::Part> none;
    wire::encode(message, builder, none);
  }
  return {builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize()};
}

/// A fault of one frame and what the receiver says of it.
struct Fault {
  const char* name;
  std::function<std::vector<Frame>(const std::vector<Frame>& sent, std::mt19937& random)> happens;
  const char* says;
};

/// A frame that is sound, but of another scene.
inline std::vector<Frame> foreign(Relay::From from, const Frame& frame) {
  if (from == Relay::From::fluid)
    return {altered<wire::Load>(frame, [](wire::Load& load) { load.block.own().at(0) = 1000; })};
  return {altered<wire::Motion>(frame, [](wire::Motion& motion) {
    motion.displacement.own().emplace_back();
    motion.velocity.own().emplace_back();
  })};
}

inline std::vector<Fault> faults_of(Relay::From from) {
  const auto number = [from](double value) {
    return [from, value](const std::vector<Frame>& sent, std::mt19937&) -> std::vector<Frame> {
      if (from == Relay::From::fluid) {
        return {altered<wire::Load>(sent.back(), [&](wire::Load& load) { load.pressure_from_pa.own().at(0) = value; })};
      }
      return {altered<wire::Motion>(sent.back(),
                                    [&](wire::Motion& motion) { motion.displacement.own().at(0)[0] = value; })};
    };
  };
  const bool pressures = from == Relay::From::fluid;
  return {
      {"truncated",
       [](const std::vector<Frame>& sent, std::mt19937& random) -> std::vector<Frame> {
         return {Frame(sent.back().begin(), sent.back().begin() + static_cast<long>(random() % sent.back().size()))};
       },
       "bytes that are damaged, or not "},
      {"flipped",
       [](const std::vector<Frame>& sent, std::mt19937& random) -> std::vector<Frame> {
         Frame frame = sent.back();
         frame[random() % frame.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
         return {frame};
       },
       "bytes that are damaged, or not "},
      {"replayed",
       [](const std::vector<Frame>& sent, std::mt19937& random) -> std::vector<Frame> {
         return {sent[1 + random() % (sent.size() - 2)]};
       },
       "was due"},
      {"doubled",
       [](const std::vector<Frame>& sent, std::mt19937&) -> std::vector<Frame> {
         return {sent.back(), sent.back()};
       },
       "was due"},
      {"foreign",
       [from](const std::vector<Frame>& sent, std::mt19937&) -> std::vector<Frame> {
         return foreign(from, sent.back());
       },
       pressures ? "loads block 1000, edge" : "sent positions of"},
      {"lost", [](const std::vector<Frame>&, std::mt19937&) { return std::vector<Frame>(); },
       "has been silent for 1 s"},
      {"not a number", number(std::numeric_limits<double>::quiet_NaN()),
       pressures ? "pressure of panel 0 (" : "displacement 0 of block 0 is nan in window"},
      {"infinite", number(-std::numeric_limits<double>::infinity()),
       pressures ? "pressure of panel 0 (" : "displacement 0 of block 0 is -inf in window"}};
}

}  // namespace blockweir::test
