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

rooms=$(cd "$src" && ls -d */ | tr -d /)
for room in $rooms; do
    [ "$room" = cli ] && continue
    allowed=" $room $(sed -n 's/.*ROOMS \([a-z ]*\).*/\1/p' "$src/$room/CMakeLists.txt") "
    while IFS=: read -r file line include; do
        target=$(sed 's/.*"\([a-z]*\)\/.*/\1/' <<<"$include")
        case " $rooms " in *[[:space:]]"$target"[[:space:]]*) ;; *) continue ;; esac
        case "$allowed" in *" $target "*) ;; *) complain "$file:$line: $room must not include $target" ;; esac
    done < <(grep -rnE '^#include "[a-z]+/' "$src/$room" --include='*.h' --include='*.cpp')
done

# only HEADER ROOM…: the header is seen by these folders or files alone.
only() {
    local header=$1 place
    shift
    while read -r file; do
        for place in "$@"; do
            case "$file" in "$src/$place"*) continue 2 ;; esac
        done
        complain "$file: <$header> belongs to $* alone"
    done < <(grep -rlE "#include <$header" "$src")
}
only embree3/ reference/
only GL/osmesa screen/osmesa_context
only GL/ screen/
only Imf results/
only OpenEXR results/
only OpenImageIO results/ scene/
only tiny_gltf scene/
only assimp/ importer/
only tiny_obj_loader importer/

[ "$failures" -eq 0 ] || exit 1
echo "all includes follow the arrows"
