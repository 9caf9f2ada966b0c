// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_expect
// What "Write your own fluid in a page" lists is there; all figures that [[expect]] knows are listed; every case is in
// the gallery, and every link leads somewhere.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "bridge/scene/water_quantities.hpp"
#include "solid/expect/formulas.hpp"
#include "solid/expect/quantities.hpp"

namespace blockweir::documents_test {
namespace {

namespace fs = std::filesystem;
const fs::path root = BLOCKWEIR_SOURCE;

std::string text_of(const fs::path& file) {
  std::ostringstream all;
  all << std::ifstream(file).rdbuf();
  return all.str();
}

std::string section(const std::string& document, const std::string& heading) {
  const std::string all = text_of(root / document);
  const auto from = all.find("## " + heading);
  if (from == std::string::npos) return {};
  return all.substr(from, all.find("\n## ", from) - from);
}

/// Between backticks.
std::vector<std::string> quoted(const std::string& text) {
  std::vector<std::string> all;
  const std::regex code("`([^`]+)`");
  for (std::sregex_iterator i(text.begin(), text.end(), code), end; i != end; ++i) {
    all.push_back(std::regex_replace((*i)[1].str(), std::regex("\\s+"), " "));
  }
  return all;
}

TEST(Documents, AFluidOfOnesOwnFindsAllThatItIsTold) {
  const std::string page = section("fluid/column/README.md", "Write your own fluid in a page");
  ASSERT_FALSE(page.empty());
  std::string sources;
  int files = 0;
  for (const std::string& word : quoted(page)) {
    if (word.find('/') == std::string::npos || word.find(' ') != std::string::npos) continue;
    ++files;
    EXPECT_TRUE(fs::exists(root / word)) << word;
    if (fs::is_regular_file(root / word)) sources += text_of(root / word);
  }
  EXPECT_GE(files, 10);
  sources += text_of(root / "bridge/wire/message.hpp") + text_of(root / "bridge/schedule/run.hpp");
  for (std::string word : quoted(page)) {
    if (word.find('/') != std::string::npos || word.find(' ') != std::string::npos || word.front() == '[') continue;
    word = word.substr(0, word.find('('));
    word = word.substr(word.rfind(':') == std::string::npos ? 0 : word.rfind(':') + 1);
    word = word.substr(word.rfind('.') == std::string::npos ? 0 : word.rfind('.') + 1);
    EXPECT_THAT(sources, testing::HasSubstr(word));
  }
}

TEST(Documents, TheCountOfFilesThatAnAdditionTakesIsThatOfTheFilesNamed) {
  std::istringstream rows(section("bridge/README.md", "To add something"));
  const std::regex row_of("\\| an? ([^|]+) \\| ([0-9]+)[^|]*\\| (.*) \\|");
  int counted = 0;
  for (std::string row; std::getline(rows, row);) {
    std::smatch cells;
    if (!std::regex_match(row, cells, row_of)) continue;
    ++counted;
    const std::vector<std::string> files = quoted(cells[3]);
    EXPECT_EQ(static_cast<std::size_t>(std::stoi(cells[2])), files.size()) << row;
    for (const std::string& file : files) {
      const bool pattern = file.find("NAME") != std::string::npos || file.find('*') != std::string::npos;
      const bool there = fs::exists(root / file) || fs::exists(root / "bridge" / file);
      EXPECT_TRUE(pattern || there) << file;
    }
  }
  EXPECT_EQ(counted, 6);
}

/// In the first column of the table whose heading begins so.
std::multiset<std::string> listed(const std::string& heading) {
  const std::string all = text_of(root / "bridge/scene/KEYS.md");
  const auto from = all.find("| " + heading + " |");
  std::istringstream rows(all.substr(from, all.find("\n\n", from) - from));
  std::multiset<std::string> names;
  for (std::string row; std::getline(rows, row);) {
    for (const std::string& name : quoted(row.substr(0, row.find('|', 1)))) names.insert(name);
  }
  return names;
}

TEST(Documents, AllFiguresThatCanBeExpectedAreListedOnce) {
  namespace expect = blockweir::solid::expect;
  auto quantities = expect::quantity_names();
  quantities.insert(quantities.end(), {"invariants", "mode", "stability"});  // those that are words
  EXPECT_THAT(listed("quantity | of"), testing::UnorderedElementsAreArray(quantities));
  auto formulas = expect::formula_names();
  formulas.insert(formulas.end(), {"slide-or-topple", "schedule-stability"});
  EXPECT_THAT(listed("formula | of"), testing::UnorderedElementsAreArray(formulas));
  std::vector<std::string> of_water;
  for (const auto& quantity : blockweir::scene::water_quantities) of_water.emplace_back(quantity.name);
  EXPECT_THAT(listed("figure of the water | needs"), testing::UnorderedElementsAreArray(of_water));
}

/// A whole number with commas in it, in the first match.
int number_in(const std::string& text, const std::string& pattern) {
  std::smatch found;
  if (!std::regex_search(text, found, std::regex(pattern))) return -1;
  return std::stoi(std::regex_replace(found[1].str(), std::regex(","), ""));
}

TEST(Documents, CellsOfTheMapsOfStabilityAreCountedTheSameEverywhere) {
  const std::string page = text_of(root / "cases/stress/README.md");
  const auto from = page.find("| scene | keys |");
  ASSERT_NE(from, std::string::npos);
  int cells = 0;
  std::istringstream rows(page.substr(from, page.find("\n\n", from) - from));
  for (std::string row; std::getline(rows, row);) cells += std::max(0, number_in(row, "\\| ([0-9]+) \\|$"));
  EXPECT_EQ(number_in(page, "Of ([0-9,]+) cells"), cells);
  EXPECT_EQ(number_in(text_of(root / "cases/README.md"), "Maps of stability: ([0-9,]+) runs"), cells);
}

TEST(Documents, TheGalleryShowsEveryCaseOnce) {
  std::multiset<std::string> shown;
  const std::string gallery = text_of(root / "cases/README.md");
  const std::regex entry(
      "!\\[[a-z0-9-]+\\]\\([a-z0-9-]+/[a-z]+\\.png\\) \\| "
      "\\*\\*\\[([a-z0-9-]+)\\]\\(([a-z0-9-]+)/README\\.md\\)\\*\\*");
  for (std::sregex_iterator i(gallery.begin(), gallery.end(), entry), end; i != end; ++i) {
    EXPECT_EQ((*i)[1], (*i)[2]);
    shown.insert((*i)[1]);
  }
  std::multiset<std::string> folders;
  for (const auto& folder : fs::directory_iterator(root / "cases")) {
    if (folder.is_directory()) folders.insert(folder.path().filename());
  }
  EXPECT_EQ(shown, folders);
}

std::vector<fs::path> documents() {
  std::vector<fs::path> all;
  for (const auto& file : fs::directory_iterator(root)) {
    if (file.path().extension() == ".md") all.push_back(file.path());
  }
  for (const char* top : {"bridge", "solid", "fluid", "cases", "tests"}) {
    for (const auto& file : fs::recursive_directory_iterator(root / top)) {
      if (file.path().extension() == ".md") all.push_back(file.path());
    }
  }
  return all;
}

/// The names that a page's headings have as targets of links.
std::set<std::string> anchors_of(const std::string& text) {
  std::set<std::string> all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("#")) continue;
    std::string anchor;
    for (const char c : line.substr(line.find(' ') + 1)) {
      if (c == ' ') anchor += '-';
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_')
        anchor += static_cast<char>(std::tolower(c));
    }
    all.insert(anchor);
  }
  return all;
}

TEST(Documents, HeadingsAndTablesAreWhole) {
  const std::regex heading("#+ \\S.*");
  const std::regex rule("\\|( *:?-+:? *\\|)+");
  for (const fs::path& page : documents()) {
    std::istringstream lines(text_of(page));
    bool in_code = false;
    int row = 0;  // of the table that the line is in
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("```")) in_code = !in_code;
      if (in_code || line.starts_with("    ")) continue;
      if (line.starts_with("#")) EXPECT_TRUE(std::regex_match(line, heading)) << page << ": " << line;
      row = line.starts_with("|") ? row + 1 : 0;
      if (row == 2) EXPECT_TRUE(std::regex_match(line, rule)) << page << ": " << line;
      EXPECT_FALSE(line.find("-- -") != std::string::npos) << page << ": " << line;
    }
  }
}

TEST(Documents, EveryLinkLeadsSomewhere) {
  const std::regex link("\\]\\(([^)# ]*)(#([^) ]+))?\\)");
  for (const fs::path& page : documents()) {
    const std::string text = text_of(page);
    for (std::sregex_iterator i(text.begin(), text.end(), link), end; i != end; ++i) {
      if ((*i)[1].str().starts_with("http")) continue;
      const fs::path target = (*i)[1].length() == 0 ? page : page.parent_path() / (*i)[1].str();
      EXPECT_TRUE(fs::exists(target)) << page << ": " << (*i)[0];
      if ((*i)[3].matched) EXPECT_EQ(anchors_of(text_of(target)).count((*i)[3]), 1U) << page << ": " << (*i)[0];
    }
  }
}

}  // namespace
}  // namespace blockweir::documents_test
