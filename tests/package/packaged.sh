#!/usr/bin/env bash
# What is checked of a build that is to be published, by the preset package, which has no tests of its own:
# installs it, moves it, builds programs against it, makes the Debian packages; the installed program ends in
# the state of PROGRAM, of another build, to the last bit.
#   packaged.sh BUILD WORK PROGRAM
set -euo pipefail
build=$(readlink -f "$1") work=$(readlink -m "$2") program=$(readlink -f "$3")
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
compiler=${CXX:-g++}
"$here/install.sh" cmake "$build" "$work/installed"
prefix=$work/installed/moved
for way in cmake pkg-config; do
  "$here/outside.sh" "$way" "$prefix" "$work/by_$way" cmake "$compiler"
done
"$here/debian.sh" "$build" cpack "$work/debian"
hash_of() {
  "$1" run "$prefix/share/spoke/models/$2.toml" --instructions baseline --set integration.duration=2 \
    --executor serial --no-report --quiet --out "$work/results"
  grep '"state_hash"' "$work/results/summary.json"
}
for model in wu_haug_rotor nrel_5mw_rotor; do
  own=$(hash_of "$program" "$model")
  packaged=$(hash_of "$prefix/bin/spoke" "$model")
  [ "$own" = "$packaged" ] || { printf '%s: states differ:\n%s\n%s\n' "$model" "$own" "$packaged"; exit 1; }
done
# With all instructions that this processor has, each of the shipped models.
for model in "$prefix"/share/spoke/models/*.toml; do
  "$prefix/bin/spoke" run "$model" --set integration.duration=0.02 --no-report --quiet --out "$work/results" ||
    { echo "$model fails"; exit 1; }
done
du -shc "$prefix"/{bin,include,lib,share}
ls -l "$work"/debian/packages/*.deb
