#!/usr/bin/env bash
# Writes a man page of the program and of each of its commands, from their help.
#   make_man_pages.sh SPOKE VERSION FOLDER
set -euo pipefail
spoke=$1 version=$2 folder=$3
mkdir -p "$folder"

escape() { sed -e 's/\\/\\e/g' -e "s/^[.']/\\\\\&&/" -e 's/-/\\-/g'; }

# write NAME WHAT: the page NAME, of the help on standard input; WHAT is its line in lists.
write() {
  local name=$1 what=$2
  {
    printf '.TH %s 1 "" "Spoke %s" "Spoke"\n' "${name^^}" "$version"
    printf '.SH NAME\n%s \\- %s\n' "$(escape <<<"$name")" "$(escape <<<"$what")"
    printf '.SH DESCRIPTION\n.nf\n'
    escape
    printf '.fi\n.SH SEE ALSO\n'
    [ "$name" = spoke ] || printf '.BR spoke (1),\n'
    printf 'the documents in the folder doc/spoke that is installed beside the program\n'
  } >"$folder/$name.1"
}

help=$("$spoke" --help)
write spoke "simulate flexible multibody systems" <<<"$help"
sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\)  *\(.*\)/\1 \2/p' <<<"$help" | while read -r command what; do
  "$spoke" "$command" --help | write "spoke-$command" "${what,}"
done
