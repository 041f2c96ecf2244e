# shellcheck shell=bash
# Sourced by run.sh and test.sh: installs what is missing, configures once, builds what changed.
# Everything said here goes to standard error: standard output belongs to aoscore.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$root/build/release"

say() { printf '%s\n' "$*" >&2; }

# install_packages PACKAGE…: asks apt for those that dpkg does not have.
install_packages() {
    local missing=() package as_root=()
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        [ "${AOSCORE_SKIP_SETUP:-}" = 1 ] && return
        say "This is no Debian system. Install what these Debian packages hold, then set AOSCORE_SKIP_SETUP=1:"
        say "  $*"
        exit 70
    fi
    for package in "$@"; do
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

# listed_packages FILE…: the Debian packages that these lists name.
listed_packages() {
    grep -hv '^#' "$@"
}

# install_node_packages page|tests: what package-lock.json names into node_modules/, for the page alone or for its tests
# too. Nothing is done while the lock file is the one that was installed. Debian's npm can conflict with a node that
# came from elsewhere, so that apt is asked only where there is none.
install_node_packages() {
    local wanted=$1 stamp="$root/node_modules/.aoscore-installed" lock omit=()
    lock=$(sha256sum <"$root/package-lock.json") || exit 70
    case "$(cat "$stamp" 2>/dev/null)" in
        "tests $lock" | "$wanted $lock") return ;;
    esac
    command -v node >/dev/null || install_packages nodejs
    command -v npm >/dev/null || install_packages npm
    [ "$wanted" = tests ] || omit=(--omit=dev)
    say "Installing the page's libraries (npm)"
    if ! (cd "$root" && npm ci --loglevel=error "${omit[@]}") >&2; then
        say "npm failed; see its messages above. The page is made of these libraries: nothing can be reported without."
        exit 70
    fi
    printf '%s\n' "$wanted $lock" >"$stamp"
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
