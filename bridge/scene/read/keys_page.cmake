# SPDX-License-Identifier: GPL-3.0-or-later
# Writes SOURCE, a C++ file that holds PAGE, the reference of keys, as a text; leaves it alone while it is the same.
cmake_minimum_required(VERSION 3.25)
file(READ ${PAGE} page)
set(text "#include \"bridge/scene/read/key_homes.hpp\"\n\nnamespace blockweir::scene {\n")
string(APPEND text "const char* const keys_page = R\"page(${page})page\";\n")
file(CONFIGURE OUTPUT ${SOURCE} CONTENT "@text@}  // namespace blockweir::scene\n" @ONLY)
