#!/usr/bin/env bash
# Checks who includes whom: the order of tests/include_order.txt, that no two files with their headers
# include each other in a circle, and that libraries stay where they belong.
#   check_includes.sh [ROOT]     ROOT: a tree with folders of $libraries and tests/include_order.txt
set -u
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
cd "${1:-$here/..}" || exit 2
failures=0

# refuse PATTERN REASON FILE...: no file may include a path that matches the pattern.
refuse() {
  local pattern=$1 reason=$2 found
  shift 2
  found=$(grep -nE "#include [\"<]$pattern" "$@" /dev/null)
  [ -z "$found" ] && return
  printf '%s:\n%s\n' "$reason" "$found"
  failures=$((failures + 1))
}

sources() { find "$@" -name '*.h' -o -name '*.cpp' 2>/dev/null; }
libraries='graph models engine program bench'

refuse '(engine|models|program|bench|Eigen)/' 'graph/ knows no physics' $(sources graph)
refuse '(engine|graph|program|bench)/' 'models/ knows neither engine nor graph' $(sources models)
refuse '(program|bench|python|tests|examples)/' 'engine/ knows no user of its' $(sources engine)
refuse '(oneapi/)?tbb/|omp\.h' 'threads belong to graph/' $(sources engine models program)
refuse '(oneapi/)?tbb/|omp\.h' 'no runtime in a header of graph/' $(find graph -name '*.h')
refuse '(toml\+\+|spdlog|CLI|nlohmann)/' 'no library but Eigen in a header, where each source pays for it' \
  $(find $(ls -d models engine graph bench program 2>/dev/null) -name '*.h')

# Rooms and circles. Of each include line of a file of ours: file and header.
grep -HoE "^#include \"(${libraries// /|})/[^\"]*\"" $(sources $libraries) /dev/null |
  sed -E 's/:#include "/ /; s/"$//' |
  awk "$(cat "$here/rooms.awk")"'
    function unit_of(file) { sub(/\.[a-z]+$/, "", file); return file }
    function fail(text) { print text; failed = 1 }
    {
      from = room_of($1); to = room_of($2)
      if (from == "") fail($1 ": belongs to no room of tests/include_order.txt")
      else if (to == "") fail($2 ": belongs to no room of tests/include_order.txt")
      else if (from != to && rank[from] <= rank[to])
        fail($1 " includes " $2 ": " to " is not below " from)
      a = unit_of($1); b = unit_of($2)
      if (a != b && !((a, b) in seen)) { seen[a, b] = 1; targets[a] = targets[a] " " b; unit[a]; unit[b] }
    }
    # Units that include none that is left are no part of a circle.
    END {
      do {
        removed = 0
        for (u in unit) {
          open = 0
          count = split(targets[u], list, " ")
          for (k = 1; k <= count; ++k) if (list[k] in unit) open = 1
          if (!open) { delete unit[u]; removed = 1 }
        }
      } while (removed)
      for (u in unit) fail(u ": part of a circle of includes, or includes one:" targets[u])
      exit failed
    }' tests/include_order.txt - || failures=$((failures + 1))

# Every room exists.
set -f
for room in $(grep -v '^#' tests/include_order.txt); do
  case $room in
    */\*.h) compgen -G "$room" >/dev/null ;;
    */ | *.h) [ -e "$room" ] ;;
    *) [ -e "$room.h" ] || [ -e "$room.cpp" ] ;;
  esac || { echo "tests/include_order.txt: no such room: $room"; failures=$((failures + 1)); }
done
exit $((failures > 0))
