#!/usr/bin/env bash
# Builds the project outside/ with Spoke as a subfolder and as a shared library, without its program,
# and runs it; then looks at what the library exports.
#   subdirectory.sh SOURCE WORK CMAKE COMPILER
set -euo pipefail
source=$1 work=$2 cmake=$3 compiler=$4
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
rm -rf "$work"
"$cmake" -S "$here/outside" -B "$work" -DCMAKE_UNITY_BUILD=ON -DSPOKE_SOURCE="$source" -DBUILD_SHARED_LIBS=ON \
  -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG"  # quicker to build
"$cmake" --build "$work" --parallel "$(nproc)"
"$work/outside" "$source/models/wu_haug_rotor.toml"

library=$(find "$work" -name 'libspoke.so.*.*.*')
exported=$(nm -D --defined-only -C "$library" | cut -d' ' -f3-)
grep -q '^spoke::Simulation::step()' <<<"$exported" || { echo "Simulation::step() is hidden"; exit 1; }
# Templates of the standard library may be exported with arguments of Spoke's types.
foreign=$(grep -vE '(^|[ <(])(spoke|std|__gnu_cxx)::|^typeinfo ' <<<"$exported" || true)
[ -z "$foreign" ] || { printf 'exported without need:\n%s\n' "$foreign"; exit 1; }
internal=$(grep -E 'spoke::(StepData|StepRunner|TimeStepper|FormulationWork|System|graph::Plan)\b' <<<"$exported" || true)
[ -z "$internal" ] || { printf 'exported though internal:\n%s\n' "$internal"; exit 1; }
