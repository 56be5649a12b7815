#!/usr/bin/env bash
# Draws the maps of docs/architecture.md from the include lines: rooms.svg, the folders at the top and
# which of them includes which; and rooms_graph.svg and so on, the rooms of tests/include_order.txt inside
# one of them. An arrow that others imply is left out. Writes docs/pictures/rooms*.dot, and the
# pictures by Graphviz (Debian: graphviz).
#   draw_rooms.sh           draws
#   draw_rooms.sh --check   fails if the files are not what would be drawn; needs no Graphviz
set -euo pipefail
export LC_ALL=C
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
pictures=docs/pictures
libraries='graph models engine program bench'

# What a folder or room is for, in few words: ROOM, a tab, words. Rooms without need no explanation.
notes() {
  cat <<'END'
graph	the task-graph runtime
models	what is simulated
engine	how it is simulated
program	the commands, what they write
bench	the laboratory: what measures
package	the library for other programs
python	the Python package
examples	programs that use the library
graph/structure/	orders, reachability
graph/machine/	processors, clocks
graph/plan/	clusters of nodes
graph/execute/	oneTBB, OpenMP, serial
graph/simulate/	schedules on P processors
graph/calibrate/	what runs cost here
graph/tune/	auto
models/reader/	scenario files
models/system/	constants of a whole system
models/support/	vectors of two and four, quantities
models/plane/	bodies in the plane
models/space/	bodies, joints in space
models/tree/	trees of bodies
engine/*.h	what programs include
engine/support/	memory, vectors, log
engine/bodies/	the table, kernels on it, what acts
engine/step/	the nodes and their graph
engine/small_motions/	equilibrium, modes
engine/simulation/	behind Simulation
engine/output/	files, models as they are drawn
engine/bodies/*.h	types of a body, by world
engine/bodies/air/	momentum, stall, inflow
engine/bodies/tree/	elimination of joints
engine/bodies/plane/	arithmetic of planar bodies
engine/bodies/space/	arithmetic of spatial bodies
engine/bodies/table/	all that changes in a step
engine/bodies/kernels/	what nodes call on the table
engine/bodies/kinds/	rigid, beam, reduced, nodal
engine/bodies/columns/	columns of sensors
engine/bodies/act/	air, control, loads of users
engine/step/formulation/	(P 7) to (P 11)
engine/step/integrator/	rk4, generalized_alpha
engine/step/run/	steps, windows, recording
program/foreign/	files of other programs
program/fmu/	what is in an FMU
program/fmu/library/	what importers load
program/ranks/	processes of MPI
program/report/	pages and charts
program/viewer/	the page of a trace
program/study/	many runs, and what they say
program/verify/	published and exact cases
program/study_report/	report.html of a study
program/run_report/	report.html of a run
program/steady_report/	files and pages of modes
program/trace/	files of traced steps
program/cli/	the command line
bench/compare/	executors compared
bench/reproduce/	the paper's evaluation
bench/programs/	spoke-compare and so on
END
}

# "FILE HEADER" for each include line of a file of ours.
include_lines() {
  grep -rHoE --include='*.h' --include='*.cpp' "^#include \"(${libraries// /|})/[^\"]*\"" \
    $libraries | sed -E 's/:#include "/ /; s/"$//' | sort
}

# "FOLDER FOLDER" for each arrow of the first map that is not between sources of $libraries: bindings
# include the engine; examples include what the package hands out, the libraries' headers and objects.
outer_arrows() {
  grep -rhoE --include='*.h' --include='*.cpp' "^#include \"(${libraries// /|})/" python |
    sed -E 's/#include "(.*)\//python \1/' | sort -u
  if grep -rqE --include='*.cpp' '^#include <spoke/' examples; then echo 'examples package'; fi
  printf 'package %s\n' graph models engine
}

# What both maps share, in awk: arrow[FROM, TO] and box[1 ... boxes] are drawn, without the arrows that
# others imply.
draw='
  function has_path(from, to,   k) {
    if ((from, to) in known) return known[from, to]
    known[from, to] = 0
    for (k = 1; k <= boxes; ++k)
      if ((from, box[k]) in arrow && (box[k] == to || has_path(box[k], to))) return known[from, to] = 1
    return 0
  }
  function is_implied(from, to,   k) {
    for (k = 1; k <= boxes; ++k)
      if (box[k] != to && (from, box[k]) in arrow && has_path(box[k], to)) return 1
    return 0
  }
  function read_notes(   lines, count, k, pair) {
    count = split(notes, lines, "\n")
    for (k = 1; k <= count; ++k) { split(lines[k], pair, "\t"); note[pair[1]] = pair[2] }
  }
  # Folders are boxes, files that other rooms or programs include are plain names.
  function draw_box(name, title, is_folder,   text) {
    text = is_folder ? "<b>" title "</b>" : title
    if (name in note) text = text "<br/><font point-size=\"11\">" note[name] "</font>"
    printf "  \"%s\" [label = <%s>%s]\n", name, text, is_folder ? "" : "; shape = plaintext; style = \"\""
  }
  function draw_arrows(   f, t) {
    for (f = 1; f <= boxes; ++f)
      for (t = 1; t <= boxes; ++t)
        if ((box[f], box[t]) in arrow && !is_implied(box[f], box[t]))
          printf "  \"%s\" -> \"%s\"\n", box[f], box[t]
  }
  function draw_head() {
    print "// Written by docs/draw_rooms.sh."
    print "digraph rooms {"
    print "  graph [fontname = \"Helvetica\"; fontsize = 14; color = \"#888888\"; ranksep = 0.35; nodesep = 0.2]"
    print "  node [fontname = \"Helvetica\"; fontsize = 13; shape = box; style = \"rounded,filled\"; fillcolor = \"" fill "\"; height = 0.3; margin = \"0.1,0.05\"]"
    print "  edge [arrowsize = 0.7; color = \"#555555\"]"
  }'

# The first map: folders at the top of the tree.
draw_folders() {
  { include_lines | sed -E 's#^([a-z]+)/[^ ]* ([a-z]+)/.*#\1 \2#'; outer_arrows; } | sort -u |
    awk -v notes="$(notes)" -v fill='#fdf4e3' "$draw"'
      $1 != $2 { arrow[$1, $2] = 1 }
      END {
        read_notes()
        boxes = split("examples python bench program package engine models graph", box, " ")
        draw_head()
        for (k = 1; k <= boxes; ++k) draw_box(box[k], box[k] "/", 1)
        draw_arrows()
        print "}"
      }'
}

# The map of one folder: its rooms; with "by folder" as the third argument those of one of its folders as
# one. What a folder has beside the rooms that lie in it is named as the folder.
draw_library() {
  include_lines | awk -v notes="$(notes)" -v library="$1/" -v fill="$2" -v by_folder="${3:+1}" "$(cat tests/rooms.awk)"'
    function box_of(room,   rest) {
      if (index(room, library) != 1) return ""
      rest = substr(room, length(library) + 1)
      if (by_folder && rest ~ "/") sub("/.*", "/", rest)
      return library rest
    }
    { from = box_of(room_of($1)); to = box_of(room_of($2)); if (from != to && from != "" && to != "") arrow[from, to] = 1 }'"$draw"'
    END {
      read_notes()
      for (k = 1; k <= rooms; ++k) {
        known_room[room[k]]
        name = box_of(room[k])
        if (name == "" || name in known_box) continue
        known_box[name]; known_room[name]
        if (name != library || library ~ "/.*/") box[++boxes] = name
      }
      if (by_folder) for (name in note)
        if (index(name, library) == 1 && !(name in known_room)) { print "a note on no room: " name > "/dev/stderr"; exit 1 }
      draw_head()
      for (k = 1; k <= boxes; ++k) {
        title = substr(box[k], length(library) + 1)
        if (title == "") title = library
        draw_box(box[k], title, box[k] ~ /\/$/)
      }
      draw_arrows()
      print "}"
    }' tests/include_order.txt -
}

# A picture names the graph that it was drawn from.
mark_of() { echo "<!-- $(basename "$1"): $(cksum <"$1") -->"; }

made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
draw_folders >"$made/rooms.dot"
draw_library graph '#e8effa' >"$made/rooms_graph.dot"
draw_library models '#e9f3e6' >"$made/rooms_models.dot"
draw_library engine '#fdf4e3' 'by folder' >"$made/rooms_engine.dot"
draw_library engine/bodies '#fdf4e3' >"$made/rooms_engine_bodies.dot"
draw_library engine/step '#fdf4e3' >"$made/rooms_engine_step.dot"
draw_library program '#f6eaf6' >"$made/rooms_program.dot"
draw_library bench '#f4f4f4' >"$made/rooms_bench.dot"
if [ "${1:-}" != --check ]; then
  command -v dot >/dev/null || { echo "draw_rooms.sh needs Graphviz (Debian: graphviz)"; exit 1; }
fi
for dot_file in "$made"/*.dot; do
  picture=$pictures/$(basename "$dot_file" .dot)
  if [ "${1:-}" = --check ]; then
    diff "$picture.dot" "$dot_file" && tail -1 "$picture.svg" | grep -qxF -e "$(mark_of "$dot_file")" ||
      { echo "The pictures of the rooms are not those of the include lines: run docs/draw_rooms.sh"; exit 1; }
  else
    dot -Tsvg "$dot_file" -o "$picture.svg"
    mark_of "$dot_file" >>"$picture.svg"
    cp "$dot_file" "$picture.dot"
  fi
done
