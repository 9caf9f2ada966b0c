// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that are written with a decimal comma, as many languages do and TOML does not.
#pragma once

#include <string>

namespace blockweir::scene {

/// "write 2.5 with a decimal point" for the value "2,5"; empty for any other text.
std::string remedy_of_decimal_comma(const std::string& value);
/// The same for the first such value of a line of a file, "key = 2,5".
std::string remedy_of_decimal_comma_in(const std::string& line);

}  // namespace blockweir::scene
