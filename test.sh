#!/usr/bin/env bash
# Sets up, builds, and runs all tests; arguments go to ctest (for example: ./test.sh -R hostile).
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/.ci/setup.sh"

install_packages "$root/.ci/packages.txt" "$root/.ci/packages-test.txt"
build_release ON
exec ctest --test-dir "$build" --output-on-failure -j "$(nproc)" "$@"
