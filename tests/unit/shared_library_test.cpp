// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_solve
// Parts of blockweir that a program opens when it needs them: where they are, and what is said if they are not.
#include "bridge/results/shared_library.hpp"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace blockweir::results::shared_library_test {
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

/// Folders in which what a library needs is looked for, as it was linked.
std::vector<std::string> folders_searched_by(const char* library) {
  void* const opened = ::dlopen(library, RTLD_LAZY);
  Dl_serinfo size{};
  EXPECT_EQ(::dlinfo(opened, RTLD_DI_SERINFOSIZE, &size), 0);
  std::vector<char> memory(size.dls_size);
  auto& info = *reinterpret_cast<Dl_serinfo*>(memory.data());
  info.dls_size = size.dls_size;
  info.dls_cnt = size.dls_cnt;
  EXPECT_EQ(::dlinfo(opened, RTLD_DI_SERINFO, &info), 0);
  std::vector<std::string> folders;
  for (unsigned i = 0; i < info.dls_cnt; ++i) folders.emplace_back(info.dls_serpath[i].dls_name);
  return folders;
}

// Whoever works in a folder would run the libraries of whoever may write there.
TEST(SharedLibrary, IsNotTakenFromTheCurrentDirectory) {
  EXPECT_THAT(folders_searched_by(sparse_library), testing::Each(testing::StartsWith("/")));
}

}  // namespace
}  // namespace blockweir::results::shared_library_test
