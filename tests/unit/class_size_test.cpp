// SPDX-License-Identifier: GPL-3.0-or-later
// links: fmt::fmt
// A class is one concept: none has more than 25 functions. A class that is a folder is taken apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <vector>

#include "tests/unit/source_text.hpp"

namespace blockweir::class_size_test {
namespace {

using blockweir::tests::code_of_file;
using blockweir::tests::cpp_files;

constexpr int most_functions = 25;

/// What is left of a declaration without the arguments of its templates and what labels stand before it.
std::string bare(std::string declaration) {
  static const std::regex arguments("<[^<>]*>");
  static const std::regex label(R"(^\s*((public|private|protected):\s*)*)");
  for (std::string before; before != declaration;) {
    before = declaration;
    declaration = std::regex_replace(before, arguments, "");
  }
  return std::regex_replace(declaration, label, "", std::regex_constants::format_first_only);
}

bool is_function(const std::string& declaration) {
  static const std::regex no_member(R"(^(using|friend|static_assert|,|\)).*|.*= (delete|default)\s*$)");
  const auto bracket = declaration.find('(');
  return bracket != std::string::npos && bracket < declaration.find('=') && !std::regex_match(declaration, no_member);
}

/// Functions that each class of a file declares, by its name.
std::map<std::string, int> functions_of_classes(const std::string& text) {
  static const std::regex of_class(R"(.*\b(class|struct) (\w+)[^();=]*)");
  std::map<std::string, int> counts;
  std::vector<std::string> inside;  // of each open brace: the class, or nothing
  std::string declaration;
  for (const char c : text) {
    if (c != '{' && c != '}' && c != ';') {
      declaration += c;
      continue;
    }
    const std::string said = bare(declaration);
    declaration.clear();
    std::smatch found;
    const bool opens_class = c == '{' && std::regex_match(said, found, of_class);
    if (!inside.empty() && !inside.back().empty() && !opens_class && is_function(said)) ++counts[inside.back()];
    if (c == '{') inside.push_back(opens_class ? found[2].str() : "");
    if (c == '}' && !inside.empty()) inside.pop_back();
  }
  return counts;
}

TEST(ClassSize, FunctionsAreCounted) {
  EXPECT_EQ(functions_of_classes(R"(class A : B<int> { public: A(int b) : b_{b}, c_(b) { go(b); }
    A(const A&) = delete; [[nodiscard]] int b() const { return b_; } void d(); private: struct E { void f(); };
    std::function<void()> g; int b_ = h(1); };)"),
            (std::map<std::string, int>{{"A", 3}, {"E", 1}}));
}

TEST(ClassSize, NoClassIsAFolder) {
  for (const auto& file : cpp_files({"bridge", "solid", "fluid", "tests"})) {
    std::string code = code_of_file(file);
    std::replace(code.begin(), code.end(), '\n', ' ');
    for (const auto& [name, count] : functions_of_classes(code)) {
      EXPECT_LE(count, most_functions) << name << " in " << file;
    }
  }
}

}  // namespace
}  // namespace blockweir::class_size_test
