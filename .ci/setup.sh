# Sourced by run.sh and test.sh: installs what is missing, configures once, builds what changed.
# Everything said here goes to standard error: standard output belongs to aoscore.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$root/build/release"

say() { printf '%s\n' "$*" >&2; }

# install_packages FILE…: the Debian packages named in these lists. Asks apt only for what dpkg does not have.
install_packages() {
    local wanted missing=() package as_root=()
    mapfile -t wanted < <(grep -hv '^#' "$@")
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        [ "${AOSCORE_SKIP_SETUP:-}" = 1 ] && return
        say "This is no Debian system. Install what these Debian packages hold, then set AOSCORE_SKIP_SETUP=1:"
        say "  ${wanted[*]}"
        exit 70
    fi
    for package in "${wanted[@]}"; do
        [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] && return
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            say "These packages are missing, and neither root nor sudo is at hand: ${missing[*]}"
            exit 70
        fi
        as_root=(sudo)
    fi
    say "Installing ${#missing[@]} Debian packages: ${missing[*]}"
    local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 -q)
    if ! { "${apt[@]}" update && "${apt[@]}" install -y --no-install-recommends "${missing[@]}"; } >&2; then
        say "apt-get failed; see its messages above."
        exit 70
    fi
}

# build_release TESTS TARGET…: configures when that was never done (or the tests come in now), then builds.
build_release() {
    local tests=$1 cached=""
    shift
    [ -f "$build/CMakeCache.txt" ] && cached=$(sed -n 's/^AOSCORE_TESTS:BOOL=//p' "$build/CMakeCache.txt")
    if [ ! -f "$build/build.ninja" ] || { [ "$tests" = ON ] && [ "$cached" != ON ]; }; then
        say "Configuring"
        (cd "$root" && cmake --preset release -DAOSCORE_TESTS="$tests") >&2 || exit 70
    fi
    # ninja says "no work to do" when nothing changed; that is not worth a line.
    local target_options=()
    [ $# -gt 0 ] && target_options=(--target "$@")
    cmake --build "$build" "${target_options[@]}" 2>&1 | { grep -v -e 'ninja: no work to do' -e '^\[0/' || true; } >&2
    [ "${PIPESTATUS[0]}" -eq 0 ] || exit 70
}
