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
  share/doc/spoke/LICENSE share/doc/spoke/docs/embedding.md; do
  [ -s "$work/moved/$file" ] || { echo "not installed: $file"; exit 1; }
done
if found=$(grep -rlE "$work/first|$build" "$work/moved" --include='*.cmake' --include='*.pc' --include='*.h'); then
  printf 'files that know where they were built or first installed:\n%s\n' "$found"
  exit 1
fi
"$work/moved/bin/spoke" check "$work/moved/share/spoke/models/wu_haug_rotor.toml"
