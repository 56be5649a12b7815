#!/usr/bin/env bash
# Draws the map of docs/architecture.md: the rooms of tests/include_order.txt, and which includes
# which, from the include lines. An arrow that others imply is left out. Writes
# docs/pictures/rooms.dot, and rooms.svg by Graphviz (Debian: graphviz).
#   draw_rooms.sh           draws
#   draw_rooms.sh --check   fails if the two files are not what would be drawn; needs no Graphviz
set -euo pipefail
export LC_ALL=C
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
picture=docs/pictures/rooms

# What a room is for, in few words: ROOM, a tab, words. Rooms without need no explanation.
notes() {
  cat <<'END'
graph/structure/	orders, reachability
graph/machine/	processors, clocks
graph/plan/	clusters of nodes
graph/execute/	oneTBB, OpenMP, serial
graph/simulate/	schedules on P processors
graph/calibrate/	what runs cost here
graph/tune/	auto
graph/viewer/	the page of a trace
models/reader/	scenario files
models/system/	constants of bodies
models/support/	vectors of two and four
models/space/	bodies, joints in space
engine/support/	memory, vectors, log
engine/body/	elastic blocks of a body
engine/tree/	elimination of joints
engine/table/	all that changes in a step
engine/space/	kernels of spatial bodies
engine/kernels/	terms of bodies and hub
engine/formulation/	(P 7) to (P 11)
engine/integrator/	rk4, generalized_alpha
engine/space/integrator/	orientations in steps
engine/step/	the nodes and their graph
engine/steady/	equilibrium, linear model
engine/vibration/	modes and their names
engine/run/	steps, windows, recording
engine/simulation/	behind Simulation
engine/scene/	models as they are drawn
engine/vtk/	files for ParaView
engine/report/	pages and charts
engine/study/	many runs, and what they say
engine/run_report/	report.html of a run
engine/compare/	executors compared
engine/reproduce/	the paper's evaluation
engine/predict/	times on more threads
engine/trace/	files of traced steps
engine/cli/	the program
END
}

# "FILE HEADER" for each include line of a file of ours.
include_lines() {
  grep -rHoE --include='*.h' --include='*.cpp' '^#include "(graph|models|engine)/[^"]*"' \
    graph models engine | sed -E 's/:#include "/ /; s/"$//' | sort
}

make_dot() {
  include_lines | awk -v notes="$(notes)" "$(cat tests/rooms.awk)"'
    { from = room_of($1); to = room_of($2); if (from != to) arrow[from, to] = path[from, to] = 1 }

    # Rooms stand below those that they are included by: one sweep from below finds all paths.
    function find_paths(   m, f, t) {
      for (m = 1; m <= rooms; ++m)
        for (f = 1; f <= rooms; ++f)
          if ((room[f], room[m]) in path)
            for (t = 1; t <= rooms; ++t)
              if ((room[m], room[t]) in path) path[room[f], room[t]] = 1
    }
    function library_of(name) { sub(/\/.*/, "", name); return name }
    function is_implied(from, to,   k) {
      for (k = 1; k <= rooms; ++k)
        if ((from, room[k]) in arrow && (room[k], to) in path) return 1
      return 0
    }
    function read_notes(   lines, count, k, pair) {
      count = split(notes, lines, "\n")
      for (k = 1; k <= count; ++k) {
        split(lines[k], pair, "\t")
        if (!(pair[1] in rank)) { print "a note on no room: " pair[1] > "/dev/stderr"; exit 1 }
        note[pair[1]] = pair[2]
      }
    }
    # Folders are boxes, files that other rooms or programs include are plain names.
    function draw_library(library, role, fill,   k, name, text) {
      printf "  subgraph cluster_%s {\n    label = <<b>%s/</b>  %s>; bgcolor = \"%s\"\n", library, library, role, fill
      for (k = 1; k <= rooms; ++k) {
        if (index(room[k], library "/") != 1) continue
        name = substr(room[k], length(library) + 2)
        text = name ~ /\/$/ ? "<b>" name "</b>" : name
        if (room[k] in note) text = text "<br/><font point-size=\"11\">" note[room[k]] "</font>"
        printf "    \"%s\" [label = <%s>%s]\n", room[k], text, name ~ /\/$/ ? "" : "; shape = plaintext; style = \"\""
      }
      print "  }"
    }
    END {
      read_notes()
      find_paths()
      print "// Written by docs/draw_rooms.sh."
      print "digraph rooms {"
      print "  graph [fontname = \"Helvetica\"; fontsize = 14; color = \"#888888\"; ranksep = 0.35; nodesep = 0.2]"
      print "  node [fontname = \"Helvetica\"; fontsize = 13; shape = box; style = \"rounded,filled\"; fillcolor = white; height = 0.3; margin = \"0.1,0.05\"]"
      print "  edge [arrowsize = 0.7; color = \"#555555\"]"
      draw_library("engine", "how it is simulated", "#fdf4e3")
      draw_library("graph", "the task-graph runtime", "#e8effa")
      draw_library("models", "what is simulated", "#e9f3e6")
      for (f = 1; f <= rooms; ++f)
        for (t = 1; t <= rooms; ++t)
          if ((room[f], room[t]) in arrow && !is_implied(room[f], room[t]))
            printf "  \"%s\" -> \"%s\"%s\n", room[f], room[t], library_of(room[f]) == library_of(room[t]) ? "" : " [color = \"#a0a0a0\"]"
      print "}"
    }' tests/include_order.txt -
}

# The picture names the graph that it was drawn from.
mark_of() { echo "<!-- rooms.dot: $(cksum <"$1") -->"; }

dot_file=$(mktemp)
trap 'rm -f "$dot_file"' EXIT
make_dot >"$dot_file"
if [ "${1:-}" = --check ]; then
  diff $picture.dot "$dot_file" && tail -1 $picture.svg | grep -qxF -e "$(mark_of "$dot_file")" ||
    { echo "The picture of the rooms is not that of the include lines: run docs/draw_rooms.sh"; exit 1; }
else
  command -v dot >/dev/null || { echo "draw_rooms.sh needs Graphviz (Debian: graphviz)"; exit 1; }
  dot -Tsvg "$dot_file" -o $picture.svg
  mark_of "$dot_file" >>$picture.svg
  cp "$dot_file" $picture.dot
fi
