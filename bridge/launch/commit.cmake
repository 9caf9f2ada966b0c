# SPDX-License-Identifier: GPL-3.0-or-later
# Writes HEADER, which says of which commit SOURCE is; leaves it alone while that is the same.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git describe --always --dirty=-changed --abbrev=12 --exclude=* WORKING_DIRECTORY ${SOURCE}
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT commit)
  set(commit "unknown")
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define BLOCKWEIR_COMMIT \"@commit@\"\n" @ONLY)
