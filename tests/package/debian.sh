#!/usr/bin/env bash
# Makes the Debian packages, and checks what they say of themselves and that the program runs from
# what they contain. Installing them needs root: docs/embedding.md tells how.
#   debian.sh BUILD CPACK WORK
set -euo pipefail
build=$1 cpack=$2 work=$3
rm -rf "$work"
mkdir -p "$work"
cd "$build"
"$cpack" -G DEB -B "$work/packages" >"$work/cpack.log" 2>&1 || { cat "$work/cpack.log"; exit 1; }

# demand PACKAGE FIELD PATTERN: the field must match.
demand() {
  local value
  value=$(dpkg-deb --field "$work/packages/$1"_*.deb "$2")
  grep -qE "$3" <<<"$value" || { echo "$1: $2 is \"$value\", which lacks $3"; exit 1; }
}
demand spoke Section '^science$'
demand spoke Maintainer '.+ <.+@.+>'
demand spoke Description 'flexible blades'
demand libspoke-dev Section '^libdevel$'
demand libspoke-dev Depends libeigen3-dev
# All that the program is linked with, by the packages that dpkg says own it.
dpkg-deb --extract "$work"/packages/spoke_*.deb "$work/spoke"
dpkg-deb --extract "$work"/packages/libspoke-dev_*.deb "$work/libspoke-dev"
# Whoever links the static library links what it needs.
if [ -n "$(find "$work/libspoke-dev" -name libspoke.a)" ]; then
  for package in libspdlog-dev libtbb-dev libtomlplusplus-dev zlib1g-dev; do
    demand libspoke-dev Depends "$package"
  done
fi
program=$work/spoke/usr/bin/spoke
for library in $(objdump -p "$work"/spoke/usr/bin/* | awk '/NEEDED/ { print $2 }' | sort -u); do
  owner=$(dpkg-query -S "*/$(dpkg-architecture -qDEB_HOST_MULTIARCH)/$library" | head -1 | cut -d: -f1)
  demand spoke Depends "(^|[ ,])${owner//+/[+]}"  # or a name behind it that says more: libspdlog1.10-fmt9
done
# Of the Python package, if the build has one, too; it needs the interpreter that it was built for.
if ls "$work"/packages/python3-spoke_*.deb >/dev/null 2>&1; then
  demand python3-spoke Section '^python$'
  demand python3-spoke Depends python3-numpy
  demand python3-spoke Depends 'python3 \(<< 3\.[0-9]+\)'
  demand python3-spoke Depends libtbb
  dpkg-deb --extract "$work"/packages/python3-spoke_*.deb "$work/python3-spoke"
  [ -s "$work/python3-spoke/usr/share/doc/python3-spoke/copyright" ]
  modules=$work/python3-spoke/usr/lib/python3/dist-packages
  if [ -d "$modules" ]; then  # by the interpreter of Debian
    PYTHONPATH=$modules /usr/bin/python3 -B -c "import spoke
assert spoke.__file__.startswith('$modules'), spoke.__file__
assert spoke.Simulation('$work/spoke/usr/share/spoke/models/wu_haug_rotor.toml').coordinates == 144"
  fi
fi
[ -s "$work/spoke/usr/share/doc/spoke/copyright" ]
[ -s "$work/libspoke-dev/usr/share/doc/libspoke-dev/copyright" ]
[ -s "$work/libspoke-dev/usr/include/spoke/spoke.h" ]
[ -s "$work/spoke/usr/share/doc/spoke/examples/first_rotor.cpp" ]
"$program" check "$work/spoke/usr/share/spoke/models/wu_haug_rotor.toml"
SPOKE_CACHE=none "$program" reduce "$work/spoke/usr/share/spoke/models/solid_bracket.toml" >/dev/null
for command in study compare predict reproduce; do  # programs of their own
  "$program" "$command" --help | grep -q "^Usage: spoke $command "
done
