# SPDX-License-Identifier: GPL-3.0-or-later
# Writes SOURCE, a C++ file that holds the files of PAGE as texts; leaves it alone while they are the same.
cmake_minimum_required(VERSION 3.25)
file(READ ${PAGE}/report.html html)
file(READ ${PAGE}/report.css style)
# A text for each script: compilers need not take literals of more than 65,536 characters.
set(scripts "")
foreach(file elements section state chart animation reliability cases page)
  file(READ ${PAGE}/${file}.js text)
  string(APPEND scripts "    R\"page(${text})page\",\n")
endforeach()
set(text "#include \"bridge/report/page_files.hpp\"\n\nnamespace blockweir::picture {\n")
foreach(part html style)
  string(APPEND text "const char* const page_${part} = R\"page(${${part}})page\";\n")
endforeach()
string(APPEND text "std::string page_script() {\n  std::string script;\n  for (const char* file : {\n${scripts}  }) script += file;\n  return script;\n}\n")
file(CONFIGURE OUTPUT ${SOURCE} CONTENT "@text@}  // namespace blockweir::picture\n" @ONLY)
