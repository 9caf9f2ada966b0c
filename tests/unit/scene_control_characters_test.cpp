// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// No text of a scene holds a character that a terminal obeys, or that ends a line of a table.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "bridge/scene/read/read.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene::scene_control_characters_test {
namespace {

/// What the reader says of the sample with `text` in place of `instead`; empty where that is sound.
std::string said(const std::string& instead, const std::string& text, const std::vector<std::string>& set = {}) {
  std::string spoilt = sample::text;
  spoilt.replace(spoilt.find(instead), instead.size(), text);
  try {
    read_text(spoilt, "s.toml", set);
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

TEST(ControlCharacters, AreRefusedWithTheirLineInEachName) {
  for (unsigned code = 0; code < 0xa0; ++code) {
    const std::string name = fmt::format(R"(name = "ba\u{:04X}se")", code);
    if ((code >= 0x20 && code < 0x7f)) continue;
    const std::string words = said(R"(name = "base")", name);
    EXPECT_THAT(words, testing::HasSubstr(fmt::format("s.toml:20: error: the control character U+{:04X} in the "
                                                      "text of name",
                                                      code)));
    for (const char c : words) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n') << code;
  }
}

TEST(ControlCharacters, AreRefusedInTitlesKeysAndSettings) {
  EXPECT_THAT(said(R"(title = "sample")", R"(title = "two\nlines")"),
              testing::HasSubstr("U+000A in the text of title"));
  EXPECT_THAT(said(R"(title = "sample")", R"("a\u0007" = 1)"), testing::HasSubstr("U+0007 in the key \"a?\""));
  EXPECT_THAT(said("sample", "sample", {R"(title="a\u001b[31m")"}), testing::HasSubstr("U+001B in the text of title"));
}

TEST(ControlCharacters, ANoteMayHaveLinesAndAllOthersArePlainText) {
  EXPECT_EQ(said(R"(note = "made up")", R"(note = "made\n\tup")"), "");
  EXPECT_THAT(said(R"(note = "made up")", R"(note = "made\u0007up")"),
              testing::HasSubstr("U+0007 in the text of note"));
  EXPECT_EQ(said(R"(title = "sample")", "title = 'a\"`$(x)` äß–水'"), "");
}

}  // namespace
}  // namespace blockweir::scene::scene_control_characters_test
