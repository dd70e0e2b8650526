# Writes OUT, a source file that names the commit of SOURCE_DIR, only when that has changed: nothing else is built
# anew. Without git, or outside of a clone, the commit is unknown and the name empty.
cmake_minimum_required(VERSION 3.24)
execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --dirty=-modified --abbrev=7 --exclude=*
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT
"// Made by cmake/commit.cmake.
#include \"sluice/version.hpp\"

std::string sluice::commit() { return \"@commit@\"; }
")
