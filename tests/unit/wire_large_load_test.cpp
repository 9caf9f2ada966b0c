// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_wire
// Columns that are too large to be copied go over the line as parts of their own.
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "bridge/wire/codec.hpp"

namespace blockweir::wire::wire_large_load_test {
namespace {

/// A load whose columns of doubles are parts, as it goes over the line.
class LargeLoad : public testing::Test {
 protected:
  LargeLoad() {
    for (std::size_t i = 0; i < 40'000; ++i) {
      load.block.push_back(static_cast<std::uint32_t>(i / 4));
      load.edge.push_back(static_cast<std::uint32_t>(i % 4));
      load.s_from.push_back(0);
      load.s_to.push_back(1);
      load.pressure_from_pa.push_back(static_cast<double>(i));
      load.pressure_to_pa.push_back(static_cast<double>(i + 1));
    }
    load.cracks_from = 40'000;
    load.window = 17;
    send();
  }
  void send() { encode(load, builder, parts); }
  [[nodiscard]] Load received() {
    const Part frame{builder.GetBufferPointer(), builder.GetSize()};
    EXPECT_EQ(verify(frame), Kind::load);
    Load into;
    std::size_t next = 0;
    decode(frame, into, [&] { return next < parts.size() ? parts[next++] : Part(); });
    EXPECT_EQ(next, parts.size());
    return into;
  }
  [[nodiscard]] std::string refusal() {
    try {
      (void)received();
    } catch (const BadMessage& bad) {
      return bad.what();
    }
    return "";
  }
  /// The part's bytes, to be changed, in place of the part.
  std::vector<double>& altered(std::size_t part) {
    const auto* first = static_cast<const double*>(parts[part].data);
    auto own = std::make_shared<std::vector<double>>(first, first + parts[part].size / sizeof(double));
    parts[part] = {own->data(), parts[part].size, own};
    return *own;
  }

  Load load;
  flatbuffers::FlatBufferBuilder builder;
  std::vector<Part> parts;
};

TEST_F(LargeLoad, IsSentFromWhereItStandsAndReadWhereItArrives) {
  ASSERT_EQ(parts.size(), 4U);  // 320 kB each; the whole numbers' 160 kB go in the first frame
  EXPECT_EQ(parts[0].data, load.s_from.data());
  const Load got = received();
  EXPECT_EQ(got.block, load.block);
  EXPECT_EQ(got.edge, load.edge);
  EXPECT_EQ(got.s_from, load.s_from);
  EXPECT_EQ(got.s_to, load.s_to);
  EXPECT_EQ(got.pressure_from_pa, load.pressure_from_pa);
  EXPECT_EQ(got.pressure_to_pa, load.pressure_to_pa);
  EXPECT_EQ(got.pressure_to_pa.data(), parts[3].data);
}

TEST_F(LargeLoad, StaysAsItWasSentWhileItIsOnItsWay) {
  load.pressure_to_pa.own()[7] = -1;  // the next window's
  load.s_from.assign(3, 0.5);
  load.s_to.clear();
  const Load got = received();
  EXPECT_EQ(got.pressure_to_pa[7], 8);
  EXPECT_EQ(got.s_from.size(), 40'000U);
  EXPECT_EQ(got.s_to.size(), 40'000U);
  const double* before = load.pressure_to_pa.data();
  load.pressure_to_pa.own()[7] = -2;  // nobody else has these
  EXPECT_EQ(load.pressure_to_pa.data(), before);
}

TEST_F(LargeLoad, DamagedIsRefused) {
  altered(2)[30'000] += 1;
  EXPECT_EQ(refusal(), "320000 bytes that are damaged, or not the pressure_from_pa of window 17");
}

TEST_F(LargeLoad, OutOfOrderIsRefused) {
  std::swap(parts[2], parts[3]);
  EXPECT_EQ(refusal(), "320000 bytes that are damaged, or not the pressure_from_pa of window 17");
}

TEST_F(LargeLoad, CutShortIsRefused) {
  parts[3].size -= 8;
  EXPECT_EQ(refusal(), "319992 bytes of pressure_to_pa where 320000 were due, in window 17");
}

TEST_F(LargeLoad, WithoutAPartIsRefused) {
  parts.pop_back();
  EXPECT_EQ(refusal(), "no pressure_to_pa in window 17");
}

TEST_F(LargeLoad, ANumberThatCannotBeIsNamed) {
  load.pressure_to_pa.own()[39'999] = std::numeric_limits<double>::infinity();
  send();
  EXPECT_EQ(refusal(), "pressure of panel 39999 (block 9999, edge 3) is inf in window 17");
  load.pressure_to_pa.own()[39'999] = 0;
  load.s_from.own()[1] = -0.5;
  send();
  EXPECT_EQ(refusal(), "end of panel 1 (block 0, edge 1) is -0.5 in window 17");
}

}  // namespace
}  // namespace blockweir::wire::wire_large_load_test
