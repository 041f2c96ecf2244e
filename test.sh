#!/usr/bin/env bash
# Sets up, builds, and runs all tests; arguments go to ctest (for example: ./test.sh -R hostile).
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/.ci/setup.sh"

mapfile -t packages < <(listed_packages "$root/.ci/packages.txt" "$root/.ci/packages-test.txt")
install_packages "${packages[@]}"
install_node_packages tests
build_release ON
exec ctest --test-dir "$build" --output-on-failure -j "$(nproc)" "$@"
