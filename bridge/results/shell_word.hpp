// SPDX-License-Identifier: GPL-3.0-or-later
// A name as a shell takes it, for commands that messages suggest.
#pragma once

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cctype>
#include <string>

namespace blockweir::results {

/// The word itself where no shell reads anything into it, else in single quotes. Letters beyond ASCII are letters.
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
