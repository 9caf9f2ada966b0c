// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_results bridge_vtk
// Parts of blockweir that a program opens when it needs them: where they are, and what is said if they are not.
#include "bridge/results/shared_library.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "bridge/vtk/xml.hpp"

namespace blockweir::results {
namespace {

std::string refusal(const char* library, const char* name) {
  try {
    (void)symbol_of(library, name);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(SharedLibrary, ThatIsMissingGivesOneLineThatNamesIt) {
  const std::string line = refusal("libblockweir_none.so", "f");
  EXPECT_THAT(line, testing::StartsWith("cannot open a part of blockweir: libblockweir_none.so: "));
  EXPECT_THAT(line, testing::HasSubstr("; build or install all of it"));
  EXPECT_THAT(line, testing::Not(testing::HasSubstr("\n")));
}

TEST(SharedLibrary, WithoutTheSymbolGivesOneLineThatNamesBoth) {
  const std::string line = refusal(vtk::xml_library, "no_such_symbol");
  EXPECT_THAT(line, testing::HasSubstr(vtk::xml_library));
  EXPECT_THAT(line, testing::HasSubstr("no_such_symbol"));
}

TEST(SharedLibrary, IsFoundFromAProgramOfTheBuild) {
  EXPECT_EQ(refusal(vtk::xml_library, vtk::xml_function), "");
}

}  // namespace
}  // namespace blockweir::results
