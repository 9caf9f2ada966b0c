// SPDX-License-Identifier: GPL-3.0-or-later
// C++ sources of the project without comments and literals, for tests of house rules.
#pragma once

#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace blockweir::tests {

/// The text with comments, strings and characters emptied; line ends stay, so that lines keep their numbers.
inline std::string code_of(const std::string& text) {
  std::string code;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto skip_to = [&](std::size_t end) {
      for (; i < end && i < text.size(); ++i) code += text[i] == '\n' ? "\n" : "";
      --i;
    };
    if (text.compare(i, 2, "//") == 0) {
      skip_to(text.find('\n', i));
    } else if (text.compare(i, 2, "R\"") == 0) {
      const std::size_t bracket = text.find('(', i);
      const std::string end = ")" + text.substr(i + 2, bracket - i - 2) + "\"";
      skip_to(text.find(end, bracket) + end.size());
    } else if (c == '"' || (c == '\'' && (i == 0 || std::isxdigit(static_cast<unsigned char>(text[i - 1])) == 0))) {
      std::size_t end = i + 1;
      while (end < text.size() && text[end] != c) end += text[end] == '\\' ? 2 : 1;
      skip_to(end + 1);
    } else {
      code += c;
    }
  }
  return code;
}

/// All C++ files below these folders of the project.
inline std::vector<std::filesystem::path> cpp_files(const std::vector<std::string>& folders) {
  std::vector<std::filesystem::path> files;
  for (const std::string& folder : folders) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(BLOCKWEIR_SOURCE) / folder)) {
      if (entry.path().extension() == ".hpp" || entry.path().extension() == ".cpp") files.push_back(entry.path());
    }
  }
  return files;
}

inline std::string code_of_file(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return code_of(text.str());
}

}  // namespace blockweir::tests
