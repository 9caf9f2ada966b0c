// SPDX-License-Identifier: GPL-3.0-or-later
// links: fmt::fmt
// A function is read at one glance: none is longer than 60 lines.
#include <gtest/gtest.h>

#include <cctype>
#include <map>

#include "tests/unit/source_text.hpp"

namespace blockweir::function_size_test {
namespace {

using blockweir::tests::code_of_file;
using blockweir::tests::cpp_files;

constexpr int most_lines = 60;

/// Whether a brace after this text opens the body of a function.
bool begins_function(const std::string& declaration) {
  const std::size_t bracket = declaration.find('(');
  return bracket != std::string::npos && declaration.find('=') > bracket && declaration.back() != '(';
}

/// Whether the brace initializes a member in a constructor's list: ": a_{b}".
bool initializes_member(const std::string& declaration) {
  const char last = declaration.empty() ? ' ' : declaration.back();
  const std::size_t bracket = declaration.find(')');
  return (std::isalnum(static_cast<unsigned char>(last)) != 0 || last == '_' || last == '>') &&
         bracket != std::string::npos && declaration.find(" : ", bracket) != std::string::npos;
}

/// Lines of each outermost function, by the line in which it begins.
std::map<int, int> lines_of_functions(const std::string& code) {
  std::map<int, int> lines;
  std::string declaration;
  int line = 1;
  int begin = 1;  // of the declaration
  int depth = 0;  // of braces within a function, a member's initializer among them
  bool inside = false;
  bool directive = false;  // of the preprocessor
  for (const char c : code) {
    line += c == '\n' ? 1 : 0;
    directive = depth == 0 && (c == '#' || (directive && c != '\n'));
    if (directive) continue;
    if (c == '{') {
      if (inside || depth > 0 || initializes_member(declaration)) {
        ++depth;
      } else if (begins_function(declaration)) {
        inside = true;
        depth = 1;
      } else {
        declaration.clear();
      }
    } else if (c == '}' && depth > 0) {
      if (--depth == 0 && inside) {
        lines[begin] = line - begin + 1;
        inside = false;
        declaration.clear();
      }
    } else if (c == '}' || (c == ';' && depth == 0)) {
      declaration.clear();
    } else if (depth == 0) {
      if (declaration.empty() && std::isspace(static_cast<unsigned char>(c)) != 0) continue;
      if (declaration.empty()) begin = line;
      declaration += c;
    }
  }
  return lines;
}

TEST(FunctionSize, LinesAreCounted) {
  EXPECT_EQ(
      lines_of_functions("namespace a {\nstruct B {\n  B() : b_{1},\n        c_(2) {\n    if (b_) { c_ = 3; }\n  }\n"
                         "  int b_ = f({1});\n};\nint g(int x) {\n  return [&] { return x; }();\n}\n}\n"),
      (std::map<int, int>{{3, 4}, {9, 3}}));
}

TEST(FunctionSize, NoFunctionIsLongerThanAPage) {
  std::size_t functions = 0;
  for (const auto& file : cpp_files({"bridge", "solid", "fluid", "tests"})) {
    for (const auto& [line, lines] : lines_of_functions(code_of_file(file))) {
      EXPECT_LE(lines, most_lines) << file << ":" << line;
      ++functions;
    }
  }
  EXPECT_GT(functions, 5000U);  // else they are not found
}

}  // namespace
}  // namespace blockweir::function_size_test
