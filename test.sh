#!/usr/bin/env bash
# Sets up, builds, and runs all tests; arguments go to ctest (for example: ./test.sh -R hostile).
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/.ci/setup.sh"

# print_failed_tests FOLDER: what the failed tests wrote (at most 200 lines each), from the two files that ctest keeps there.
print_failed_tests() {
    awk 'NR == FNR { sub(/^[0-9]+:/, ""); failed[$0]; next }
        / Testing: / { name = $0; sub(/^.* Testing: /, "", name); lines = 0 }
        name in failed && lines++ < 200' "$1/LastTestsFailed.log" "$1/LastTest.log"
}

mapfile -t packages < <(listed_packages "$root/.ci/packages.txt" "$root/.ci/packages-test.txt")
install_packages "${packages[@]}"
install_node_packages tests
build_release ON
ctest --test-dir "$build" --output-on-failure -j "$(nproc)" "$@"
status=$?
# Once more at the end, where it is found in a log of which only the end was kept.
failures=$build/Testing/Temporary
[ "$status" -eq 0 ] || [ ! -f "$failures/LastTestsFailed.log" ] || print_failed_tests "$failures"
exit "$status"
