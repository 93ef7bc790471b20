#!/bin/sh
# The library of effects, models/effects: each against a closed form or an independent integration of its equations, in
# float and in double.
. tests/host/test.sh
begin effects_library

# derived NAME: what isoc chose in the scene compiled last, as -DWORD=VALUE for each: SLOW_LAG of slow.lag.
derived()
{
    sed -n 's/^stable \([^ ]*\) \([^ ]*\).*/\1 \2/p' "$out/$1.summary" |
        awk '{ name = toupper($1); sub(/[.]/, "_", name); printf " -D%s=%s", name, $2 }'
}

# library NAME: its scene, compiled, and its program, run.
library()
{
    build/isoc "tests/effects/$1.scene" -o "$out/$1.$real.plant" --real $real >"$out/$1.summary" &&
        EXTRA="-DPLANT=\"$out/$1.$real.plant/plant.c\"$(derived "$1")" program "$1.$real" "tests/effects/$1.c" tests/host/report.c
    joined "$1, $real" "$out/$1.$real"
}
for number in float double; do
    real $number
    library signals
done
finish
