#!/usr/bin/env bash
# No source outside of src/metrics/ names a metric by its id: who needs one takes it from src/metrics/roles.h or walks the
# table, so that a metric is one file and one row of src/metrics/metrics.cpp. Ids are also ordinary words: where they name
# something else, the place stands below.
set -uo pipefail
src=$1
ids=$(sed -n 's/.*{\.id = "\([a-z_]*\)".*/\1/p' "$src/metrics/metrics.cpp")
[ "$(wc -w <<<"$ids")" -ge 5 ] || {
    echo "$src/metrics/metrics.cpp: no table of metrics found"
    exit 1
}

# FILE:ID, where the word is not a metric: a parameter of methods, a setting of the truth, a field of a page's model.
others='
store/truth/truth_request.cpp:max_error
page/sections/claims.cpp:bias
page/sections/claims.cpp:ssim
page/sections/published.cpp:bias
page/stress_page.cpp:rmse
page/sections/sweeps.cpp:bias
'
failures=0
for id in $ids; do
    while IFS=: read -r file line text; do
        grep -qx "${file#"$src/"}:$id" <<<"$others" && continue
        echo "$file:$line: names the metric \"$id\""
        failures=$((failures + 1))
    done < <(grep -rn "\"$id\"" "$src" --include='*.h' --include='*.cpp' |
        grep -v "^$src/metrics/" |
        grep -v "visit(\"$id\"" |              # a member of a record
        grep -v "claims/quantity.cpp:.*{\"$id\", \"" |  # an id of the table of quantities
        grep -v '^[^:]*:[0-9]*: *//')
done
[ "$failures" -eq 0 ] || exit 1
echo "metrics are named in src/metrics alone"
