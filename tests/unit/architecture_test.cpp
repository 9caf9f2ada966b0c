// SPDX-License-Identifier: GPL-3.0-or-later
// links: fmt::fmt
// The house rules that a compiler does not see: which folder may include which, licences, lengths.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace blockweir::architecture_test {
namespace {

namespace fs = std::filesystem;
const fs::path root = BLOCKWEIR_SOURCE;

struct Source {
  std::string path;  ///< relative to the root
  std::string folder;
  std::vector<std::string> lines;
  std::set<std::string> includes;  ///< folders of this project
};

std::vector<Source> sources(const std::vector<std::string>& tops = {"bridge", "solid", "fluid"}) {
  std::vector<Source> all;
  for (const std::string& top : tops) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const auto ending = entry.path().extension();
      if (ending != ".cpp" && ending != ".hpp") continue;
      Source source{
          fs::relative(entry.path(), root).string(), fs::relative(entry.path().parent_path(), root).string(), {}, {}};
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) {
        source.lines.push_back(line);
        for (const char* part : {"bridge", "solid", "fluid"}) {
          const std::string start = std::string("#include \"") + part + "/";
          if (line.rfind(start, 0) != 0) continue;
          const std::string file = line.substr(10, line.rfind('"') - 10);
          source.includes.insert(fs::path(file).parent_path().string());
        }
      }
      all.push_back(std::move(source));
    }
  }
  return all;
}

std::string top_of(const std::string& folder) {
  return folder.substr(0, folder.find('/'));
}

TEST(Architecture, ArrowsRunOneWay) {
  const std::vector<std::string> order = {"solid/limit",        "solid/block",  "solid/contact", "solid/solve",
                                          "solid/solve/sparse", "solid/step",   "solid/modes",   "solid/watch",
                                          "solid/expect",       "solid/output", "solid/process", "solid/capacity",
                                          "solid/answers",      "solid"};
  const auto rank = [&](const std::string& folder) {
    return std::find(order.begin(), order.end(), folder) - order.begin();
  };
  for (const Source& source : sources()) {
    for (const std::string& to : source.includes) {
      if (top_of(source.folder) == "bridge") EXPECT_EQ(top_of(to), "bridge") << source.path << " includes " << to;
      if (top_of(source.folder) == "solid") EXPECT_NE(top_of(to), "fluid") << source.path << " includes " << to;
      if (top_of(source.folder) == "fluid") EXPECT_NE(top_of(to), "solid") << source.path << " includes " << to;
      if (top_of(source.folder) == "solid" && top_of(to) == "solid") {
        EXPECT_LE(rank(to), rank(source.folder)) << source.path << " includes " << to;
      }
      if (source.folder == "bridge/wire") EXPECT_EQ(to, "bridge/wire") << source.path;
      if (source.folder == "bridge/channel")
        EXPECT_TRUE(to == "bridge/wire" || to == "bridge/results" || to == "bridge/channel")
            << source.path << " includes " << to;
    }
  }
}

/// Else a fluid would need gnuplot, and a picture a solver.
TEST(Architecture, OnlyTheLauncherKnowsStudiesAndPictures) {
  const std::vector<std::string> order = {"bridge/picture",     "bridge/study",  "bridge/validate",
                                          "bridge/reliability", "bridge/report", "bridge/launch"};
  const auto rank = [&](const std::string& folder) { return std::find(order.begin(), order.end(), folder); };
  for (const Source& source : sources()) {
    for (const std::string& to : source.includes) {
      if (rank(to) == order.end()) continue;
      EXPECT_TRUE(rank(source.folder) != order.end() && rank(to) <= rank(source.folder))
          << source.path << " includes " << to;
    }
  }
}

/// What each library and program of the build files links, by its name.
std::map<std::string, std::set<std::string>> links() {
  static const std::regex call(R"((blockweir_library|blockweir_program|target_link_libraries)\(([^)]*)\))");
  std::map<std::string, std::set<std::string>> all;
  for (const char* folder : {"bridge", "bridge/kit", "solid", "fluid"}) {
    std::ostringstream text;
    text << std::ifstream(root / folder / "CMakeLists.txt").rdbuf();
    const std::string calls = text.str();
    for (std::sregex_iterator it(calls.begin(), calls.end(), call), end; it != end; ++it) {
      std::istringstream words((*it)[2].str());
      std::string name;
      words >> name;
      for (std::string word; words >> word;) all[name].insert(word);
    }
  }
  return all;
}

TEST(Architecture, NoProgramButTheLauncherLinksStudiesAndPictures) {
  const std::map<std::string, std::set<std::string>> direct = links();
  const auto reaches = [&](const auto& self, const std::string& from, std::set<std::string>& seen) -> void {
    const auto found = direct.find(from);
    if (found == direct.end()) return;
    for (const std::string& to : found->second) {
      if (seen.insert(to).second) self(self, to, seen);
    }
  };
  for (const auto& [name, unused] : direct) {
    if (name.rfind("blockweir", 0) != 0) continue;  // no program
    std::set<std::string> linked;
    reaches(reaches, name, linked);
    for (const char* top : {"picture", "study", "validate", "reliability", "report", "launch"}) {
      EXPECT_EQ(linked.count(std::string("bridge_") + top) > 0, name == "blockweir") << name << " and " << top;
    }
  }
}

TEST(Architecture, TheReadmeHasEveryFolderOfSourcesOnItsMap) {
  std::ifstream stream(root / "README.md");
  std::set<std::string> on_the_map;
  for (std::string line; std::getline(stream, line);) {
    for (const char* top : {"| bridge/", "| solid/", "| fluid/"}) {
      if (line.rfind(top, 0) == 0) on_the_map.insert(line.substr(2, line.find(' ', 2) - 2));
    }
  }
  std::set<std::string> in_the_tree;
  for (const Source& source : sources()) in_the_tree.insert(source.folder);
  for (const char* inner : {"solid", "fluid"}) in_the_tree.erase(inner);
  EXPECT_EQ(on_the_map, in_the_tree);
}

/// What a type saves stands beside it; the page says why.
TEST(Architecture, ThePageOfCheckpointsListsEveryHeaderThatSavesSomething) {
  std::ifstream stream(root / "bridge/checkpoint/README.md");
  std::set<std::string> on_the_page;
  for (std::string line; std::getline(stream, line);) {
    const auto end = line.find(".hpp |");
    if (line.rfind("| ", 0) == 0 && end != std::string::npos) on_the_page.insert(line.substr(2, end + 2));
  }
  std::set<std::string> saved;
  for (const Source& source : sources()) {
    for (const std::string& line : source.lines) {
      if (line.find("  template <class Archive>") != std::string::npos) saved.insert(source.path);  // of a member
    }
  }
  EXPECT_EQ(on_the_page, saved);
}

TEST(Architecture, NoFoldersIncludeEachOther) {
  std::map<std::string, std::set<std::string>> arrows;
  for (const Source& source : sources()) {
    for (const std::string& to : source.includes) {
      if (to != source.folder) arrows[source.folder].insert(to);
    }
  }
  for (bool grew = true; grew;) {  // transitive closure
    grew = false;
    for (auto& [from, reached] : arrows) {
      for (const std::string& via : std::set<std::string>(reached)) {
        for (const std::string& to : arrows[via]) grew = reached.insert(to).second || grew;
      }
    }
  }
  for (const auto& [from, reached] : arrows) EXPECT_EQ(reached.count(from), 0U) << from << " reaches itself";
}

/// Else an error that both share would not be seen.
TEST(Architecture, TheTestsOwnAnswersUseNothingOfTheProgram) {
  const std::vector<Source> all = sources({"tests/independent"});
  EXPECT_FALSE(all.empty());
  for (const Source& source : all) EXPECT_TRUE(source.includes.empty()) << source.path;
}

/// Two machines' clocks differ, and one may be set while a run goes on: what is measured is time that has passed.
TEST(Architecture, NobodyAsksWhatTimeItIs) {
  for (const Source& source : sources()) {
    for (const std::string& line : source.lines) {
      for (const char* clock :
           {"system_clock", "utc_clock", "gettimeofday", "CLOCK_REALTIME", "std::time(", "localtime"}) {
        EXPECT_EQ(line.find(clock), std::string::npos) << source.path << ": " << line;
      }
    }
  }
}

TEST(Architecture, EverySourceHasItsLicenceAndAReadableLength) {
  for (const Source& source : sources({"bridge", "solid", "fluid", "tests"})) {
    ASSERT_FALSE(source.lines.empty()) << source.path;
    EXPECT_EQ(source.lines.front(), "// SPDX-License-Identifier: GPL-3.0-or-later") << source.path;
    EXPECT_LE(source.lines.size(), 300U) << source.path;
  }
}

}  // namespace
}  // namespace blockweir::architecture_test
