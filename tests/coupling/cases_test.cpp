// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Every case, with its variants and studies, meets its figures.
#include <algorithm>

#include "tests/processes.hpp"

namespace blockweir::test {
namespace {

std::vector<std::string> all_cases() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(cases)) {
    if (fs::exists(entry.path() / "scene.toml")) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class Cases : public Processes, public testing::WithParamInterface<std::string> {};

TEST_P(Cases, MeetsItsFigures) {
  EXPECT_EQ(shell(programs + "/blockweir validate " + cases + GetParam()), 0) << text("out");
  EXPECT_THAT(text("out"), testing::HasSubstr("all within tolerance"));
}

std::string name_of(const testing::TestParamInfo<std::string>& tested) {
  std::string name = tested.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Of, Cases, testing::ValuesIn(all_cases()), name_of);

}  // namespace
}  // namespace blockweir::test
