#!/usr/bin/env bash
# The installed headers: nothing but spoke/ in the include folder, which includes nothing but itself,
# the standard library and Eigen; each compiles alone, without warnings.
#   headers.sh INCLUDE_DIR COMPILER EIGEN_DIR
set -u
include=$1 compiler=$2 eigen=$3
failures=0
fail() { printf '%s\n' "$*"; failures=$((failures + 1)); }

[ "$(ls "$include")" = spoke ] || fail "besides spoke/ there are in $include: $(ls "$include")"
[ -f "$include/spoke/spoke.h" ] || fail "there is no spoke/spoke.h"
cd "$include" || exit 1
for header in $(find spoke -name '*.h'); do
  # A name in <> is Eigen's or, without folder and ending, the standard library's.
  foreign=$(grep -E '^ *# *include' "$header" | grep -vE '<(Eigen/[A-Za-z]+|[a-z_]+)>|"spoke/[a-z_/0-9]+\.h"')
  [ -z "$foreign" ] || fail "$header includes: $foreign"
  echo "#include <$header>" |
    "$compiler" -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wshadow -Werror -x c++ \
      -I"$include" -isystem "$eigen" - || fail "$header does not compile alone"
done
# Whatever the headers bring along: no header of a runtime or of another library, and none of the
# standard library's that take long to compile and that Eigen does without.
slow='filesystem|iostream|regex|chrono|thread|future|format'
brought=$(echo '#include <spoke/spoke.h>' |
  "$compiler" -std=c++20 -E -x c++ -I"$include" -isystem "$eigen" - |
  grep -oE '^# [0-9]+ "[^"]*/((oneapi|tbb|toml\+\+|spdlog|fmt|nlohmann|CLI)/[^"]*|(omp|zlib)\.h|c\+\+/[0-9.]*/'"($slow)"')"' |
  sort -u)
[ -z "$brought" ] || fail "<spoke/spoke.h> brings along: $brought"
exit $((failures > 0))
