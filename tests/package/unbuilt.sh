#!/usr/bin/env bash
# `cmake --install` of a build that has not been made says in one line what to do first, and installs
# nothing.
#   unbuilt.sh SOURCE WORK CMAKE COMPILER
set -euo pipefail
source=$1 work=$2 cmake=$3 compiler=$4
rm -rf "$work"
"$cmake" -S "$source" -B "$work/build" -DCMAKE_CXX_COMPILER="$compiler" -DSPOKE_TESTS=OFF >/dev/null
for component in '' development program; do
  if said=$("$cmake" --install "$work/build" --prefix "$work/installed" \
    ${component:+--component "$component"} 2>&1); then
    echo "installed without a build"
    exit 1
  fi
  grep -q "Spoke is not built yet, run first: cmake --build $work/build" <<<"$said" ||
    { printf 'said instead:\n%s\n' "$said"; exit 1; }
  [ ! -e "$work/installed" ] || { echo "installed something"; exit 1; }
done
