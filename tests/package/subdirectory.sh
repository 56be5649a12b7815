#!/usr/bin/env bash
# Builds the project outside/ with Spoke as a subfolder and as a shared library, without its program,
# and runs it: with the instructions of all processors it ends in the state of PROGRAM, to the last bit,
# whatever the compilers. Then looks at what the library exports.
#   subdirectory.sh SOURCE WORK CMAKE COMPILER PROGRAM
set -euo pipefail
source=$1 work=$2 cmake=$3 compiler=$4 program=$5
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
rm -rf "$work"
"$cmake" -S "$here/outside" -B "$work" -DCMAKE_UNITY_BUILD=ON -DSPOKE_SOURCE="$source" -DBUILD_SHARED_LIBS=ON \
  -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release \
  -DSPOKE_WARNINGS_AS_ERRORS="${SPOKE_WARNINGS_AS_ERRORS:-OFF}" \
  -DCMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG"  # quicker to build
"$cmake" --build "$work" --parallel "$(nproc)"
scenario=$source/models/wu_haug_rotor.toml
said=$(GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4 "$work/outside" "$scenario")
printf '%s\n' "$said"
"$program" run "$scenario" --instructions baseline --set integration.duration=4 --executor serial \
  --no-report --quiet --out "$work/results"
state=$(sed -n 's/^outside: state_hash //p' <<<"$said")
grep -q "\"state_hash\": \"$state\"" "$work/results/summary.json" ||
  { echo "the program ends in another state:"; grep state_hash "$work/results/summary.json"; exit 1; }

library=$(find "$work" -name 'libspoke.so.*.*.*')
exported=$(nm -D --defined-only -C "$library" | cut -d' ' -f3-)
grep -q '^spoke::Simulation::step()' <<<"$exported" || { echo "Simulation::step() is hidden"; exit 1; }
# Templates of the standard library may be exported with arguments of Spoke's types.
foreign=$(grep -vE '(^|[ <(])(spoke|std|__gnu_cxx)::|^typeinfo ' <<<"$exported" || true)
[ -z "$foreign" ] || { printf 'exported without need:\n%s\n' "$foreign"; exit 1; }
internal=$(grep -E 'spoke::(StepData|StepRunner|TimeStepper|FormulationWork|System|graph::Plan)\b' <<<"$exported" || true)
[ -z "$internal" ] || { printf 'exported though internal:\n%s\n' "$internal"; exit 1; }
