#!/usr/bin/env bash
# Builds the project outside/, or the installed examples, against an installed Spoke, and runs it.
#   outside.sh cmake|pkg-config|examples PREFIX WORK CMAKE COMPILER
set -euo pipefail
way=$1 prefix=$2 work=$3 cmake=$4 compiler=$5
source=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/outside
rm -rf "$work"
mkdir -p "$work"
case $way in
  cmake)
    "$cmake" -S "$source" -B "$work" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$prefix"
    "$cmake" --build "$work"
    ;;
  examples)
    "$cmake" -S "$prefix/share/doc/spoke/examples" -B "$work" -DCMAKE_CXX_COMPILER="$compiler" \
      -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DCMAKE_PREFIX_PATH="$prefix"
    "$cmake" --build "$work"
    for example in "$prefix"/share/doc/spoke/examples/*.cpp; do
      "$work/example_$(basename "$example" .cpp)"
    done
    exit
    ;;
  pkg-config)
    PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name spoke.pc)")
    export PKG_CONFIG_PATH
    # shellcheck disable=SC2046 # the flags are words
    "$compiler" -std=c++20 "$source/main.cpp" -o "$work/outside" $(pkg-config --cflags --libs spoke) \
      -Wl,-rpath,"$(pkg-config --variable=libdir spoke)"
    models=$(pkg-config --variable=modelsdir spoke)
    [ -f "$models/wu_haug_rotor.toml" ] || { echo "modelsdir of spoke.pc: $models"; exit 1; }
    ;;
  *) exit 2 ;;
esac
"$work/outside" "$prefix/share/spoke/models/wu_haug_rotor.toml"
