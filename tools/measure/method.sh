#!/bin/sh
# Measures one method in one kind, in $dir/KIND-METHOD/; called by `each`.
#
#     method.sh points|search|instructions|points_in_loop|search_in_loop KIND METHOD
. tools/measure/methods.sh
command=$1
kind=$2
method=$3
of=$dir/$kind-$method

# within PROGRAM REFERENCE [OPTION...]: the result of search.awk with the program.
within()
{
    within_program=$1 within_reference=$2
    shift 2
    compute reference -f tools/measure/search.awk -v drive="$within_program" -v time="$time" -v most="$error" "$@" "$within_reference" || exit 255
}

# of_step: $cost are the instructions of a step.
of_step()
{
    case $kind in
    double) instructions_host double "$method" ;;
    *) instructions_m4f "$kind" "$method" ;;
    esac
}

# folders_of_tolerances TOLERANCE...: those that `of_step` works in.
folders_of_tolerances()
{
    for tolerance; do
        shift
        case $kind in
        double) set -- "$@" "$dir/count-$kind-$method$tolerance" ;;
        *) set -- "$@" "$of/m4f$tolerance" ;;
        esac
    done
    folders "$@"
}

# points: the states that the method reaches with six steps, each half of the one before, or adams with six tolerances;
# and `measured`, a line for each: kind and method, the instructions of a step, the tolerance, `-` for steps that are
# all the same, and that of points.
points()
{
    take "$method"
    variable "$kind" "$method" || fail "$method cannot be built for $SCENE in $kind; METHODS='...' chooses others"
    if [ -n "$TOLERANCE" ]; then
        # In float rounding would be taken for an error below the last one.
        case $kind in
        double) points="1e-3 1e-5 1e-7 1e-9 1e-11 1e-13" ;;
        *) points="1e-3 1e-4 1e-5 1e-6 1e-7 1e-8" ;;
        esac
        # shellcheck disable=SC2086
        folders_of_tolerances $points
        for TOLERANCE in $points; do
            of_step || exit 255
            echo "$cost $TOLERANCE"
        done
    else
        points="$coarsest $((2 * coarsest)) $((4 * coarsest)) $((8 * coarsest)) $((16 * coarsest)) $((32 * coarsest))"
        of_step || exit 255
        for _ in $points; do
            echo "$cost -"
        done
    fi >"$of/costs"
    # shellcheck disable=SC2086
    "$of/drive" "$time" $points >"$of/points" || fail "$method in $kind does not run"
    while read -r line && read -r point <&3; do
        echo "$kind $method $line $point"
    done <"$of/costs" 3<"$of/points" >"$of/measured"
}

# search: `bench`, the errors at steps of twice the scene's and at the scene's, the fewest steps from which on the error
# stays at most $error, 0 if that takes steps shorter than 1 us, and `-`. Of adams, which has no error at a step, `- -`,
# the steps and the largest tolerance from which on it does; 0 if there is none.
search()
{
    take "$method"
    variable "$kind" "$method" || fail "$method cannot be built for $SCENE; METHODS='...' chooses others"
    within "'$of/drive'" "$dir/reference.txt" -v coarsest="$([ -n "$TOLERANCE" ] || echo "$coarsest")" >"$of/bench"
}

# instructions: of a step on the Cortex-M4F; of adams, at the tolerance that `search` found, and with the evaluations of
# a sub-step. Below 1e-8 rounding in float would be taken for an error, and steps for too large: sub-steps are measured
# at 1e-8.
instructions()
{
    folders "$of"
    take "$method"
    [ -z "$TOLERANCE" ] || TOLERANCE=$(awk '{ print ($4 > 1e-8 ? $4 : 1e-8) }' "$dir/double-$method/bench")
    {
        instructions_m4f "$kind" "$method" || exit 255
        echo "$cost"
        awk '{ said[$1] = $2 } END { if (said["substeps"]) printf "%.2f\n", said["evaluations"] / said["substeps"] }' "$m4f/measured"
    } >"$of/instructions"
}

# lines KIND OF MODE FIRST: lines of `measured` for FIRST steps and their doubles, by the program of kind OF in MODE.
lines()
{
    instructions_host "$2" "$method" || exit 255
    "$dir/$2-$method/drive" "$3" "$time" "$4" $((2 * $4)) $((4 * $4)) $((8 * $4)) $((16 * $4)) $((32 * $4)) |
        sed "s/^/$1 $method $cost - /"
}

# points_in_loop: looped-held and looped-smooth, each with a line for six steps, of the kind `held` or `smooth`. The
# longest step of held inputs is the tick; of smooth ones, four times that.
points_in_loop()
{
    lines held double held $((4 * coarsest)) >"$of/looped-held"
    : >"$of/looped-smooth"
    if [ -s "$dir/smooth.txt" ]; then
        variable smooth "$method" || fail "$method with smooth inputs cannot be built for $SCENE"
        lines smooth smooth smooth "$coarsest" >"$of/looped-smooth"
    fi
}

# search_in_loop: in a loop, whose ticks are the scene's step: `loop`, the errors with one step a tick and the fewest
# steps from which on the error stays at most $error, 0 if they are shorter than 1 us: with held inputs against the
# staircase, with as many steps in every tick; with smooth ones, sampled at every step, against the continuous signal.
# And $dir/smooth_float-METHOD/instructions, those of a step on the Cortex-M4F.
search_in_loop()
{
    variable smooth "$method" || fail "$method with smooth inputs cannot be built for $SCENE"
    folders "$dir/smooth_float-$method/m4f"
    {
        within "'$of/drive' held" "$dir/restarted.txt" -v coarsest="$coarsest"
        if [ -s "$dir/smooth.txt" ]; then
            within "'$dir/smooth-$method/drive' smooth" "$dir/smooth.txt" -v coarsest="$coarsest"
        else
            echo '- - 0 -'
        fi
    } >"$of/loop"
    instructions_m4f smooth_float "$method" || exit 255
    echo "$cost" >"$dir/smooth_float-$method/instructions"
}

$command || exit 1
book
echo "$WHAT: $count of $total: $method in $kind" >&2
