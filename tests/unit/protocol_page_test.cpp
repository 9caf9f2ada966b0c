// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_channel
// The page of the protocol, for strangers, shows the bytes that are sent, and the version that is.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <fstream>
#include <sstream>

#include "bridge/wire/codec.hpp"
#include "bridge/wire/panels.hpp"

namespace blockweir::wire::protocol_page_test {
namespace {

std::string text_of(const std::string& file) {
  std::ostringstream all;
  all << std::ifstream(std::string(BLOCKWEIR_SOURCE) + "/" + file).rdbuf();
  return all.str();
}

std::string page() {
  return text_of("bridge/wire/README.md");
}

/// Sixteen bytes a row, with what they are where a row begins a part.
std::string dump(const std::uint8_t* bytes, std::size_t from, std::size_t to, const std::string& what) {
  std::string text;
  for (std::size_t row = from; row < to; row += 16) {
    std::string hex;
    std::string letters;
    for (std::size_t i = row; i < std::min(row + 16, to); ++i) {
      hex += fmt::format("{:02x} ", bytes[i]);
      letters += std::isprint(bytes[i]) != 0 ? static_cast<char>(bytes[i]) : '.';
    }
    text += fmt::format("{:4}  {:<48} {:<16}  {}", row, hex, letters, row == from ? what : "");
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

std::string example() {
  Load load;
  load.window = 1;
  load.time_s = load.holds_until_s = 0.02;
  load.upstream_level_m = 22;
  load.downstream_level_m = std::nan("");
  load.cracks_from = 1;
  add_panel(load, 0, 3, 0, 1, 0, 68670);
  flatbuffers::FlatBufferBuilder builder;
  std::vector<Part> parts;
  encode(load, builder, parts);
  const std::uint8_t* bytes = builder.GetBufferPointer();
  const std::size_t size = builder.GetSize();
  const std::size_t trailer = size - 16;
  std::size_t at = trailer - 40;
  std::string text = dump(bytes, 0, at, "table: its root's place, BLKW, ...");
  for (const auto& [what, width] : {std::pair{"edge", 4U},
                                    {"block", 4U},
                                    {"pressure_to_pa (added_mass: none)", 8U},
                                    {"pressure_from_pa", 8U},
                                    {"s_to", 8U},
                                    {"s_from", 8U},
                                    {"length of the columns: 40", 8U},
                                    {"XXH3 of the table, seed 40", 8U}}) {
    text += dump(bytes, at, at + width, what);
    at += width;
  }
  EXPECT_EQ(at, size);
  return text;
}

TEST(ThePageOfTheProtocol, ShowsTheBytesOfALoad) {
  EXPECT_NE(page().find("```\n" + example() + "```"), std::string::npos) << "the page should have\n" << example();
}

TEST(ThePageOfTheProtocol, NamesTheVersionThatIsSent) {
  EXPECT_THAT(page(), testing::HasSubstr(fmt::format("This is protocol {};", protocol_version)));
  EXPECT_THAT(text_of("bridge/kit/python/blockweir_fluid.py"),
              testing::HasSubstr(fmt::format("\nPROTOCOL = {}\n", protocol_version)));
  EXPECT_THAT(page(), testing::HasSubstr("262,144 bytes (2^18)"));
  EXPECT_EQ(smallest_part, 262'144U);
}

}  // namespace
}  // namespace blockweir::wire::protocol_page_test
