#!/bin/sh
# One method in one kind: $dir/KIND-METHOD/points, the states it reaches with six steps, each half of the one before,
# and $dir/KIND-METHOD/instructions, those of a step.
#
#     measure.sh KIND METHOD
. tools/report/common.sh
kind=$1
method=$2

(variable "$kind" "$method") || fail "$method cannot be built for $SCENE in $kind; METHODS='...' chooses others"
"$dir/$kind-$method/drive" "$time" "$coarsest" $((2 * coarsest)) $((4 * coarsest)) $((8 * coarsest)) $((16 * coarsest)) \
    $((32 * coarsest)) >"$dir/$kind-$method/points" || fail "$method in $kind does not run"
if [ "$kind" = double ]; then
    instructions_host "$method"
else
    instructions_m4f "$kind" "$method"
fi >"$dir/$kind-$method/instructions" || exit 255
