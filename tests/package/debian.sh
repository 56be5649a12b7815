#!/usr/bin/env bash
# Makes the Debian packages, and checks what they say of themselves and that the program runs from
# what they contain. Installing them needs root: docs/embedding.md tells how. They are not compressed,
# which takes most of the time.
#   debian.sh BUILD CPACK WORK
set -euo pipefail
build=$1 cpack=$2 work=$3
rm -rf "$work"
mkdir -p "$work"
cd "$build"
"$cpack" -G DEB -D CPACK_DEBIAN_COMPRESSION_TYPE=none -B "$work/packages" >"$work/cpack.log" 2>&1 ||
  { cat "$work/cpack.log"; exit 1; }
for package in "$work"/packages/*.deb; do
  name=$(basename "$package")
  dpkg-deb --extract "$package" "$work/${name%%_*}"
  [ -s "$work/${name%%_*}/usr/share/doc/${name%%_*}/copyright" ] || { echo "$name has no copyright"; exit 1; }
done

# demand PACKAGE FIELD PATTERN: the field must match.
demand() {
  local value
  value=$(dpkg-deb --field "$work/packages/$1"_*.deb "$2")
  grep -qE "$3" <<<"$value" || { echo "$1: $2 is \"$value\", which lacks $3"; exit 1; }
}
# demand_linked PACKAGE FILE...: the package depends on all that its files are linked with, by the packages
# that dpkg says own it; on Spoke's own library in the very same version.
demand_linked() {
  local package=$1 library owner
  shift
  for library in $(objdump -p "$@" | awk '/NEEDED/ { print $2 }' | sort -u); do
    if [[ $library = libspoke.so.* ]]; then
      demand "$package" Depends "(^|, )libspoke${library#libspoke.so.} \(= "
      continue
    fi
    owner=$(dpkg-query -S "*/$(dpkg-architecture -qDEB_HOST_MULTIARCH)/$library" | head -1 | cut -d: -f1)
    demand "$package" Depends "(^|[ ,])${owner//+/[+]}"  # or a name behind it that says more: libspdlog1.10-fmt9
  done
}
demand spoke Section '^science$'
demand spoke Maintainer '.+ <.+@.+>'
demand spoke Description 'flexible blades'
demand libspoke-dev Section '^libdevel$'
demand libspoke-dev Depends libeigen3-dev
demand_linked spoke "$work"/spoke/usr/bin/*
program=$work/spoke/usr/bin/spoke
shared=$(find "$work"/libspoke[0-9]* -name 'libspoke.so.*' -type f 2>/dev/null || true)
if [ -n "$shared" ]; then
  package=libspoke$(objdump -p "$shared" | sed -n 's/^ *SONAME *libspoke\.so\.//p')
  demand "$package" Section '^libs$'
  demand libspoke-dev Depends "$package \(= "
  demand_linked "$package" "$shared"
  dpkg-deb --control "$work/packages/$package"_*.deb "$work/control"
  grep -q "^libspoke " "$work/control/shlibs" || { echo "$package does not say what to depend on"; exit 1; }
  LD_LIBRARY_PATH=$(dirname "$shared")  # installed, they share a tree
  export LD_LIBRARY_PATH
else  # whoever links the static library links what it needs
  [ -n "$(find "$work/libspoke-dev" -name libspoke.a)" ]
  for package in libspdlog-dev libtbb-dev libtomlplusplus-dev zlib1g-dev; do
    demand libspoke-dev Depends "$package"
  done
fi
# Of the Python package, if the build has one, too; it needs the interpreter that it was built for.
if [ -d "$work/python3-spoke" ]; then
  demand python3-spoke Section '^python$'
  demand python3-spoke Depends python3-numpy
  demand python3-spoke Depends 'python3 \(<< 3\.[0-9]+\)'
  # shellcheck disable=SC2046 # a name of a file
  demand_linked python3-spoke $(find "$work/python3-spoke" -name '_spoke.*.so')
  modules=$work/python3-spoke/usr/lib/python3/dist-packages
  if [ -d "$modules" ]; then  # by the interpreter of Debian
    PYTHONPATH=$modules /usr/bin/python3 -B -c "import spoke
assert spoke.__file__.startswith('$modules'), spoke.__file__
assert spoke.Simulation('$work/spoke/usr/share/spoke/models/wu_haug_rotor.toml').coordinates == 144"
  fi
fi
[ -s "$work/libspoke-dev/usr/include/spoke/spoke.h" ]
[ -s "$work/spoke/usr/share/doc/spoke/examples/first_rotor.cpp" ]
"$program" check "$work/spoke/usr/share/spoke/models/wu_haug_rotor.toml"
SPOKE_CACHE=none "$program" reduce "$work/spoke/usr/share/spoke/models/solid_bracket.toml" >/dev/null
for command in study compare reproduce; do  # programs of their own
  "$program" "$command" --help | grep -q "^Usage: spoke $command "
done
