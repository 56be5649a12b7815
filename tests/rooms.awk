# For tests/check_includes.sh and docs/draw_rooms.sh: reads tests/include_order.txt into rank[ROOM]
# and room[1 ... rooms], and tells the room of a file. Lines of includes come on standard input. A room
# FOLDER/{A,B} is made of the files of these names.

# The room whose name the file's name begins with, the longest if there are several.
function room_of(file,   prefix, best, name) {
  best = ""
  for (prefix in member) {
    if (index(file, prefix) != 1) continue
    name = substr(file, length(prefix) + 1)
    if (prefix !~ /\/$/ && prefix != file && name !~ /^\.[a-z]+$/) continue
    if (length(prefix) > length(best)) best = prefix
  }
  return best == "" ? "" : member[best]
}

FILENAME != "-" {
  if ($0 ~ /^#/ || NF == 0) next
  ++line
  for (k = 1; k <= NF; ++k) {
    rank[$k] = line; room[++rooms] = $k; member[$k] = $k
    if (split($k, halves, /[{}]/) < 2) continue
    count = split(halves[2], names, ",")
    for (n = 1; n <= count; ++n) member[halves[1] names[n]] = $k
  }
  next
}
