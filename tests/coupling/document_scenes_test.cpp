// SPDX-License-Identifier: GPL-3.0-or-later
// links: fmt::fmt nlohmann_json::nlohmann_json
// The scenes of README.md and of the guide run as they stand, and their commands print what stands below them.
#include <fmt/ranges.h>

#include <regex>

#include "tests/processes.hpp"

namespace blockweir::test::document_scenes_test {
namespace {

std::string page(const std::string& name) {
  std::ostringstream all;
  all << std::ifstream(std::string(BLOCKWEIR_SOURCE) + "/" + name).rdbuf();
  return all.str();
}

/// A command of a page, and the lines that the page says it prints.
struct Said {
  std::string command;
  std::vector<std::string> lines;
};

/// Of commands on files that the page itself has; those in loops are left out.
std::vector<Said> commands_of(const std::string& text) {
  std::vector<Said> all;
  bool within = false;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const std::string own = line.starts_with("    ") ? line.substr(4) : "";
    if (own.starts_with("./blockweir ")) {
      within = own.find(".toml") != std::string::npos || own.find("runs/") != std::string::npos;
      if (within) all.push_back({own.substr(12), {}});
    } else if (!own.empty() && within) {
      all.back().lines.push_back(own);
    } else if (!line.empty()) {
      within = false;
    }
  }
  return all;
}

class DocumentScenes : public Processes, public testing::WithParamInterface<std::string> {
 protected:
  /// Each is called by the last name before it.
  void write_scenes(const std::string& page_text) const {
    const std::regex code("```toml\n([^`]*)```");
    const std::regex name("`([a-z]+\\.toml)`");
    for (std::sregex_iterator i(page_text.begin(), page_text.end(), code), end; i != end; ++i) {
      const std::string before = page_text.substr(0, static_cast<std::size_t>(i->position()));
      std::string file;
      for (std::sregex_iterator n(before.begin(), before.end(), name); n != end; ++n) file = (*n)[1];
      ASSERT_FALSE(file.empty());
      std::ofstream(folder / file) << (*i)[1].str();
    }
  }
};

TEST_P(DocumentScenes, PrintWhatThePageSays) {
  const std::string text_of_page = page(GetParam());
  write_scenes(text_of_page);
  const std::vector<Said> commands = commands_of(text_of_page);
  EXPECT_GE(commands.size(), 1U);
  for (const Said& said : commands) {
    EXPECT_EQ(shell(programs + "/blockweir " + said.command), 0) << said.command << '\n' << text("out");
    // One after the other: a warning between them would be left out by the page.
    EXPECT_THAT(text("out"), testing::HasSubstr(fmt::format("{}", fmt::join(said.lines, "\n")))) << said.command;
  }
}

INSTANTIATE_TEST_SUITE_P(Pages, DocumentScenes, testing::Values("README.md", "cases/GUIDE.md"),
                         [](const auto& tested) { return tested.param == "README.md" ? "Readme" : "Guide"; });

}  // namespace
}  // namespace blockweir::test::document_scenes_test
