#!/usr/bin/env bash
# CONTRIBUTING's table must name every room with the rooms it may use, as the room's CMakeLists.txt has them after ROOMS, and
# a room of more than 3,000 lines must have folders.
set -uo pipefail
root=$1
failures=0

complain() {
    printf '%s\n' "$*"
    failures=$((failures + 1))
}

sorted() { tr -s ', ' '\n' | grep . | sort | xargs; }

for list in "$root"/src/*/CMakeLists.txt; do
    room=$(basename "$(dirname "$list")")
    row=$(grep -F "| \`src/$room/\` |" "$root/CONTRIBUTING.md") || {
        complain "CONTRIBUTING.md: its table of rooms lacks src/$room/"
        continue
    }
    stated=$(awk -F '|' '{ print $4 }' <<<"$row" | sorted)
    built=$(sed -n 's/.*ROOMS \([a-z ]*\).*/\1/p' "$list" | sorted)
    [ "$stated" = everything ] || [ "$stated" = "$built" ] ||
        complain "CONTRIBUTING.md: src/$room/ may use \"$built\" by its CMakeLists.txt, \"$stated\" by the table"
    lines=$(find "$root/src/$room" \( -name '*.h' -o -name '*.cpp' \) -exec cat {} + | wc -l)
    folders=$(find "$root/src/$room" -mindepth 1 -type d | wc -l)
    [ "$lines" -le 3000 ] || [ "$folders" -gt 0 ] ||
        complain "src/$room/: holds $lines lines; divide it by subject"
done

[ "$failures" -eq 0 ] || exit 1
echo "every room is named, with what it may use"
