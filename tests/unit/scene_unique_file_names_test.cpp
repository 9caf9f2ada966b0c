// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Load cases, variants and studies write to files of their names: none may overwrite another's.
#include <random>
#include <set>

#include "bridge/results/file_name.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_unique_file_names_test {
namespace {

using namespace blockweir::scene;
using blockweir::results::file_name;
using testing::HasSubstr;

class OwnFilesOfScenes : public sample::SceneFolder {
 protected:
  std::string table(const std::string& section, const std::string& name) const {
    const std::string kind = section == "study" ? "kind = 'sample'\nruns = 2\nvariable = [{key = "
                                                  "'joint.friction_angle_deg', distribution = 'uniform', from = 20, "
                                                  "to = 30}]\n"
                                                : "set = ['joint.friction_angle_deg=20']\n";
    return "[[" + section + "]]\nname = \"" + name + "\"\n" + kind;
  }
  std::filesystem::path with(const std::string& tables) const { return write("s.toml", sample::text + tables); }
};

TEST(FileNames, KeepLettersOfEveryScript) {
  EXPECT_EQ(file_name("flood, drains blocked"), "flood--drains-blocked");
  EXPECT_EQ(file_name("洪水"), "洪水");
  EXPECT_EQ(file_name("../Überlauf"), "---Überlauf");
}

TEST_F(OwnFilesOfScenes, AreRefusedWhereTwoNamesWouldShareThem) {
  for (const char* section : {"load_case", "variant", "study"}) {
    EXPECT_THAT(error(with(table(section, "flood, a") + table(section, "flood- a"))),
                testing::AllOf(HasSubstr("\"flood- a\" would write to the files of the "),
                               HasSubstr("\"flood, a\" of line 57, which are called \"flood--a\"; expected names that "
                                         "differ in letters or digits; rename one of them")))
        << section;
    EXPECT_NO_THROW(read(with(table(section, "洪水") + table(section, "地震")))) << section;
  }
}

TEST_F(OwnFilesOfScenes, AreRefusedUnderANameThatIsTheProgramsOwn) {
  EXPECT_THAT(error(with(table("load_case", "scene as written"))),
              HasSubstr("s.toml:57: error: a load case is called \"scene as written\", which is the program's own"));
  EXPECT_THAT(error(with(table("study", "orders"))), HasSubstr("which is the program's own"));
}

TEST_F(OwnFilesOfScenes, DifferForAnyNamesThatAreRead) {
  const std::vector<std::string> letters{"a", "B", "1", " ", "-", ",", ".", "/", "_", "é", "洪", "水", "%"};
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  int sound = 0;
  for (int i = 0; i < 60; ++i) {
    std::string tables;
    std::set<std::string> files;
    for (int k = 0; k < 3; ++k) {
      std::string name;
      for (std::size_t length = 1 + below(3); length > 0; --length) name += letters[below(letters.size())];
      files.insert(file_name(name));
      tables += table(i % 2 == 0 ? "load_case" : "study", name);
    }
    const std::string trouble = error(with(tables));
    EXPECT_EQ(trouble.empty(), files.size() == 3) << tables << trouble;
    sound += trouble.empty() ? 1 : 0;
  }
  EXPECT_GT(sound, 10);
  EXPECT_LT(sound, 60);
}

}  // namespace
}  // namespace blockweir::scene_unique_file_names_test
