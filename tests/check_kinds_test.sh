#!/usr/bin/env bash
# The test of tests/check_kinds.sh: in a small tree it passes questions in the folders of kinds, and
# finds those elsewhere.
set -u
check=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/check_kinds.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0
mkdir -p "$tree/engine/bodies/kinds/beam" "$tree/engine/step"

# expect STATUS LINE: what the check must answer when this line stands in a file of the step.
expect() {
  local output status
  printf '%s\n' "$2" >"$tree/engine/step/nodes.cpp"
  output=$("$check" "$tree")
  status=$?
  if [ $status -ne "$1" ] || { [ "$1" -ne 0 ] && ! grep -qF 'engine/step/nodes.cpp:1:' <<<"$output"; }; then
    printf 'expected status %s of "%s", got %s:\n%s\n' "$1" "$2" "$status" "$output"
    failures=$((failures + 1))
  fi
}

echo 'return *body.flexible();' >"$tree/engine/bodies/kinds/beam/beam.cpp"
expect 0 'body.kind->condense(twist, implicit, work, body);'
expect 1 'if (const space::Solid* solid = body.model->body->solid()) {'
expect 1 'if (body->rigid()) return;'
expect 1 'const auto* beam = std::get_if<space::FlexibleBody>(&body.shape);'
exit $((failures > 0))
