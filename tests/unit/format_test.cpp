// SPDX-License-Identifier: GPL-3.0-or-later
// Sources are as clang-format 14 writes them by the settings of the repository.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace blockweir::format_test {
namespace {

constexpr const char* folders = "bridge solid fluid tests";

TEST(Format, SourcesAreAsClangFormatWritesThem) {
  ASSERT_EQ(std::system("clang-format --version | grep -q 'version 14'"), 0)
      << "expected clang-format 14, as \"./blockweir test\" installs it: others write some lines otherwise";
  const std::string check = std::string("cd '" BLOCKWEIR_SOURCE "' && find ") + folders +
                            " -name '*.[ch]pp' -print0 | xargs -0 -n 100 -P 2 clang-format --dry-run -Werror";
  EXPECT_EQ(std::system(check.c_str()), 0) << "clang-format -i puts the files named above right";
}

}  // namespace
}  // namespace blockweir::format_test
