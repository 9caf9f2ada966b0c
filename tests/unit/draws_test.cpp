// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_study
// What a sample that is read from a file sets its keys to; coupling/probability_test.cpp has what is drawn.
#include "bridge/study/draws.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "bridge/scene/diagnostic.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::study::draws_test {
namespace {

using testing::HasSubstr;

class DrawnSettings : public test::OwnFolder {
 protected:
  [[nodiscard]] std::vector<Settings> drawn(scene::Sample sample) const {
    return drawn_settings({.name = "s", .line = 7, .question = std::move(sample)}, folder / "scene.toml");
  }
  [[nodiscard]] std::string refusal(const std::string& csv, int runs = 0) const {
    std::ofstream(folder / "v.csv") << csv;
    try {
      (void)drawn({.runs = runs, .file = "v.csv", .variables = {{.key = "a.b", .column = "phi"}}});
    } catch (const scene::SceneError& error) {
      return error.what();
    }
    return "none";
  }
};

TEST_F(DrawnSettings, AHeadingWithANameTwiceIsRefused) {
  EXPECT_THAT(refusal("phi,phi2,phi\n1,2,3\n"),
              HasSubstr("line 1 of v.csv, its heading, has \"phi\" twice; expected each column's name once"));
  EXPECT_EQ(refusal("phi,,\n1,,\n"), "none") << "columns without a name, as a spreadsheet leaves them";
}

TEST_F(DrawnSettings, ComeFromAFileAsASpreadsheetWritesIt) {
  std::ofstream(folder / "v.csv") << "\xef\xbb\xbfphi, note\r\n30,\"dry, rough\"\r\n\r\n31.5,wet\r\n";
  scene::Sample sample{.file = "v.csv", .variables = {{.key = "a.b", .column = "phi"}}};
  EXPECT_THAT(drawn(sample), testing::ElementsAre(Settings{"a.b=30"}, Settings{"a.b=31.5"}));
}

TEST_F(DrawnSettings, AFileThatIsWrongIsRefusedAtTheStudy) {
  EXPECT_THAT(refusal("Phi,c\n1,2\n"), testing::AllOf(HasSubstr("scene.toml:7: error: [[study]] \"s\": v.csv has no "
                                                                "column \"phi\"; expected one of Phi, c"),
                                                      HasSubstr("did you mean \"Phi\"?")));
  EXPECT_THAT(refusal("phi,c\n1\n"), HasSubstr("line 2 of v.csv has 1 cell; expected 2"));
  EXPECT_THAT(refusal("phi,c\n,2\n"), HasSubstr("row 1 of v.csv has nothing for \"phi\""));
  EXPECT_THAT(refusal("phi\n"), HasSubstr("has no rows"));
  EXPECT_THAT(refusal("phi\n1\n", 2), HasSubstr("runs = 2, and v.csv has 1 rows"));
  std::filesystem::remove(folder / "v.csv");
  scene::Sample sample{.file = "w.csv", .variables = {{.key = "a", .column = "a"}}};
  EXPECT_THROW((void)drawn(sample), scene::SceneError);
}

}  // namespace
}  // namespace blockweir::study::draws_test
