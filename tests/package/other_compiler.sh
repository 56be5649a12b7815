#!/usr/bin/env bash
# Builds the program `spoke` by another compiler, not optimised, which is quicker: it ends in the state of
# PROGRAM, to the last bit. Of the rest of the engine and its commands that compiler checks the sources and
# makes no code. Its kernels for wide instructions find vectors in memory where they expect them.
#   other_compiler.sh SOURCE WORK CMAKE COMPILER PROGRAM
set -euo pipefail
source=$1 work=$2 cmake=$3 compiler=$4 program=$5
rm -rf "$work"
"$cmake" -G Ninja -S "$source" -B "$work/build" -DCMAKE_UNITY_BUILD=ON -DCMAKE_CXX_COMPILER="$compiler" \
  -DSPOKE_TESTS=OFF -DSPOKE_EXAMPLES=OFF -DSPOKE_PYTHON=OFF -DSPOKE_MPI=OFF -DSPOKE_VIEWER=OFF \
  -DSPOKE_WARNINGS_AS_ERRORS="${SPOKE_WARNINGS_AS_ERRORS:-OFF}" \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG"
"$cmake" --build "$work/build" --parallel "$(nproc)" --target spoke
scenario=$source/models/wu_haug_rotor.toml
hash_of() {
  "$1" run "$scenario" --instructions baseline --set integration.duration=4 --executor serial \
    --no-report --quiet --out "$work/$2"
  grep '"state_hash"' "$work/$2/summary.json"
}
own=$(hash_of "$program" own)
other=$(hash_of "$work/build/program/cli/spoke" other)
[ "$own" = "$other" ] || { printf 'states differ:\n%s\n%s\n' "$own" "$other"; exit 1; }

"$compiler" -std=c++20 -O1 -Wno-psabi -DDOCTEST_CONFIG_IMPLEMENT_WITH_MAIN -I"$source" -I"$source/package/include" \
  "$source"/{tests/models/air/inverse_fourier_test,models/air/inverse_fourier,models/support/instructions}.cpp \
  -o "$work/inverse_fourier_test"
"$work/inverse_fourier_test"

cd "$work/build"
ninja -t commands spoke-whole | grep ' -c ' | grep -E '/(spoke_analysis|spoke_solids|spoke_steady_report|spoke-whole)\.dir/' |
  sed 's/ -o [^ ]* -c / -fsyntax-only /' >commands
[ "$(wc -l <commands)" -gt 10 ] || { echo "found no sources to check"; exit 1; }
xargs -P "$(nproc)" -d '\n' -n 1 sh -c <commands
