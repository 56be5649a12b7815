#!/usr/bin/env bash
# The test of tests/check_includes.sh: in small trees it passes what follows the order, and refuses an
# arrow against the order, a circle, a file without a room and a runtime where it does not belong.
set -u
check=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/check_includes.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

# lay FILE HEADER...: writes a file of the tree that includes these headers.
lay() {
  local file=$tree/$1
  shift
  mkdir -p "$(dirname "$file")"
  printf '#include "%s"\n' "$@" >"$file"
}
fresh_tree() {
  rm -rf "${tree:?}"/*
  mkdir -p "$tree/tests" "$tree/models"
  printf '# order\ngraph/low/\ngraph/high/\nengine/step/\n' >"$tree/tests/include_order.txt"
  lay graph/low/a.h
  sed -i d "$tree/graph/low/a.h"
  lay graph/high/b.h graph/low/a.h
  lay engine/step/c.cpp graph/high/b.h
}
# expect STATUS WORDS: what the check must answer.
expect() {
  local output status
  output=$("$check" "$tree")
  status=$?
  if [ $status -ne "$1" ] || { [ -n "$2" ] && ! grep -qF "$2" <<<"$output"; }; then
    printf 'expected status %s and "%s", got %s:\n%s\n' "$1" "$2" "$status" "$output"
    failures=$((failures + 1))
  fi
}

fresh_tree
expect 0 ''
fresh_tree && lay graph/low/a.h graph/high/b.h
expect 1 'graph/low/a.h includes graph/high/b.h: graph/high/ is not below graph/low/'
fresh_tree && lay graph/low/d.h graph/low/e.h && lay graph/low/e.cpp graph/low/d.h
expect 1 'part of a circle'
fresh_tree && lay graph/lost/f.h graph/low/a.h
expect 1 'graph/lost/f.h: belongs to no room'
fresh_tree && lay graph/low/a.h engine/step/c.h
expect 1 'graph/ knows no physics'
fresh_tree && lay engine/step/c.cpp oneapi/tbb/flow_graph.h
expect 1 'threads belong to graph/'
fresh_tree && lay engine/step/c.h nlohmann/json.hpp
expect 1 'no library but Eigen in a header'
# A room of the headers that lie in a folder itself, below the rooms in it.
public_headers() {
  fresh_tree
  sed -i '2i graph/*.h' "$tree/tests/include_order.txt"
  cp "$tree/graph/low/a.h" "$tree/graph/public.h"
}
public_headers && lay graph/low/a.h graph/public.h
expect 0 ''
public_headers && lay graph/public.h graph/low/a.h
expect 1 'graph/public.h includes graph/low/a.h: graph/low/ is not below graph/*.h'
public_headers && lay graph/public.cpp graph/low/a.h
expect 1 'graph/public.cpp: belongs to no room'
public_headers && rm "$tree/graph/public.h"
expect 1 'no such room: graph/*.h'
fresh_tree && echo 'graph/none/' >>"$tree/tests/include_order.txt"
expect 1 'no such room: graph/none/'
exit $((failures > 0))
