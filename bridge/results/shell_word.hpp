// SPDX-License-Identifier: GPL-3.0-or-later
// Quotes a word for the shell, in commands that messages suggest.
#pragma once

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cctype>
#include <string>

namespace blockweir::results {

/// The word itself if the shell reads it literally, otherwise in single quotes. Letters beyond ASCII count as letters.
inline std::string shell_word(const std::string& word) {
  const auto plain = [](unsigned char c) {
    constexpr unsigned char last_ascii = 0x7f;
    return c > last_ascii || std::isalnum(c) != 0 ||
           std::string("._/-+=:@%,").find(static_cast<char>(c)) != std::string::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
  return "'" + boost::replace_all_copy(word, "'", "'\\''") + "'";
}

}  // namespace blockweir::results
