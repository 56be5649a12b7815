#!/usr/bin/env bash
# Where Spoke's own programs share the library of the engine (preset package), MAP says which names it
# shows: all that programs, commands and the Python module of this build take from the engine's archives
# must be among them.
#   exports.sh BUILD MAP
set -euo pipefail
build=$1 map=$2
cd "$build"
patterns=$(sed -nE '/global:/,/local:/s/^ *(_Z[A-Za-z0-9]+)\*;$/^\1/p' "$map")
[ -n "$patterns" ] || { echo "$map shows nothing"; exit 1; }
# spoke_fmu.so has the archives in itself.
objects=$(find program bench python -name '*.o' -not -path '*/spoke_fmu_library.dir/*')
# shellcheck disable=SC2086 # names of files without spaces
taken=$(comm -12 <(nm -P --defined-only {graph,models,engine}/*.a 2>/dev/null | awk 'NF > 2 { print $1 }' | sort -u) \
  <(nm -P --undefined-only $objects 2>/dev/null | awk '$2 == "U" { print $1 }' | sort -u))
[ "$(wc -l <<<"$taken")" -gt 100 ] || { echo "found too few names that programs take: $taken"; exit 1; }
if hidden=$(grep -vE "$patterns" <<<"$taken"); then
  printf 'not shown by %s:\n%s\n' "$map" "$(c++filt <<<"$hidden")"
  exit 1
fi
