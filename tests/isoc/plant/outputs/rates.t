#!/bin/sh
# Outputs of every n-th tick: in the row of a tick whose number is a multiple of n they are what the same output of each
# tick is, and in between what they were; in a snapshot, across 2^32 ticks, where an output is not finite, and over a
# link; on the board the same rows, and one number of instructions for all steps. What is of each tick anyhow has the
# bytes that it had.
. tests/host/test.sh
begin outputs/rates
one_isoc
real float
scene=tests/isoc/plant/outputs/rates.scene

# of_rate COLUMN SLOW EVERY: whether a column of the trace is the other one, held for so many rows.
of_rate()
{
    awk -F , -v fast="$1" -v slow="$2" -v every="$3" '
        NR == 1 { for (i = 2; i <= NF; i++) column[$i] = i; next }
        (NR - 2) % every == 0 { held = $column[fast]; due++ }
        $column[slow] != held { wrong++ }
        $column[slow] != $column[fast] { apart++ }
        END { exit !(fast in column && slow in column && wrong == 0 && due > 0 && apart > 0) }' "$out/rows"
}

tools/isochron run $scene --seconds 0.2 >"$out/summary" 2>"$out/errors" && cp "$(sed -n 's/^trace //p' "$out/summary")" "$out/rows"
result $? "the plant runs"
hash=$(sed -n 's/^hash //p' "$out/summary")
for pair in theta:theta_4 tip_x:tip_10_x tip_y:tip_10_y tip_y:along_4 turn:turn_3 mean:mean_3 late:late_10; do
    every=$(echo "$pair" | sed 's/.*_\([0-9][0-9]*\).*/\1/')
    of_rate "${pair%:*}" "${pair#*:}" "$every"
    result $? "${pair#*:}: every $every rows what ${pair%:*} is"
done
! of_rate theta theta_4 3 && ! of_rate theta mean_3 3 && ! of_rate theta theta 1
result $? "found: another rate, another output, and one of each tick"

tools/isochron run $scene --seconds 0.2 --target cortex-m4f >"$out/board" 2>"$out/errors" &&
    cmp "$(sed -n 's/^trace //p' "$out/board")" "$out/rows" >&2 && [ "$(sed -n 's/^hash //p' "$out/board")" = "$hash" ]
result $? "on the board: the same rows"
sed 's/ every .*//' $scene >"$out/fast.scene"
tools/isochron run "$out/fast.scene" --seconds 0.2 --target cortex-m4f >"$out/summary" 2>"$out/errors" &&
    [ "$(sed -n 's/^hash //p' "$out/summary")" = "$hash" ] &&
    [ "$(sed -n 's/^instructions_per_step //p' "$out/board")" -le "$(sed -n 's/^instructions_per_step //p' "$out/summary")" ]
result $? "the steps take no more than those without rates: $(grep '^instructions_per_step' "$out/board")"
tools/isochron ticks $scene >"$out/ticks" 2>"$out/errors" && grep -q '^finish [0-9]* to [0-9]* instructions$' "$out/ticks" &&
    [ "$(awk '/^finish/ { print ($2 < $4) }' "$out/ticks")" = 1 ]
result $? "the least and the most of ten ticks are told: $(grep '^finish' "$out/ticks")"
tools/isochron ticks "$out/fast.scene" >"$out/ticks" 2>"$out/errors" && ! grep -q '^finish' "$out/ticks"
result $? "and of a plant without rates there is one number alone"

isoc "$out/summary" '' $scene --name rates -o "$out" && grep -q '^outputs_every_10 add 3 mul 6 ' "$out/summary"
result $? "isoc tells the operations of each rate: $(grep -c '^outputs_every' "$out/summary") rates"
EXTRA="-I$out" program rates tests/isoc/plant/outputs/rates.c tests/host/report.c "$out/rates.c" core/runtime/snapshot.c && "$out/rates" >"$out/told"
result $? "the program of the outputs: $(grep -c '^ok' "$out/told") tests $(grep '^not ok' "$out/told")"

sed 's/^tunable divisor.*/&\ninput push N*m/; s/start 20 deg/&; drive push/' $scene >"$out/wired.scene"
isoc "$out/summary" '' "$out/wired.scene" -o "$out/wired" --link &&
    tools/isochron link "$out/wired.scene" --seconds 0.06 --controller "python3 $PWD/tests/isoc/plant/outputs/controller.py $PWD/$out/wired" >"$out/summary" 2>"$out/errors" &&
    grep -q '^rows 60 wrong 0$' "$out/summary"
result $? "a controller at the other end of a wire sees the same: $(grep '^rows' "$out/summary")"

sed 's/ every .*/ every 1 ticks/' $scene >"$out/one.scene"
isoc "$out/summary" '' "$out/one.scene" --name same -o "$out/one" && isoc "$out/summary" '' "$out/fast.scene" --name same -o "$out/fast" &&
    sed 's/ every 1 ticks//; s/one\.scene/fast.scene/' "$out/one/same.c" | sed 's/"one"/"fast"/' | cmp - "$out/fast/same.c" >&2 &&
    sed 's/one\.scene/fast.scene/' "$out/one/same.h" | cmp - "$out/fast/same.h" >&2
result $? "every 1 ticks is in each tick: it adds nothing"
{ cat models/pendulum.scene && echo 'output slow = speed of pivot every 4 ticks'; } >"$out/plant.scene"
isoc "$out/summary" '' "$out/plant.scene" -o "$out/plant" && EXTRA="-I$out/plant" program "plant/object" -c "$out/plant/plant.c"
result $? "a plant with nothing else that a row sets compiles"
{ cat $scene && echo 'effect brake { joint j; effort on j = -1 * speed of j * 1 N*m*s }
effect slows brake { j elbow }
overrun degrade { drop slows; hold; after 10 ticks }'; } >"$out/plant.scene"
for more in "" "--link --xcp open"; do
    # shellcheck disable=SC2086
    isoc "$out/summary" '' "$out/plant.scene" -o "$out/plant" $more &&
        EXTRA="-I$out/plant" program "plant/object" -c "$out/plant/plant.c"
    result $? "with a ladder that drops an effect it compiles $more"
done
finish
