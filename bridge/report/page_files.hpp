// SPDX-License-Identifier: GPL-3.0-or-later
// The files of page/, as the build puts them into the program.
#pragma once

namespace blockweir::picture {

extern const char* const page_html;    ///< with @STYLE@, @DATA@ and @SCRIPT@ to be filled in
extern const char* const page_style;   ///< CSS
extern const char* const page_script;  ///< JavaScript: all files, in the order in which they need each other

}  // namespace blockweir::picture
