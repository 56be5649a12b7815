# For tests/check_includes.sh and docs/draw_rooms.sh: reads tests/include_order.txt into rank[ROOM]
# and room[1 ... rooms], and tells the room of a file. Lines of includes come on standard input. A room
# FOLDER/*.h is made of the headers that lie in FOLDER itself.

function is_in(file, prefix,   folder, name) {
  if (prefix ~ /\/\*\.h$/) {
    folder = substr(prefix, 1, length(prefix) - 3)
    return index(file, folder) == 1 && substr(file, length(folder) + 1) ~ /^[^\/]*\.h$/
  }
  name = substr(file, length(prefix) + 1)
  return index(file, prefix) == 1 && (prefix ~ /\/$/ || prefix == file || name ~ /^\.[a-z]+$/)
}

# The room whose name the file's name begins with, the longest if there are several.
function room_of(file,   prefix, best) {
  best = ""
  for (prefix in rank)
    if (is_in(file, prefix) && length(prefix) > length(best)) best = prefix
  return best
}

FILENAME != "-" {
  if ($0 ~ /^#/ || NF == 0) next
  ++line
  for (k = 1; k <= NF; ++k) { rank[$k] = line; room[++rooms] = $k }
  next
}
