#!/usr/bin/env bash
# The installed headers: nothing but spoke/ in the include folder, which includes nothing but itself,
# the standard library and Eigen; each compiles alone, without warnings.
#   headers.sh INCLUDE_DIR WORK COMPILER EIGEN_DIR
set -u
include=$1 work=$2 compiler=$3 eigen=$4
failures=0
fail() { printf '%s\n' "$*"; failures=$((failures + 1)); }

[ "$(ls "$include")" = spoke ] || fail "besides spoke/ there are in $include: $(ls "$include")"
[ -f "$include/spoke/spoke.h" ] || fail "there is no spoke/spoke.h"
cd "$include" || exit 1
# Most of the time would go into reading Eigen: precompiled, for headers that include it by themselves
# or by others, before anything of their own.
rm -rf "$work"
mkdir -p "$work"
flags=(-std=c++20 -Wall -Wextra -Wpedantic -Wshadow -Werror -I"$include" -isystem "$eigen")
echo '#include <Eigen/Core>' >"$work/eigen.h"
"$compiler" "${flags[@]}" -x c++-header "$work/eigen.h" -o "$work/eigen.h.gch" || fail "Eigen does not compile"
with_eigen=$(grep -rl '<Eigen/Core>' spoke | sort)
while
  more=$(grep -rlF -f <(sed 's/.*/"&"/' <<<"$with_eigen") spoke | sort -u - <(echo "$with_eigen"))
  [ "$more" != "$with_eigen" ]
do with_eigen=$more; done
for header in $(find spoke -name '*.h'); do
  # A name in <> is Eigen's or, without folder and ending, the standard library's.
  foreign=$(grep -E '^ *# *include' "$header" | grep -vE '<(Eigen/[A-Za-z]+|[a-z_]+)>|"spoke/[a-z_/0-9]+\.h"')
  [ -z "$foreign" ] || fail "$header includes: $foreign"
  first=()
  ! grep -qxF "$header" <<<"$with_eigen" || first=(-include "$work/eigen.h")
  echo "#include <$header>" |
    "$compiler" "${flags[@]}" "${first[@]}" -fsyntax-only -x c++ - || fail "$header does not compile alone"
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
