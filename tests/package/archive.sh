#!/usr/bin/env bash
# Builds and installs the static library with link-time optimisation, as the preset package does, and
# links a program with it. The archive must hold machine code alone: a linker that finds more there
# optimises all of Spoke anew.
#   archive.sh SOURCE WORK CMAKE COMPILER
set -euo pipefail
source=$1 work=$2 cmake=$3 compiler=$4
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
rm -rf "$work"
"$cmake" -S "$source" -B "$work/build" -DCMAKE_CXX_COMPILER="$compiler" -DSPOKE_LTO=ON \
  -DSPOKE_PROGRAM=OFF -DSPOKE_TESTS=OFF -DSPOKE_EXAMPLES=OFF -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG"  # quicker to build
"$cmake" --build "$work/build" --parallel "$(nproc)"
"$cmake" --install "$work/build" --prefix "$work/installed" --component development
objects=$(find "$work/build" -name '*.o' -print -quit)
objdump -h "$objects" | grep '\.gnu\.lto_' >/dev/null || { echo "not built for link-time optimisation"; exit 1; }
archive=$(find "$work/installed" -name libspoke.a)
if objdump -h "$archive" | grep '\.gnu\.lto_' >/dev/null; then
  echo "libspoke.a holds more than machine code"
  exit 1
fi
PKG_CONFIG_PATH=$(dirname "$(find "$work/installed" -name spoke.pc)")
export PKG_CONFIG_PATH
# shellcheck disable=SC2046 # the flags are words
"$compiler" -std=c++20 "$here/outside/main.cpp" -o "$work/outside" $(pkg-config --cflags --libs spoke)
"$work/outside" "$source/models/wu_haug_rotor.toml"
