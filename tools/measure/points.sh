#!/bin/sh
# One method in one kind: $dir/KIND-METHOD/points, the states it reaches with six steps, each half of the one before, or
# of adams with six tolerances; and $dir/KIND-METHOD/measured, a line for each: the instructions of a step, the
# tolerance, `-` for steps that are all the same, and that of points.
#
#     points.sh KIND METHOD
. tools/measure/methods.sh
kind=$1
method=$2
of=$dir/$kind-$method

# instructions: of a step.
instructions()
{
    case $kind in
    double) instructions_host double "$method" ;;
    *) instructions_m4f "$kind" "$method" ;;
    esac
}

take "$method"
(variable "$kind" "$method") || fail "$method cannot be built for $SCENE in $kind; METHODS='...' chooses others"
if [ -n "$TOLERANCE" ]; then
    # In float rounding would be taken for an error below the last one.
    case $kind in
    double) points="1e-3 1e-5 1e-7 1e-9 1e-11 1e-13" ;;
    *) points="1e-3 1e-4 1e-5 1e-6 1e-7 1e-8" ;;
    esac
    for TOLERANCE in $points; do
        cost=$(instructions) || exit 255
        echo "$cost $TOLERANCE"
    done
else
    points="$coarsest $((2 * coarsest)) $((4 * coarsest)) $((8 * coarsest)) $((16 * coarsest)) $((32 * coarsest))"
    cost=$(instructions) || exit 255
    for _ in $points; do
        echo "$cost -"
    done
fi >"$of/costs"
# shellcheck disable=SC2086
"$of/drive" "$time" $points >"$of/points" || fail "$method in $kind does not run"
paste -d ' ' "$of/costs" "$of/points" >"$of/measured"
progress "$@"
