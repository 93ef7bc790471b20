#!/bin/sh
# The loop's statistics tell how far a run was off its closures, and how many ticks were farther off than the scene's
# limit; without a limit nothing of it is there. A four-bar linkage whose constraints drift, since nothing holds them.
. tests/host/test.sh
. tests/host/project.sh
begin check/violation
one_isoc
project
unoptimised

# linkage NAME STABILISATION: the scene, whose output `off` is the violation.
linkage()
{
    mkdir -p "$out/$1"
    {
        sed '/^stabilisation/d; s/^method.*/method rk4/; s/start 90 deg/&; speed 20 rad\/s/' tests/core/methods/order/four_bar.scene
        echo "output off = violation"
        echo "stabilisation $2"
    } >"$out/$1/linkage.scene"
}

# runs NAME [OPTION...]: the run's table is $csv.
runs()
{
    run_name=$1
    shift
    isochron run "$(pwd)/$out/$run_name/linkage.scene" --seconds 5 "$@"
    status=$?
    read_value trace && csv=$out/project/$value
    read_value hash && hash=$value
    read_value instructions_per_step && cost=$value
    return $status
}

# seen LIMIT: the largest violation of the table, and the ticks above the limit.
seen()
{
    awk -F , -v limit="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "off") at = i; next }
        $at > most { most = $at; text = $at }
        { above += $at > limit }
        END { print text, above + 0 }' "$csv"
}

linkage free none
linkage limited 'none { limit 20 um }'
linkage never 'none { limit 1 m }'

runs limited
expect $? "a run with a limit"
known=$hash
[ "$(value violation) $(value violated)" = "$(seen 2e-5)" ]
expect $? "the largest violation is that of the table, $(value violation) m, and so are the $(value violated) ticks above 20 um"
[ "$(value violated)" -gt 0 ] && [ "$(value violated)" -lt "$(value ticks)" ]
expect $? "some ticks are above the limit and some are not"
runs never && [ "$(value violation) $(value violated)" = "$(seen 1)" ] && printed violated 0
expect $? "no tick is above 1 m"
runs free && [ "$hash" = "$known" ] && [ -z "$(value violation)$(value violated)" ]
expect $? "without a limit: the same motion, and nothing is told"

runs free --target cortex-m4f
expect $? "a run on the board"
cheap=$cost
runs limited --target cortex-m4f && [ "$cost" = "$cheap" ] && [ "$hash" = "$known" ] &&
    [ "$(value violation) $(value violated)" = "$(seen 2e-5)" ]
expect $? "on the board a limit costs the step nothing, and the statistics are the same"

m4f="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16"
for name in free limited; do
    # shellcheck disable=SC2086
    isoc "$out/$name/summary" '' "$out/$name/linkage.scene" -o "$out/$name" &&
        arm-none-eabi-gcc $FLAGS $m4f -c "$out/$name/plant.c" -o "$out/$name/plant.o" &&
        arm-none-eabi-nm "$out/$name/plant.o" | awk '{ sub(/[.].*/, "", $NF); print $NF }' | sort -u >"$out/$name/symbols"
done
[ "$(comm -13 "$out/free/symbols" "$out/limited/symbols" | tr '\n' ' ')" = 'iso_plant_tell violation ' ] &&
    [ -z "$(comm -23 "$out/free/symbols" "$out/limited/symbols")" ]
expect $? "a limit adds to the plant what computes it and what tells of it, and nothing else"
finish
