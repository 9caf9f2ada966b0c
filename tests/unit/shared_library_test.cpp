// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_solve
// Parts of blockweir that a program opens when it needs them: where they are, and what is said if they are not.
#include "bridge/results/shared_library.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace blockweir::results {
namespace {

constexpr const char* sparse_library = "libblockweir_sparse.so";

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
  const std::string line = refusal(sparse_library, "no_such_symbol");
  EXPECT_THAT(line, testing::HasSubstr(sparse_library));
  EXPECT_THAT(line, testing::HasSubstr("no_such_symbol"));
}

TEST(SharedLibrary, IsFoundFromAProgramOfTheBuild) {
  EXPECT_EQ(refusal(sparse_library, "blockweir_sparse_solvers"), "");
}

}  // namespace
}  // namespace blockweir::results
