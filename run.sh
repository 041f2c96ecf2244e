#!/usr/bin/env bash
# Sets up, builds, and runs aoscore. Without arguments: the main job, which prints the path of its page.
# With arguments: passes them to aoscore, and its exit code on.
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/.ci/setup.sh"

mapfile -t packages < <(listed_packages "$root/.ci/packages.txt")
install_packages "${packages[@]}"
install_node_packages page
build_release OFF aoscore
if [ $# -eq 0 ]; then set -- run; fi
exec "$build/bin/aoscore" "$@"
