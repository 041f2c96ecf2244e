#!/usr/bin/env bash
# One step of action.yml: runs $ARGUMENTS in the image aoscore, with the page and its results in $RUNNER_TEMP/aoscore/report
# and the table in the job's summary. Ends with the exit code of aoscore, so that a tripped --fail fails the job.
set -uo pipefail

own=$RUNNER_TEMP/aoscore
mkdir -p "$own/cache" "$own/report"

# Quotes count as in a shell; nothing is expanded or run.
if ! split=$(xargs printf '%s\n' <<<"$ARGUMENTS") || [ -z "$split" ]; then
    echo "::error title=aoscore::the input \"arguments\" is empty, or has a quote that is not closed" >&2
    exit 64
fi
mapfile -t words <<<"$split"

case ${words[0]} in
    compare) outputs=(--page /report/index.html) ;;
    *) outputs=(--out /report/results) ;;
esac

docker run --rm --user "$(id -u):$(id -g)" \
    --volume "$GITHUB_WORKSPACE:/work" --volume "$own/cache:/cache" --volume "$own/report:/report" \
    --env AOSCORE_CACHE=/cache --env HOME=/tmp \
    aoscore "${words[@]}" "${outputs[@]}" --export /report/table.md
status=$?

[ ! -f "$own/report/table.md" ] || cat "$own/report/table.md" >>"$GITHUB_STEP_SUMMARY"
case $status in
    0) ;;
    2) echo "::error title=Ambient occlusion::a limit was tripped; the page is among the artifacts" >&2 ;;
    *) echo "::error title=aoscore::exit code $status; README.md says what it means" >&2 ;;
esac
exit "$status"
