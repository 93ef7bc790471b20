#!/bin/sh
# Tunables keep the conditions of the effects and functions that use them: at their defaults and where the scene sets them isoc
# sees to it, in a run the plant.
. tests/host/test.sh
begin tunables_conditions
optimised -O1

# conditions SCENE: its program.
conditions()
{
    build/isoc "$1" -o "$out/plant" --real "$real" --method "${2-rk4}" >"$out/summary" 2>"$out/told" &&
        EXTRA="-DPLANT=\"$out/plant/plant.c\"" program run tests/tunables/conditions.c tests/host/report.c
}
for number in double float; do
    real $number
    conditions tests/tunables/conditions.scene
    joined "$number" "$out/run"
    conditions tests/tunables/conditions.scene ab4
    joined "ab4, $number" "$out/run"
done
{ sed 's/ and stiffness >= 0//' models/effects/stop.scene && sed 's/log(free)/0/' tests/tunables/conditions.scene; } >"$out/fewer.scene"
conditions "$out/fewer.scene" && ! "$out/run" >"$out/tap"
result $? 'found: an effect and a scene without these conditions'

# refused LINE TEXT [SED]: isoc refuses the scene with a line more, or changed so, and says this.
refused()
{
    { sed "${3-}" tests/tunables/conditions.scene; echo "$1"; } >"$out/bad.scene"
    ! build/isoc "$out/bad.scene" -o "$out/bad" >"$out/summary" 2>"$out/errors" && grep -q "bad.scene:[0-9]*:[0-9]*: error: .*$2" "$out/errors" &&
        [ ! -e "$out/bad" ]
    result $? "refused: ${1:-$3}"
}
refused 'at 1 s set hard = -1 N/m' '-1 is not at least 0'
refused 'at 1 s set bounce = 0' '0 is not at least 0.01'
refused 'at 1 s set free = 0' '0 is not above 0'
refused 'at 1 s set top = 0.7 m; at 2 s set bounce = 0.8' '0.7 is not at least 0.8'
refused '' "'ends' breaks what its effect requires" 's/20 kN/-20 kN/'
refused '' 'log is of a number larger than zero' 's/free = 3/free = 0/'
refused '' 'the limits are in the wrong order' 's/top = 1 m/top = 0.4 m/'
finish
