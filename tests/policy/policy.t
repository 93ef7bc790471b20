#!/bin/sh
# What a scene says about overruns, a grace, the publication and a histogram: what the loop counts under random scripts of the
# simulated port, against an account by other code; the trajectory, which is that of the ticks that were done, by the methods
# and with the effects of the rungs.
. tests/host/test.sh
begin policy
optimised -O1
real float
scripts=8 # of each policy
scene=tests/policy/pendulum.scene

program model tests/policy/model.c
result $? "the model of the account builds"

# plant NAME STATEMENTS [OPTION...]: the scene with these.
plant()
{
    plant_name=$1
    mkdir -p "$out/$plant_name"
    { cat $scene && printf '%s\n' "$2"; } >"$out/$plant_name/plant.scene"
    shift 2
    build/isoc "$out/$plant_name/plant.scene" -o "$out/$plant_name" "$@" >"$out/summary" 2>"$out/errors"
}

# What all programs share, compiled once.
for source in core/runtime/loop.c core/application/*.c core/numbers/self_check.c port/sim/*.c port/host/console.c; do
    program "$(basename "$source" .c).o" -c "$source"
done

# build NAME STATEMENTS [OPTION...]: and its program, on the simulated port.
build()
{
    plant "$@" && program "$plant_name/program" "$out/$plant_name/plant.c" "$out"/*.o
}

# run NAME [SCRIPT]: a second of it; the summary in $out/summary.
run()
{
    build/trace -o "$out/$1" -- "$out/$1/program" 1000000000 ${2+"$2"} >"$out/summary" 2>"$out/errors"
}

# family NAME STATEMENTS POLICY NUMBER GRACE: as the model says for every script.
family()
{
    family_name=$1
    shift
    build "$family_name" "$1" && run "$family_name"
    result $? "$family_name: runs"
    shift
    agreed=0
    seed=0
    while [ $seed -lt $scripts ]; do
        seed=$((seed + 1))
        "$out/model" $seed "$out/script" "$@" >"$out/expected"
        run "$family_name" "$out/script"
        # What the policies of this scene do not count is not told.
        keys="ticks late lost overruns margin grace_late grace_overruns skipped degraded"
        grep -q '^histogram$' "$out/$family_name/plant.scene" && keys="$keys histogram"
        awk -v keys="$keys" '
            { said[FILENAME, $1] = said[FILENAME, $1] $0 "\n" }
            END {
                n = split(keys, key, " ")
                for (i = 1; i <= n; i++) { wanted = wanted said[ARGV[1], key[i]]; got = got said[ARGV[2], key[i]] }
                gsub("\n", " ", got); gsub("\n", " ", wanted); print got; exit got == "" || got != wanted
            }' "$out/expected" "$out/summary" >"$out/got" && agreed=$((agreed + 1))
    done
    [ $agreed = $scripts ]
    result $? "$family_name: $agreed of seeds 1 to $scripts as the model: $(cat "$out/got")"
}

family catch_0 'overrun catch_up 0' catch_up 0 0
catch_0=$(sed -n 's/^hash //p' "$out/summary")
family catch_3 'overrun catch_up 3
grace 50 ticks
histogram' catch_up 3 50
catch_3=$(sed -n 's/^hash //p' "$out/summary")
family counted 'histogram
publish next_tick' count 0 0
[ "$catch_0" = "$catch_3" ] && [ "$catch_3" = "$(sed -n 's/^hash //p' "$out/summary")" ]
result $? "the trajectory is that of the ticks that were done, whatever was skipped: $catch_0"
grep -q '^latency 1 ticks$' "$out/summary"
result $? "the latency of the outputs is stated"
family stopped 'overrun stop
grace 20 ticks' stop 0 20
grep -q "^trace: stopped by the overrun of tick $(sed -n 's/^ticks //p' "$out/expected")$" "$out/errors"
result $? "a run that an overrun stops says so: $(cat "$out/errors")"
[ "$(wc -l <"$out/stopped/trace.csv")" = $(($(sed -n 's/^ticks //p' "$out/expected") + 2)) ]
result $? "and its table ends with that tick"

# A ladder: the account, and the trajectory, from plants of its methods.
family ladder 'overrun degrade { method heun; method euler; hold; after 20 ticks }
grace 5 ticks' degrade 20 5 "$out/rungs"
for method in rk4 heun euler; do
    build/isoc tests/policy/pendulum.scene --method $method --name by_$method -o "$out/by" >"$out/expected"
done
EXTRA="-I$out/by" program replay tests/policy/replay.c "$out"/by/*.c && [ "$("$out/replay" <"$out/rungs")" = "$(sed -n 's/^hash //p' "$out/summary")" ]
result $? "the trajectory of a ladder is that of its methods: $(sort "$out/rungs" | uniq -c | awk '{ printf "%s ticks on rung %s, ", $1, $2 }')"
[ "$(sed 's/1/2/' "$out/rungs" | "$out/replay")" != "$("$out/replay" <"$out/rungs")" ]
result $? "found: another rung"

# A ladder that drops effects: the account, the trajectory and the outputs, from plants of the scene without them.
scene=tests/policy/dropped.scene
family drops 'overrun degrade { drop hinge; drop wind; hold; after 20 ticks }
grace 5 ticks' degrade 20 5 "$out/rungs"
build/isoc $scene --name by_all -o "$out/by" >"$out/expected" &&
    build/isoc $scene --name by_less --without hinge -o "$out/by" >"$out/expected" &&
    build/isoc $scene --name by_least --without 'hinge; wind' -o "$out/by" >"$out/expected" &&
    EXTRA="-I$out/by" program drops_by_hand tests/policy/drops.c "$out"/by/by_all.c "$out"/by/by_less.c "$out"/by/by_least.c
result $? "the plants without the effects build"
[ "$("$out/drops_by_hand" "$out/rungs" "$out/drops/trace.csv")" = "$(sed -n 's/^hash //p' "$out/summary") 0" ]
result $? "a ladder that drops effects moves and shows what the scene without them does: $(sort "$out/rungs" | uniq -c | awk '{ printf "%s ticks on rung %s, ", $1, $2 }')"
for other in 's/1/2/' 's/2/1/' 's/3/2/' '40s/0/1/'; do
    sed "$other" "$out/rungs" >"$out/others"
    ! cmp -s "$out/others" "$out/rungs" && "$out/drops_by_hand" "$out/others" "$out/drops/trace.csv" | grep -qv "^$(sed -n 's/^hash //p' "$out/summary") 0\$"
    result $? "found: another rung, $other"
done
for rungs in 'drop hinge; hold; method rk4; drop wind' 'method heun; drop hinge; method rk4; drop wind'; do
    plant named "overrun degrade { $rungs; after 20 ticks }"
    EXTRA=-O0 program named/plant.o -c "$out/named/plant.c"
    result $? "each rung has a step of its own name: $(sed -n 's/^step_\([a-z0-9_]*\) .*/\1/p' "$out/summary" | tr '\n' ' ')"
done
grep -q '^step_without_hinge_wind add' "$out/summary"
result $? "isoc tells the operations of each rung"

# From a snapshot on a lower rung the board goes on with the same bits, and with fewer instructions than at the top.
plant board "overrun degrade { drop hinge; drop wind; after 1000000 ticks }"
printf 'slow 100 2ms\nslow 130 2ms\n' >"$out/script"
make -s run SCENE="$out/board/plant.scene" SCRIPT="$PWD/$out/script" SNAPSHOT=150 SECONDS=0.3 >"$out/expected" &&
    cp "$(sed -n 's/^snapshot //p' "$out/expected")" "$out/snapshot" &&
    make -s run SCENE="$out/board/plant.scene" TARGET=cortex-m4f SECONDS=0.3 >"$out/top" &&
    make -s run SCENE="$out/board/plant.scene" TARGET=cortex-m4f RESTORE="$PWD/$out/snapshot" SECONDS=0.3 >"$out/summary" &&
    [ "$(sed -n 's/^hash //p' "$out/expected")" = "$(sed -n 's/^hash //p' "$out/summary")" ] &&
    grep -q '^degraded 150 to rung 2$' "$out/summary"
result $? "on the board, from a snapshot on rung 2: the same hash"
instructions="$(sed -n 's/^instructions_per_step //p' "$out/top") $(sed -n 's/^instructions_per_step //p' "$out/summary")"
[ "${instructions% *}" -gt "${instructions#* }" ]
result $? "at the top and on rung 2 a step takes so many instructions: $instructions"

# of COLUMNS FILE: these columns of a table.
of()
{
    awk -F , -v wanted="$1" '
        NR == 1 { n = split(wanted, name, ","); for (i = 1; i <= NF; i++) at[$i] = i }
        { line = $at[name[1]]; for (i = 2; i <= n; i++) line = line "," $at[name[i]]; print line }' "$2"
}

# alike NAME EFFECT STATEMENTS: an effect that does nothing in the first tick, after which it is dropped: so the run is that of
# the scene without it.
echo slow 1 2ms >"$out/script"
alike()
{
    alike_name=$1
    alike_effect=$2
    alike_more=$3
    build "$alike_name" "overrun degrade { drop $alike_effect; after 1000000 ticks }
$alike_more" && run "$alike_name" "$out/script" && grep -q '^degraded 999 to rung 1$' "$out/summary"
    result $? "$alike_name: runs on a rung without $alike_effect"
    build alone "overrun count
$alike_more" --without "$alike_effect" && run alone && [ "$(wc -l <"$out/alone/trace.csv")" = 1002 ] &&
        columns=$(head -n 1 "$out/alone/trace.csv") && of "$columns" "$out/$alike_name/trace.csv" | cmp - "$out/alone/trace.csv" >&2
    result $? "$alike_name: moves and shows what the scene without $alike_effect does"
    run "$alike_name" && ! of "$columns" "$out/$alike_name/trace.csv" | cmp -s - "$out/alone/trace.csv"
    result $? "found: $alike_effect in $alike_name"
}

# What follows from tunables is kept for each rung, and computed anew when one changes. Smooth inputs are so on each.
scene=tests/tunables/chain.scene
alike chain motor 'at 0.3 s set length = 0.25 m'
sed 's/1 s: 0 m, 1.4 s/0.1 s: 0 m, 0.5 s/; s/1.42 s/0.52 s/' models/quarter_car.scene >"$out/smooth.scene"
scene=$out/smooth.scene
alike smooth buffers ''
grep -q 'tune_without_motor(memory->h_without_motor' "$out/chain/plant.c" &&
    grep -q 'iso_method_sample(.*equations_without_buffers' "$out/smooth/plant.c"
result $? "tunables and samples of the one and of the other stand in the memory"
scene=tests/policy/pendulum.scene

# A ladder and snapshots: the rung, and the good ticks on it, are in the record; a reset begins anew.
(echo slow 40 1500us && echo slow 50 1500us) >"$out/script"
plant restored 'overrun degrade { method heun; method euler; after 30 ticks }
publish next_tick; histogram' &&
    EXTRA="-O0 -I$out/restored" program restored/control tests/policy/restored.c "$out/restored/plant.c" core/runtime/*.c \
        tests/host/report.c port/sim/*.c port/host/console.c
result $? "a plant with a ladder builds"
joined restored "$out/restored/control" 0 "$out/script"
sed 's/head.rung = (uint16_t)ladder->rung;/head.rung = 1;/' core/runtime/snapshot.c >"$out/planted.c"
EXTRA="-O0 -I$out/restored" program restored/planted tests/policy/restored.c "$out/restored/plant.c" core/runtime/loop.c core/runtime/control.c \
    "$out/planted.c" tests/host/report.c port/sim/*.c port/host/console.c && ! "$out/restored/planted" 0 "$out/script" >"$out/found" &&
    grep -q '^not ok .* to the same hash' "$out/found"
result $? "found: a record with another rung"

# Controls.
"$out/model" 3 "$out/script" catch_up 2 0 >"$out/expected"
run catch_0 "$out/script"
[ "$(grep '^skipped' "$out/expected")" != "$(grep '^skipped' "$out/summary")" ]
result $? "found: another number of ticks that are caught up"

plant plain ''
for same in 'overrun count' 'publish at_once'; do
    plant same "$same" && cmp -s "$out/same/plant.c" "$out/plain/plant.c"
    result $? "what the loop does anyhow adds nothing to the plant: $same"
done
for other in 'overrun stop' 'grace 1 ticks' 'publish next_tick' 'histogram' 'overrun catch_up 1'; do
    plant same "$other" && ! cmp -s "$out/same/plant.c" "$out/plain/plant.c"
    result $? "found: $other"
done

# On the board: the same trajectory, and the cost is in the loop alone.
make -s run TARGET=cortex-m4f SECONDS=1 SCENE="$out/catch_3/plant.scene" >"$out/summary" &&
    [ "$(sed -n 's/^hash //p' "$out/summary")" = "$catch_3" ] && grep -q '^histogram .* instructions: 1000$' "$out/summary"
result $? "on the board: the same hash, and a histogram of instructions: $(grep '^histogram' "$out/summary")"
finish
