#!/bin/sh
# The cost of the dearest tick of a plant: `make cycles SCENE=...`. Ticks of a run are counted; where a tunable changes
# or a method has a history, also those of a run in which every second tick has such a change, and where the method
# watches for discontinuities, one in which every second step is made again. Of adams, ticks with all sub-steps count.
#
# Called by `make cycles`, with the scene in $SCENE, its folder in $OUT, the program in $PROGRAM, the core's table, the
# clock in Hz, the board, its flash and its RAM in $MACHINE; the compiler with all flags in $COMPILE, the link of
# $OUT/cycles/plant.o in $LINK, as $OUT/cycles/program; the command that traces $program for $nanoseconds in $TRACE; and
# objdump, size and nm.
WHAT='make cycles'
. tools/measure/common.sh
dir=$OUT/cycles
plant=$OUT/plant.c

# ticks WHAT PERIOD PROGRAM: prints the dearest of them; $TRACE reads $program and $nanoseconds.
ticks()
{
    nanoseconds=$(($2 * ticks)) program=$3
    $OBJDUMP -d "$program" >"$dir/listing" || exit 1
    eval "exec $TRACE" | build/cycles tick "tools/measure/cycles/cores/$core.txt" "$dir/listing" iso_loop_tick_float "$1" \
        interrupt=tick_interrupt,__vector_15 inputs=drive,forced,iso_port_read_float checks=amiss,admit,book_refused \
        step=step,iso_plant_attempt 'finish=finish*' outputs=iso_port_publish_float tell=tell,iso_plant_tell \
        port=iso_port_wait,iso_port_clock -=forced_cause
}

# changed CAUSE WHAT: the same of a plant with discontinuities. Its tick is 10 ms (tools/measure/forced.awk).
changed()
{
    compute forced -v discontinuity="$1" "$plant" >"$OUT/$1.c" && $COMPILE -c "$OUT/$1.c" -o "$dir/plant.o" && eval "$LINK" &&
        ticks "$2" 10000000 "$dir/program" >"$dir/$1.tsv" || fail "no ticks of $2"
    of="$of $dir/$1.tsv"
}

# shellcheck disable=SC2086
set -- $MACHINE
core=$1 hz=$2 board=$3 flash=$4 ram=$5
folders "$dir"

# So many ticks that all outputs of only some ticks meet, at least two: the first sets all counts, the second is the
# first with a change.
read_plant "$plant"
ticks=$((every < 2 ? 2 : every < 100 ? every + 1 : 101))

# Of adams, a tick with all sub-steps: of a plant whose tolerance no sub-step can meet. The budget is the next power of
# two, since so many have one length.
method=
parameters=0
while read -r word value _; do
    case $word in
    method) method=$value ;;
    parameters) parameters=$value ;;
    esac
done <"$OUT/plant.txt"
if [ "$method" = adams ]; then
    awk '/^    [.]tolerance_(absolute|relative) = / { sub(/= .*/, "= R(1e-30),") }
        /^    [.]budget = / { for (n = 1; n < $3 + 0; n *= 2) continue; sub(/= .*/, "= " n ",") }
        { print }' "$plant" >"$OUT/dearest.c"
    plant=$OUT/dearest.c
    { $COMPILE -c "$plant" -o "$dir/plant.o" && eval "$LINK"; } || fail "no plant with ticks of all sub-steps"
    PROGRAM=$dir/program
fi

of=$dir/run.tsv
ticks "a run" "$period" "$PROGRAM" >"$dir/run.tsv" || fail "the run has no ticks"
case $parameters-$members in
[1-9]*) changed changed "a run with a change of the first tunable in every second" ;;
*discontinuity*) changed input "a run with a discontinuity of the first input in every second" ;;
esac
case $members in
*before*) changed detected "a run with every second step made again, after a discontinuity" ;;
esac

{ $SIZE "$PROGRAM" && $NM -S "$PROGRAM"; } >"$dir/sizes" || exit 1
# shellcheck disable=SC2086
compute program_size -f tools/measure/cycles/report.awk scene="$SCENE" board="$board" hz="$hz" period="$period" flash="$flash" ram="$ram" \
    tsv="$OUT/cycles.tsv" sizes="$dir/sizes" $of
