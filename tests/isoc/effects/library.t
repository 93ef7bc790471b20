#!/bin/sh
# The library of effects, models/effects: each against a closed form or an independent integration of its equations, in
# float and in double. And under memcheck, which takes long: one of the ten programs in a turn, or with the argument
# `all` all.
. tests/host/test.sh
begin effects_library
one_isoc
optimised -O1
turn=$(turn_of 10 "${1-}" core models/effects tests/isoc/effects)
echo "# memcheck: turn $turn of 10"

# derived NAME: what isoc chose in the scene compiled last, as -DWORD=VALUE for each: SLOW_LAG of slow.lag.
derived()
{
    sed -n 's/^stable \([^ ]*\) \([^ ]*\).*/\1 \2/p' "$out/$1.summary" |
        awk '{ name = toupper($1); sub(/[.]/, "_", name); printf " -D%s=%s", name, $2 }'
}

# watched PROGRAM: memcheck finds nothing in it.
watched()
{
    valgrind --quiet --error-exitcode=99 "$out/$1" >"$out/tap" 2>&1
}

# library NAME: its scene, compiled, and its program, run.
programs=0
library()
{
    isoc "$out/$1.summary" '' "tests/isoc/effects/$1.scene" -o "$out/$1.$real.plant" --real "$real" &&
        EXTRA="-DPLANT=\"$out/$1.$real.plant/plant.c\"$(derived "$1")" program "$1.$real" "tests/isoc/effects/$1.c" tests/host/report.c
    joined "$1, $real" "$out/$1.$real"
    if [ "$turn" = all ] || [ "$turn" -eq "$programs" ]; then
        watched "$1.$real"
        result $? "$1, $real: memcheck finds nothing"
    fi
    programs=$((programs + 1))
}
for number in float double; do
    real $number
    library signals
    library machines
    library bushing
    library ground
    library drives
done

sed '0,/const real t1 = /s//real none[1]; const real *volatile where = none; const real t1 = R(0.0) * where[0] + /' \
    "$out/ground.float.plant/plant.c" >"$out/ground.float.plant/unset.c"
real float
EXTRA="-DPLANT=\"$out/ground.float.plant/unset.c\"" program unset tests/isoc/effects/ground.c tests/host/report.c && ! watched unset &&
    grep -q 'uninitialised' "$out/tap"
result $? 'found by memcheck: a number that nothing has set'
real double

# planted NAME KIND SED: the program of a scene finds its effect of that kind so changed.
planted()
{
    { sed "$3" "models/effects/$2.scene" && cat "tests/isoc/effects/$1.scene"; } >"$out/planted.scene"
    isoc "$out/planted.summary" '' "$out/planted.scene" -o "$out/planted.plant" --real "$real" &&
        ! sed "$3" "models/effects/$2.scene" | cmp -s - "models/effects/$2.scene" &&
        EXTRA="-DPLANT=\"$out/planted.plant/plant.c\"$(derived planted)" program planted "tests/isoc/effects/$1.c" \
            tests/host/report.c && ! "$out/planted" >"$out/tap" && [ "$(grep -c '^not ok' "$out/tap")" -le 3 ]
    result $? "found in $2: $3"
}
planted signals lag 's/rate y = (input/rate y = (0.999 * input/'
planted signals gust 's/sqrt(1 - left^2)/(1 - left)/'
planted machines cable 's/1 + slow/1 + 1.1 * slow/'
planted machines backlash 's/ratio \* effort/effort/'
planted bushing bushing 's/of other - cross(spin/of other + cross(spin/'
planted ground contact 's/impact_damping(rest)/2 * impact_damping(rest)/'
planted drives cogging 's/sin(angle)$/sin(1.001 * angle)/'
planted drives chopper 's|(supply + drop) \* edge|supply * edge|'
planted drives gusts 's/0.5 - left^2/0.51 - left^2/'
planted machines encoder 's/(way < -turn/(way < -2 * turn/'
finish
