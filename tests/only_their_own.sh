#!/usr/bin/env bash
# Of the object files given, only functions of the namespace SET may have instructions that not every processor
# has: what other files share, and what runs when the program starts, must run everywhere.
set -euo pipefail
set_of_instructions=$1
shift
objdump --disassemble --demangle --no-show-raw-insn "$@" | awk -v own="sluice::cpu::$set_of_instructions::" '
  /^[0-9a-f]+ <.*>:$/ { name = $0; foreign = index($0, own) == 0; functions += !foreign; next }
  foreign && /\t(v[a-z]|shlx|shrx|sarx|rorx|mulx|pdep|pext|bzhi|popcnt)|%[yz]mm|%k[0-7]/ { print name ": " $0; bad = 1 }
  END { if (functions == 0) print "no functions of " own; exit bad || functions == 0 }'
