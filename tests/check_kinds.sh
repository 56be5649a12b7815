#!/usr/bin/env bash
# Checks that the engine asks what kind of body one is in engine/bodies/kinds/ alone: in the folders of the
# kinds, and where the kind is chosen. Elsewhere it asks the kind (engine/bodies/table/body_kind.h).
#   check_kinds.sh [ROOT]     ROOT: a tree with a folder engine
set -u
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
cd "${1:-$here/..}" || exit 2

# Members of space::Body that are null for other kinds, and its variant.
questions='(\.|->)((flexible|rigid|solid)\(\)|shape\.index\(\))|(get_if|get|holds_alternative)<(space::)?(FlexibleBody|RigidBody|Solid)>'
found=$(grep -rnE --include='*.h' --include='*.cpp' "$questions" engine | grep -v '^engine/bodies/kinds/')
[ -z "$found" ] && exit 0
printf 'asks what kind of body it is outside engine/bodies/kinds/:\n%s\n' "$found"
exit 1
