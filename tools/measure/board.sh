# shellcheck shell=sh
# Counts of firmware on the Cortex-M4F in float; read by the tables of costs.
. tools/measure/common.sh

# measure DIR SCENE METHOD [GOAL...]: builds the firmware in build/cost/DIR and runs it for $seconds; the output is in
# build/cost/DIR/measured.
STEP=
seconds=0.05
measure()
{
    dir=build/cost/$1
    measure_scene=$2 measure_method=$3
    shift 3
    on_board "$dir" "$measure_scene" "$measure_method" $seconds "run${*:+ $*}" ||
        fail "$measure_scene with $measure_method cannot be measured; see $dir/measured and $dir/said"
}

# get KEY...: for each $KEY, its one value in the last measurement; a limit may follow it. Fails if the steps differ.
get()
{
    for get_key; do
        get_count=0
        while read -r get_word get_value get_of _; do
            case $get_word-$get_of in
            "$get_key-" | "$get_key-of") eval "$get_key=\$get_value" && get_count=$((get_count + 1)) ;;
            esac
        done <"$dir/measured"
        [ $get_count -eq 1 ] || fail "$dir/measured has not one $get_key"
    done
}

# tick: $tick are the most instructions from the time that a tick is due until its outputs are published: 25 in a
# microsecond, less the margin.
tick()
{
    awk '$1 == "step" { step = $2 } $1 == "margin" { margin = $2; n++ }
        END { if (n != 1) exit 1; printf "%.0f\n", step * 25e6 - margin }' "$dir/measured" >"$dir/tick" ||
        fail "$dir/measured has not one margin"
    read -r tick <"$dir/tick"
}

# count_operations: $operations are those of a derivative, as cells: add, mul, div, sincos; $states is the number of
# states.
count_operations()
{
    operations=
    while read -r get_key states_so_far add _ mul _ div _ sincos _; do
        case $get_key in
        states) states=$states_so_far ;;
        derivative) operations="$operations$add | $mul | $div | $sincos" ;;
        esac
    done <"$dir/plant.txt"
    case $operations in
    *' | '*' | '*' | '*[!0-9]* | '') fail "$dir/plant.txt has not one line of operations" ;;
    esac
}

# longest_step DIR SCENE METHOD announced|detected [STATEMENT...]: the instructions of the longest step of a run in
# which every second tick has a discontinuity; the scene with these statements, and the cause, is in build/cost/DIR. The
# run of adams has a tolerance that cannot be met as well: it restarts, then tries all of its sub-steps and rejects
# none. A rejected sub-step has no correction, which is the longest part of one; the restart within the tick, or the
# half step, that it has instead is shorter. How often order and step change depends on the motion: that adds less than
# a sub-step (tests/promises/cost.t).
longest_step()
{
    folder=build/cost/$1
    folders "$folder/firmware"
    elsewhere "$2" | sed '/^method /d' >"$folder/forced.scene"
    method=$3
    discontinuity=$4
    firmware=$1/firmware
    shift 4
    case $method-$discontinuity-$* in
    adams-*-tolerance*) ;;
    adams-*) set -- 'tolerance 1e-30' "$@" ;;
    *-detected-*) set -- 'checked yes' "$@" ;;
    esac
    printf '%s\n' "method $method" 'tunable forced = 1' "$@" >>"$folder/forced.scene"
    { build/isoc "$folder/forced.scene" -o "$folder" >"$folder/plant.txt" &&
        compute forced -v discontinuity="$discontinuity" "$folder/plant.c" >"$folder/forced.c"; } ||
        fail "no plant of $folder/forced.scene"
    seconds=2
    measure "$firmware" "$folder/forced.c" ''
    seconds=0.05
    awk '$1 == "execution" { most = $4 } $1 == "restart_execution" { n++; most = $2 > most ? $2 : most }
        END { if (n != 1) exit 1; print most }' "$dir/measured" || fail "$dir/measured has not one restart_execution"
}
