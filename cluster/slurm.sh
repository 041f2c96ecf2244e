#!/usr/bin/env bash
# Submits the work of one aoscore command to Slurm in parts, then its page:
#
#     cluster/slurm.sh 8 score atrium --samples 64 --out page
#
# Each part is one task of an array; they share the cache that AOSCORE_CACHE names, which must be the same folder on every
# node. A part that is killed or loses its node is done again by `scontrol requeue`, and goes on where it was. The page is
# made when all have ended well. `--node-kind NAME` in the command says on which nodes times are taken: those whose
# AOSCORE_NODE_KIND is that name. SBATCH_… variables (partition, account, memory) count as always; AOSCORE is the program,
# AOSCORE_WORK the folder for the plan and the logs. Prints the number of the job that makes the page.
set -euo pipefail
[ $# -ge 2 ] || { echo "usage: $0 PARTS COMMAND..." >&2; exit 64; }
parts=$1
shift
aoscore=${AOSCORE:-aoscore}
work=${AOSCORE_WORK:-work}
mkdir -p "$work"
"$aoscore" plan --parts "$parts" --out "$work/plan.json" "$@" >&2
array=$(sbatch --parsable --requeue --job-name=aoscore-part --array="1-$parts" --output="$work/part-%a.log" \
    --wrap="exec $(printf '%q' "$aoscore") work $(printf '%q' "$work/plan.json") --part \$SLURM_ARRAY_TASK_ID")
sbatch --parsable --job-name=aoscore-page --dependency="afterok:${array%%;*}" --output="$work/page.log" \
    --wrap="exec $(printf '%q ' "$aoscore" "$@")"
