// SPDX-License-Identifier: GPL-3.0-or-later
// The files of page/, embedded in the program by the build.
#pragma once

#include <string>

namespace blockweir::picture {

extern const char* const page_html;   ///< with placeholders @STYLE@, @DATA@ and @SCRIPT@
extern const char* const page_style;  ///< CSS

/// JavaScript: all files, in the order of their dependence.
std::string page_script();

}  // namespace blockweir::picture
