#!/bin/sh
# Tunables keep the conditions of the effects and functions that use them: at their defaults and where the scene sets
# them isoc sees to it, in a run the plant.
. tests/host/test.sh
begin tunables_conditions
one_isoc
optimised -O1

# conditions SCENE: its program.
conditions()
{
    isoc "$out/summary" "$out/told" "$1" -o "$out/plant" --real "$real" --method "${2-rk4}" &&
        EXTRA="-DPLANT=\"$out/plant/plant.c\"" program run tests/isoc/plant/tunables/conditions.c tests/host/report.c
}
for number in double float; do
    real $number
    conditions tests/isoc/plant/tunables/conditions.scene
    joined "$number" "$out/run"
    conditions tests/isoc/plant/tunables/conditions.scene ab4
    joined "ab4, $number" "$out/run"
done
{ sed 's/ and stiffness > 0//' models/effects/stop.scene && sed 's/log(free)/0/' tests/isoc/plant/tunables/conditions.scene; } >"$out/fewer.scene"
conditions "$out/fewer.scene" && ! "$out/run" >"$out/tap"
result $? 'found: an effect and a scene without these conditions'

# refused LINE TEXT [SED]: isoc refuses the scene with a line more, or changed so, and says this.
refused()
{
    { sed "${3-}" tests/isoc/plant/tunables/conditions.scene; echo "$1"; } >"$out/bad.scene"
    ! isoc "$out/summary" "$out/errors" "$out/bad.scene" -o "$out/bad" && grep -q "bad.scene:[0-9]*:[0-9]*: error: .*$2" "$out/errors" &&
        [ ! -e "$out/bad" ]
    result $? "refused: ${1:-$3}"
}
refused 'at 1 s set hard = -1 N/m' '-1 is not above 0'
refused 'at 1 s set bounce = 0' '0 is not at least 0.01'
refused 'at 1 s set free = 0' '0 is not above 0'
refused 'at 1 s set top = 0.7 m; at 2 s set bounce = 0.8' '0.7 is not at least 0.8'
refused '' "'ends' breaks what its effect requires" 's/20 kN/-20 kN/'
refused '' 'log takes a number larger than zero' 's/free = 3/free = 0/'
refused '' 'the limits are in the wrong order' 's/top = 1 m/top = 0.4 m/'

# What bodies, joints, springs and closures require of their numbers. A tunable that any of them reads may not be set to
# what it may not be by default. mechanism UNIT BAD STATEMENT...: with `number` in it.
mechanism()
{
    unit=$1
    bad=$2
    shift 2
    printf '%s\n' "step 1 ms" "tunable number = 2 $unit" 'output angle = position of j' "$@" >"$out/sound.scene"
    { cat "$out/sound.scene"; echo "at 1 s set number = $bad $unit"; } >"$out/bad.scene"
    isoc "$out/summary" "$out/errors" "$out/sound.scene" -o "$out/sound" &&
        grep -q 'broken(memory)' "$out/sound/plant.c" &&
        ! isoc "$out/summary" "$out/errors" "$out/bad.scene" -o "$out/refused" &&
        grep -q "bad.scene:[0-9]*:[0-9]*: error: this breaks a condition of the formulas: $bad is not \(at least\|above\) 0" "$out/errors"
    result $? "refused: a change to $bad $unit in: $1"
}
joint='joint j revolute { parent ground; child b; axis z; start 10 deg }'
body="body b { mass 1 kg; com (0, -1, 0) m }; $joint"
mechanism kg 0 "body b { mass number; com (0, -1, 0) m }" "$joint"
mechanism kg -1 "body b { sphere 5 cm of number at (0, -1, 0) m }" "$joint"
mechanism m -1 "body b { box (number, 1 m, 1 m) of 2 kg }" "$joint"
mechanism 'kg*m^2' -1 "body b { mass 1 kg; inertia (number, number, number) }" "$joint"
mechanism 'N*m*s/rad' -1 'joint j revolute { parent ground; child b; axis z; damping number }' 'body b { mass 1 kg; com (0, -1, 0) m }'
mechanism 'N/m' -1 'spring s { between ground at (1, 1, 0) m and b; stiffness number; length 1 m }' "$body"
mechanism 'N*s/m' -1 'spring s { between ground at (1, 1, 0) m and b; damping number }' "$body"
mechanism m -1 'spring s { between ground at (1, 1, 0) m and b; stiffness 1 N/m; length number }' "$body"

# A condition that only a float breaks, by its rounding.
cat >"$out/rounded.scene" <<END
step 1 ms
tunable share = 0.01
$body
effect e push { j j; share share }
effect push { joint j; value share; require share * 2.9 <= 0.029; effort on j = share * (1 N*m) }
output angle = position of j
END
isoc "$out/summary" "$out/errors" "$out/rounded.scene" -o "$out/rounded" --real double &&
    ! isoc "$out/summary" "$out/errors" "$out/rounded.scene" -o "$out/rounded" --real float &&
    grep -q "rounded.scene:2:9: error: a condition on 'share' holds at the defaults, but not as a float rounds it" "$out/errors"
result $? 'refused: a condition that the rounding of a float breaks at the defaults'
finish
