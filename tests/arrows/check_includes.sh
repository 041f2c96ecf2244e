#!/usr/bin/env bash
# Every "room/…" include of src/<room>/ must be the room itself or stand after ROOMS in src/<room>/CMakeLists.txt
# (src/cli may use all rooms). Libraries that only one room may see are checked as well.
set -uo pipefail
src=$1
failures=0

complain() {
    printf '%s\n' "$*"
    failures=$((failures + 1))
}

cd "$src" || exit 1
while IFS= read -r line; do
    complain "$line"
done < <(
    for list in */CMakeLists.txt; do
        room=${list%%/*}
        [ "$room" = cli ] && allowed="" || allowed=$(sed -n 's/.*ROOMS \([a-z ]*\).*/\1/p' "$list")
        printf 'room %s %s\n' "$room" "$allowed"
    done | awk -v includes=<(grep -rnE '^#include "[a-z]+/' --include='*.h' --include='*.cpp' .) '
        { rooms[$2]; for (i = 3; i <= NF; ++i) may[$2, $i] }
        END {
            while ((getline line < includes) > 0) {
                split(line, part, "\"")
                split(part[2], to, "/")
                split(line, from, "/")
                if (from[2] == "cli" || !(to[1] in rooms) || to[1] == from[2]) continue
                if (!((from[2], to[1]) in may)) print line ": " from[2] " must not include " to[1]
            }
        }'
)

# only HEADER ROOM…: the header is seen by these folders or files alone.
only() {
    local header=$1 place
    shift
    while read -r file; do
        for place in "$@"; do
            case "$file" in "$place"*) continue 2 ;; esac
        done
        complain "$file: <$header> belongs to $* alone"
    done < <(grep -rlE "#include <$header" --include='*.h' --include='*.cpp' -- *)
}
only embree3/ reference/tracer/embree/ reference/benchmark/
only GL/osmesa screen/gl/osmesa_context
only EGL/ screen/gl/egl_context
only GL/ screen/
only Imf image/
only OpenEXR image/
only OpenImageIO formats/
only png.h image/
only tiny_gltf scene/
only assimp/ importer/
only tiny_obj_loader importer/

[ "$failures" -eq 0 ] || exit 1
echo "all includes follow the arrows"
