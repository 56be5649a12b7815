#!/usr/bin/env bash
# Installs a build and moves what was installed, so that no path of the first place can hold.
#   install.sh CMAKE BUILD WORK      leaves the tree in WORK/moved
set -euo pipefail
cmake=$1 build=$2 work=$3
rm -rf "$work"
mkdir -p "$work"
"$cmake" --install "$build" --prefix "$work/first" >"$work/install.log"
mv "$work/first" "$work/moved"
for file in bin/spoke include/spoke/spoke.h share/spoke/models/wu_haug_rotor.toml \
  share/spoke/models/studies/blade_stiffness.toml share/spoke/models/meshes/bracket.msh \
  share/doc/spoke/LICENSE share/doc/spoke/docs/embedding.md share/doc/spoke/examples/first_rotor.cpp; do
  [ -s "$work/moved/$file" ] || { echo "not installed: $file"; exit 1; }
done
if grep -q 'dist-packages/spoke' "$work/install.log"; then  # the Python package, if the build has one
  modules=$(dirname "$(find "$work/moved" -path '*/dist-packages/spoke' -type d)")
  PYTHONPATH=$modules /usr/bin/python3 -B -c "import spoke
assert spoke.__file__.startswith('$modules'), spoke.__file__"
fi
if found=$(grep -rlE "$work/first|$build" "$work/moved" --include='*.cmake' --include='*.pc' --include='*.h'); then
  printf 'files that know where they were built or first installed:\n%s\n' "$found"
  exit 1
fi
pc=$(find "$work/moved" -name spoke.pc)
if absolute=$(grep -E '(^|[ =]|-[IL])/' "$pc"); then
  printf '%s names places of this machine:\n%s\n' "$pc" "$absolute"
  exit 1
fi
# With a shared library the engine is installed once, beside what FMUs have: less than 30 MB in all.
if [ -n "$(find "$work/moved" -name 'libspoke.so')" ]; then
  size=$(du -sm "$work/moved" | cut -f 1)
  [ "$size" -lt 30 ] || { du -am "$work/moved" | sort -rn | head -n 20; exit 1; }
fi
# Scenarios find the meshes and the aerofoils that they name.
for scenario in "$work"/moved/share/spoke/models/*.toml; do
  for file in $(sed -nE 's/^ *(mesh|file) *= *"([^"]+)".*/\2/p' "$scenario"); do
    [ -s "$(dirname "$scenario")/$file" ] || { echo "$scenario names $file, which is not installed"; exit 1; }
  done
done
# What the documents for users link to is installed with them.
for page in "$work"/moved/share/doc/spoke/{README.md,docs/*.md}; do
  links=$(grep -oE '[[:alnum:]/`]\]\([^)#]+' "$page" | cut -c4- | grep -vE '^(https?|mailto):' || true)
  for link in $links; do
    [ -e "$(dirname "$page")/$link" ] || { echo "$page links to $link, which is not installed"; exit 1; }
  done
done
if [ -e "$work/moved/bin/spoke-fmu" ]; then  # if the build has it
  "$work/moved/bin/spoke" fmu "$work/moved/share/spoke/models/wu_haug_rotor.toml" --out "$work/rotor.fmu" >/dev/null
  [ -s "$work/rotor.fmu" ]
fi
"$work/moved/bin/spoke" check "$work/moved/share/spoke/models/wu_haug_rotor.toml"
# Each command has a man page, and bash completes commands and their options.
for command in $("$work/moved/bin/spoke" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\) .*/\1/p'); do
  [ -s "$work/moved/share/man/man1/spoke-$command.1" ] || { echo "spoke $command has no man page"; exit 1; }
done
completed() {
  bash -c 'source "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _spoke; echo "${COMPREPLY[*]}"' \
    "$work/moved/share/bash-completion/completions/spoke" "$work/moved/bin/spoke" "$@"
}
[ "$(completed camp)" = campbell ] || { echo "bash does not complete commands"; exit 1; }
[ "$(completed modes --spe)" = --speed ] || { echo "bash does not complete options"; exit 1; }
SPOKE_CACHE=none "$work/moved/bin/spoke" reduce "$work/moved/share/spoke/models/solid_bracket.toml" >/dev/null
