#!/usr/bin/env bash
# Builds the project outside/ against an installed Spoke, and runs it.
#   outside.sh cmake|pkg-config PREFIX WORK CMAKE COMPILER
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
  pkg-config)
    PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name spoke.pc)")
    export PKG_CONFIG_PATH
    # shellcheck disable=SC2046 # the flags are words
    "$compiler" -std=c++20 "$source/main.cpp" -o "$work/outside" $(pkg-config --cflags --libs spoke)
    models=$(pkg-config --variable=modelsdir spoke)
    [ -f "$models/wu_haug_rotor.toml" ] || { echo "modelsdir of spoke.pc: $models"; exit 1; }
    ;;
  *) exit 2 ;;
esac
library=$(find "$prefix" -name 'libspoke.so*' -print -quit)
export LD_LIBRARY_PATH=${library:+$(dirname "$library")}
"$work/outside" "$prefix/share/spoke/models/wu_haug_rotor.toml"
