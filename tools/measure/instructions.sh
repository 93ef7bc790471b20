#!/bin/sh
# One method in float: $dir/float-METHOD/instructions, those of a step on the Cortex-M4F; of adams, at the tolerance that
# search.sh found, and with the evaluations of a sub-step. Below 1e-8 rounding in float would be taken for an error, and
# steps for too large: what a sub-step takes is measured there.
#
#     instructions.sh float METHOD
. tools/measure/methods.sh
mkdir -p "$dir/float-$2"
take "$2"
[ -z "$TOLERANCE" ] || TOLERANCE=$(awk '{ print ($4 > 1e-8 ? $4 : 1e-8) }' "$dir/double-$2/bench")
{
    instructions_m4f float "$2" || exit 255
    awk '{ said[$1] = $2 } END { if (said["substeps"]) printf "%.2f\n", said["evaluations"] / said["substeps"] }' "$m4f/run"
} >"$dir/float-$2/instructions"
progress "$@"
