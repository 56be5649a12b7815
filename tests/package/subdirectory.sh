#!/usr/bin/env bash
# Configures the project outside/ with Spoke as a subfolder and as a shared library, compiles its source as
# that says, and links it to LIBRARY, the shared library made of this build's own objects: with the
# instructions of all processors it ends in the state of PROGRAM, to the last bit. Then looks at what the
# library exports.
#   subdirectory.sh SOURCE WORK CMAKE COMPILER PROGRAM LIBRARY
set -euo pipefail
source=$1 work=$2 cmake=$3 compiler=$4 program=$5 library=$6
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
rm -rf "$work"
"$cmake" -G Ninja -S "$here/outside" -B "$work" -DSPOKE_SOURCE="$source" -DBUILD_SHARED_LIBS=ON \
  -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release \
  -DSPOKE_WARNINGS_AS_ERRORS="${SPOKE_WARNINGS_AS_ERRORS:-OFF}"
grep -q '^build spoke/package/libspoke\.so\.[0-9.]*: CXX_SHARED_LIBRARY_LINKER' "$work/build.ninja" ||
  { echo "Spoke would not be a shared library"; exit 1; }
object=CMakeFiles/outside.dir/main.cpp.o
"$cmake" --build "$work" --target spoke_headers "$object"
"$compiler" "$work/$object" "$library" -Wl,-rpath,"$(dirname "$library")" -o "$work/outside"
scenario=$source/models/wu_haug_rotor.toml
said=$(GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4 "$work/outside" "$scenario")
printf '%s\n' "$said"
"$program" run "$scenario" --instructions baseline --set integration.duration=4 --executor serial \
  --no-report --quiet --out "$work/results"
state=$(sed -n 's/^outside: state_hash //p' <<<"$said")
grep -q "\"state_hash\": \"$state\"" "$work/results/summary.json" ||
  { echo "the program ends in another state:"; grep state_hash "$work/results/summary.json"; exit 1; }

exported=$(nm -D --defined-only -C "$library" | cut -d' ' -f3-)
grep -q '^spoke::Simulation::step()' <<<"$exported" || { echo "Simulation::step() is hidden"; exit 1; }
# Templates of the standard library may be exported with arguments of Spoke's types.
foreign=$(grep -vE '(^|[ <(])(spoke|std|__gnu_cxx)::|^typeinfo ' <<<"$exported" || true)
[ -z "$foreign" ] || { printf 'exported without need:\n%s\n' "$foreign"; exit 1; }
internal=$(grep -E 'spoke::(StepData|StepRunner|TimeStepper|FormulationWork|System|graph::Plan)\b' <<<"$exported" || true)
[ -z "$internal" ] || { printf 'exported though internal:\n%s\n' "$internal"; exit 1; }
