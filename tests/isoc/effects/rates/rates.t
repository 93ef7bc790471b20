#!/bin/sh
# Sub-steps of an effect (`substeps 4` in its use): the orders of the scheme, a closed form, where it is stable and what
# isoc says of that, the bits and the cost on the board, and that a scene without it has nothing of it.
. tests/host/test.sh
begin rates
one_isoc
optimised -O0
unrolled=$FLAGS
motor=tests/isoc/effects/rates/motor.scene

for number in float double; do
    real $number
    rolled
    program order.$number tests/isoc/effects/rates/order.c tests/host/report.c
    joined $number "$out/order.$number"
    sed -n 's/.* an exchange without loss, \(.*\) is left; with sub-steps \(.*\)/\1 \2/p' "$out/tap" >"$out/left.$number"
    FLAGS=$unrolled
    isoc "$out/summary" '' $motor -o "$out/$number" --real $number &&
        EXTRA="-DPLANT=\"$out/$number/plant.c\"" program motor.$number tests/isoc/effects/rates/motor.c tests/host/report.c
    joined "motor, $number" "$out/motor.$number"
done
mkdir -p "$out/planted/core/methods" &&
    sed 's/i < 2 ? R(0.0)/i < 4 ? R(0.0)/' core/methods/multirate.h >"$out/planted/core/methods/multirate.h" &&
    ! cmp -s core/methods/multirate.h "$out/planted/core/methods/multirate.h" &&
    FLAGS="-I$out/planted -DISO_UNROLL= $FLAGS" program bent tests/isoc/effects/rates/order.c tests/host/report.c && ! "$out/bent" >"$out/found" &&
    grep -q '^not ok .* rk4' "$out/found"
result $? 'found: slow states that move along straight lines'

# stable METHOD SUBSTEPS yes|no: whether the motor is held so, as the run and isoc say. 0 sub-steps: none.
stable()
{
    real float
    sed "s/; substeps 16/; substeps $2/; s/; substeps 0//" $motor >"$out/motor.scene"
    isoc "$out/summary" "$out/told" "$out/motor.scene" --method "$1" -o "$out/held"
    said=yes held=yes
    ! grep -q "the effect 'drive' is too fast for $1" "$out/told" || said=no
    EXTRA="-DPLANT=\"$out/held/plant.c\"" program holds tests/isoc/effects/rates/holds.c && { "$out/holds" || held=no; }
    [ $said = "$3" ] && [ $held = "$3" ]
    result $? "$1, $2 sub-steps of a motor of 50 us in 1 ms: stable $held, isoc says $said"
}
stable rk4 0 no
stable rk4 6 no
stable rk4 8 yes
stable heun 16 yes
stable euler 16 yes
# A sub-step is held up to 2.785 times 50 us.
sed 's/; substeps 16/; substeps 6/' $motor >"$out/motor.scene"
isoc "$out/summary" "$out/told" "$out/motor.scene" --step 0.830ms -o "$out/held" && ! grep -q warning "$out/told" &&
    isoc "$out/summary" "$out/told" "$out/motor.scene" --step 0.840ms -o "$out/held" && grep -q 'euler 0.6 ms, heun 0.6 ms, rk4 0.836 ms' "$out/told"
result $? '6 sub-steps hold a step of 0.83 ms, and not one of 0.84 ms: euler 0.6 ms, heun 0.6 ms, rk4 0.836 ms'
# What has no sub-steps is judged by the step.
{ cat $motor && echo 'effect bearing friction { along shaft; sliding 5 N*m; creep 1 rad/s }'; } >"$out/rough.scene"
isoc "$out/summary" "$out/told" "$out/rough.scene" -o "$out/rough" &&
    grep -q "the effect 'bearing' is too fast for rk4 with a step of 1 ms, 16 sub-steps of it for effects: .* -750[0-9]" "$out/told" &&
    ! grep -q "the effect '[dt]" "$out/told"
result $? 'a friction that is too steep is told, and not the motors'

# row COLUMN: what is left by each method, as a table has it: 1 without sub-steps, 2 with.
row()
{
    awk -v column="$1" '{ row = row " | " $column } END { print row " |" }' "$out/left.float"
}
stated core/README.md "of a decay within 50 us | 0.6 ms | 0.6 ms | 0.836 ms |" && stated core/README.md "of 0.25 rad, of 1$(row 2)" &&
    stated core/README.md "the same without sub-steps$(row 1)"
result $? 'as core/README.md says'

# On the board.
run()
{
    tools/isochron run "$out/$1.scene" --target "$2" --seconds 0.2 >"$out/$1.$2" 2>"$out/errors"
}
value()
{
    sed -n "s/^$2 //p" "$out/$1"
}
sed 's/input volts V/& = 6 V/' $motor >"$out/apart.scene"
sed 's/; substeps 16//' "$out/apart.scene" >"$out/plain.scene"
run apart host && run apart cortex-m4f && [ "$(value apart.host hash)" = "$(value apart.cortex-m4f hash)" ]
result $? "the board has the bits of the host: $(value apart.host hash)"
# One of the library's models, which has a mechanism of more than two rotors: friction.
cp models/dc_motor_bench.scene "$out/bench.scene"
sed 's|^    constant 50 mN.m/A|&; substeps 4|' "$out/bench.scene" >"$out/parted.scene"
{ cat "$out/bench.scene" && echo 'substeps 4'; } >"$out/whole.scene"
run bench cortex-m4f && run parted cortex-m4f && run whole cortex-m4f
plain=$(value bench.cortex-m4f instructions_per_step) parted=$(value parted.cortex-m4f instructions_per_step)
whole=$(value whole.cortex-m4f instructions_per_step)
[ "$parted" -gt "$plain" ] && [ "$parted" -lt $((whole * 3 / 4)) ]
result $? "a step of dc_motor_bench takes $plain instructions, with 4 sub-steps of the motor $parted, one number, of the whole plant $whole"
stated core/README.md "takes $plain instructions of a step, with 4 sub-steps of the motor $parted, with 4 of the whole plant $whole."
result $? 'as core/README.md says'

# Under a ladder each rung has its own step of both rates, and one that drops all effects with sub-steps a plain one.
# The top costs what it does alone, and the 13 instructions of a ladder.
{ cat "$out/parted.scene" && echo 'overrun degrade { method heun; drop drive; after 10 ticks }'; } >"$out/ladder.scene"
run ladder cortex-m4f
ladder=$(value ladder.cortex-m4f instructions_per_step)
[ "$(value ladder.cortex-m4f hash)" = "$(value parted.cortex-m4f hash)" ] && [ "$ladder" -le $((parted + 13)) ] &&
    [ "$(grep -c '  iso_multirate_step(ISO_RK4\|  iso_multirate_step(ISO_HEUN\|  iso_method_step(ISO_HEUN' "$(dirname "$(value ladder.cortex-m4f trace)")/plant.c")" -eq 3 ]
result $? "the steps of a ladder: at its top $ladder instructions"
stated core/README.md "and a step $((ladder - parted)) instructions more"
result $? 'as core/README.md says'

# Nothing of it where it is not asked for.
isoc "$out/summary" '' "$out/apart.scene" --without 'drive; slow; twin' -o "$out/left" --name same &&
    isoc "$out/summary" '' "$out/plain.scene" --without 'drive; slow; twin' -o "$out/never" --name same &&
    sed 's/apart/plain/' "$out/left/same.c" | cmp -s - "$out/never/same.c"
result $? 'an effect that is left out takes its sub-steps with it: the same bytes'
isoc "$out/summary" "$out/told" "$out/plain.scene" -o "$out/never" && ! grep -q 'multirate\|fast' "$out/never/plant.c" &&
    isoc "$out/summary" '' "$out/apart.scene" -o "$out/never" && grep -q multirate "$out/never/plant.c"
result $? 'a plant without them has nothing of them'
finish
