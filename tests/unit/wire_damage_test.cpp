// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_channel
// Frames of which a bit, the end or the table is not what was sent.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "bridge/wire/checksum.hpp"
#include "bridge/wire/codec.hpp"
#include "bridge/wire/messages_generated.h"
#include "tests/unit/wire_sample.hpp"

namespace blockweir::wire::wire_damage_test {
namespace {

std::vector<std::uint8_t> sound_frame() {
  const Sent sent(sample_load());
  const auto* bytes = static_cast<const std::uint8_t*>(sent.frame().data);
  return {bytes, bytes + sent.frame().size};
}

void read(const std::vector<std::uint8_t>& bytes) {
  const Part frame{bytes.data(), bytes.size()};
  Load into;
  if (verify(frame) == Kind::load) decode(frame, into);
}

/// What a reader says of bytes that stand before a sound checksum.
std::string refusal_of_table(const std::uint8_t* table, std::size_t size) {
  const std::array<std::uint64_t, 2> trailer{0, checksum(table, size)};
  std::vector<std::uint8_t> bytes(table, table + size);
  const auto* end = reinterpret_cast<const std::uint8_t*>(trailer.data());
  bytes.insert(bytes.end(), end, end + sizeof trailer);
  try {
    read(bytes);
  } catch (const BadMessage& bad) {
    return bad.what();
  }
  return "";
}

TEST(DamagedFrames, WhatHoldsNoTableIsRefused) {
  const std::vector<std::uint8_t> noise(24, 0xa5);
  EXPECT_EQ(refusal_of_table(noise.data(), noise.size()),
            fmt::format("40 bytes that are not a message of protocol {}", protocol_version));
  const std::vector<std::uint8_t> frame = sound_frame();
  EXPECT_THAT(refusal_of_table(frame.data(), 0), testing::StartsWith("16 bytes that are damaged, or not of protocol"));
}

TEST(DamagedFrames, ATableWithoutAMessageIsRefused) {
  flatbuffers::FlatBufferBuilder builder;
  buffer::FinishEnvelopeBuffer(builder, buffer::CreateEnvelope(builder));
  EXPECT_EQ(refusal_of_table(builder.GetBufferPointer(), builder.GetSize()),
            fmt::format("a message of {} bytes without a known body", builder.GetSize() + 16));
}

TEST(DamagedFrames, EveryFlippedBitIsSeen) {
  std::vector<std::uint8_t> bytes = sound_frame();
  ASSERT_NO_THROW(read(bytes));
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    const auto flip = static_cast<std::uint8_t>(1U << bit % 8);
    bytes[bit / 8] ^= flip;
    EXPECT_THROW(read(bytes), BadMessage) << bit;
    bytes[bit / 8] ^= flip;
  }
}

TEST(DamagedFrames, EveryTruncationIsSeen) {
  std::vector<std::uint8_t> bytes = sound_frame();
  while (!bytes.empty()) {
    bytes.pop_back();
    EXPECT_THROW(read(bytes), BadMessage) << bytes.size();
  }
}

}  // namespace
}  // namespace blockweir::wire::wire_damage_test
