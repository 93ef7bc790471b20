#!/bin/sh
# What a scene says about overruns, a grace, the publication and a histogram: what the loop counts under random scripts
# of the simulated port, against an account by other code; the trajectory, which is that of the ticks that were done, by
# the methods and with the effects of the rungs.
. tests/host/test.sh
begin policy
one_isoc
optimised -O1
real float
scripts=8 # of each policy

# of_scene FILE: the plants that follow are of this scene.
of_scene()
{
    scene=$1
    scene_text=$(cat "$scene")
}
of_scene tests/core/runtime/overruns/pendulum.scene

# said KEY FILE: $said is what the summary in the file says for it.
said()
{
    said=
    while read -r said_key said_rest; do
        [ "$said_key" != "$1" ] || said=$said_rest
    done <"$2"
}

program model tests/core/runtime/overruns/model.c
result $? "the model of the account builds"

# plant NAME STATEMENTS [OPTION...]: the scene with these, $out/plant.scene.
plant()
{
    plant_name=$1
    printf '%s\n' "$scene_text" "$2" >"$out/plant.scene"
    shift 2
    isoc "$out/summary" "$out/errors" "$out/plant.scene" -o "$out/$plant_name" "$@"
}

# joined_parts NAME SOURCE...: $out/NAME.o, of these sources as one file, in which names of one part may hide those of
# another.
joined_parts()
{
    joined_parts_name=$1
    shift
    printf '#include "%s"\n' "$@" >"$out/$joined_parts_name.c"
    EXTRA="${EXTRA-} -Wno-shadow" program "$joined_parts_name.o" -c "$out/$joined_parts_name.c"
}

# What all programs share, compiled once.
joined_parts loop core/runtime/loop.c core/numbers/self_check.c port/host/*.c port/unix/console.c
joined_parts application core/application/*.c

# build NAME STATEMENTS [OPTION...]: and its program, on the simulated port.
build()
{
    plant "$@" && program "$plant_name/program" "$out/$plant_name/plant.c" "$out/application.o" "$out/loop.o"
}

# run NAME [SCRIPT [SUMMARY]]: a second of it; the summary in $out/summary, or that file.
run()
{
    build/trace -o "$out/$1" -- "$out/$1/program" 1000000000 ${2+"$2"} >"${3-$out/summary}" 2>"$out/errors"
}

# family NAME STATEMENTS POLICY NUMBER GRACE: as the model says for every script. $expected, $summary and $rungs are
# then the files of the last one.
family()
{
    family_name=$1
    family_says=$2
    build "$family_name" "$2" && run "$family_name"
    result $? "$family_name: runs"
    shift 2
    "$out/model" $scripts "$out" "$@"
    seed=0
    while [ $seed -lt $scripts ]; do
        seed=$((seed + 1))
        expected=$out/$seed.expected summary=$out/$seed.summary rungs=$out/$seed.rungs
        run "$family_name" "$out/$seed.script" "$summary"
    done
    # What the policies of this scene do not count is not told.
    keys="ticks late lost overruns margin grace_late grace_overruns skipped degraded"
    case $family_says in
    *histogram*) keys="$keys histogram" ;;
    esac
    awk -v keys="$keys" -v scripts=$scripts -v out="$out" '
        { said[FILENAME, $1] = said[FILENAME, $1] $0 " " }
        END {
            n = split(keys, key, " ")
            for (seed = 1; seed <= scripts; seed++) {
                wanted = got = ""
                for (i = 1; i <= n; i++) {
                    wanted = wanted said[out "/" seed ".expected", key[i]]
                    got = got said[out "/" seed ".summary", key[i]]
                }
                agreed += got != "" && got == wanted
            }
            print agreed + 0, got
        }' "$out"/*.expected "$out"/[0-9]*.summary >"$out/got"
    read -r agreed got <"$out/got"
    [ "$agreed" = $scripts ]
    result $? "$family_name: $agreed of seeds 1 to $scripts as the model: $got"
}

# on_rungs: $ticks_on is how many ticks the last script had on each rung.
on_rungs()
{
    ticks_on=$(awk '{ ticks[$1]++ } END { for (rung = 0; rung <= 3; rung++) if (ticks[rung]) printf "%s ticks on rung %s, ", ticks[rung], rung }' "$rungs")
}

family catch_0 'overrun catch_up 0' catch_up 0 0
said hash "$summary"
catch_0=$said
family catch_3 'overrun catch_up 3
grace 50 ticks
histogram' catch_up 3 50
said hash "$summary"
catch_3=$said
# On the board: the same trajectory, and the cost is in the loop alone.
tools/isochron run "$out/plant.scene" --target cortex-m4f --seconds 1 >"$out/summary" && said hash "$out/summary" && [ "$said" = "$catch_3" ] &&
    said histogram "$out/summary"
case $said in
*' instructions: 1000') result 0 "on the board: the same hash, and a histogram of instructions: $said" ;;
*) result 1 "on the board: the same hash, and a histogram of instructions" ;;
esac
family counted 'histogram
publish next_tick' count 0 0
said hash "$summary"
[ "$catch_0" = "$catch_3" ] && [ "$catch_3" = "$said" ]
result $? "the trajectory is that of the ticks that were done, whatever was skipped: $catch_0"
said latency "$summary"
[ "$said" = '1 ticks' ]
result $? "the latency of the outputs is stated"
family stopped 'overrun stop
grace 20 ticks' stop 0 20
said ticks "$expected"
read -r error <"$out/errors"
[ "$error" = "trace: stopped by the overrun of tick $said" ]
result $? "a run that an overrun stops says so: $error"
[ "$(wc -l <"$out/stopped/trace.csv")" = $((said + 2)) ]
result $? "and its table ends with that tick"

# A ladder: the account, and the trajectory, from plants of its methods.
family ladder 'overrun degrade { method heun; method euler; hold; after 20 ticks }
grace 5 ticks' degrade 20 5
for method in rk4 heun euler; do
    isoc "$out/told" '' "$scene" --method $method --name by_$method -o "$out/by"
done
said hash "$summary"
on_rungs
EXTRA="-I$out/by" program replay tests/core/runtime/overruns/replay.c "$out"/by/*.c && [ "$("$out/replay" <"$rungs")" = "$said" ]
result $? "the trajectory of a ladder is that of its methods: $ticks_on"
[ "$(sed 's/1/2/' "$rungs" | "$out/replay")" != "$said" ]
result $? "found: another rung"

# A ladder that drops effects: the account, the trajectory and the outputs, from plants of the scene without them.
of_scene tests/core/runtime/overruns/dropped.scene
family drops 'overrun degrade { drop hinge; drop wind; hold; after 20 ticks }
grace 5 ticks' degrade 20 5
isoc "$out/told" '' "$scene" --name by_all -o "$out/by" &&
    isoc "$out/told" '' "$scene" --name by_less --without hinge -o "$out/by" &&
    isoc "$out/told" '' "$scene" --name by_least --without 'hinge; wind' -o "$out/by" &&
    EXTRA="-I$out/by" program drops_by_hand tests/core/runtime/overruns/drops.c "$out"/by/by_all.c "$out"/by/by_less.c "$out"/by/by_least.c
result $? "the plants without the effects build"
said hash "$summary"
on_rungs
[ "$("$out/drops_by_hand" "$rungs" "$out/drops/trace.csv")" = "$said 0" ]
result $? "a ladder that drops effects moves and shows what the scene without them does: $ticks_on"
for other in 's/1/2/' 's/2/1/' 's/3/2/' '40s/0/1/'; do
    sed "$other" "$rungs" >"$out/others"
    ! cmp -s "$out/others" "$rungs" && shown=$("$out/drops_by_hand" "$out/others" "$out/drops/trace.csv") && [ -n "$shown" ] && [ "$shown" != "$said 0" ]
    result $? "found: another rung, $other"
done
for rungs in 'drop hinge; hold; method rk4; drop wind' 'method heun; drop hinge; method rk4; drop wind'; do
    plant named "overrun degrade { $rungs; after 20 ticks }"
    EXTRA=-O0 program named/plant.o -c "$out/named/plant.c"
    result $? "each rung has a step of its own name: $(awk '/^step_/ { printf "%s ", substr($1, 6) }' "$out/summary")"
done
said step_without_hinge_wind "$out/summary"
[ "${said%% *}" = add ]
result $? "isoc tells the operations of each rung"

# From a snapshot on a lower rung the board goes on with the same bits, and with fewer instructions than at the top.
plant board "overrun degrade { drop hinge; drop wind; after 1000000 ticks }"
printf 'slow 100 2ms\nslow 130 2ms\n' >"$out/script"
tools/isochron run "$out/plant.scene" --script "$PWD/$out/script" --snapshot 150 --seconds 0.3 >"$out/expected" &&
    said snapshot "$out/expected" && cp "$said" "$out/snapshot" && said hash "$out/expected" && hash=$said &&
    tools/isochron run "$out/plant.scene" --target cortex-m4f --seconds 0.3 >"$out/top" &&
    tools/isochron run "$out/plant.scene" --target cortex-m4f --restore "$PWD/$out/snapshot" --seconds 0.3 >"$out/summary" &&
    said hash "$out/summary" && [ "$hash" = "$said" ] && said degraded "$out/summary" && [ "$said" = '150 to rung 2' ]
result $? "on the board, from a snapshot on rung 2: the same hash"
said instructions_per_step "$out/top"
top=$said
said instructions_per_step "$out/summary"
[ "$top" -gt "$said" ]
result $? "at the top and on rung 2 a step takes so many instructions: $top $said"

# of COLUMNS FILE: these columns of a table.
of()
{
    awk -F , -v wanted="$1" '
        NR == 1 { n = split(wanted, name, ","); for (i = 1; i <= NF; i++) at[$i] = i }
        { line = $at[name[1]]; for (i = 2; i <= n; i++) line = line "," $at[name[i]]; print line }' "$2"
}

# alike NAME EFFECT STATEMENTS: an effect that does nothing in the first tick, after which it is dropped: so the run is
# that of the scene without it.
echo slow 1 2ms >"$out/script"
alike()
{
    alike_name=$1
    alike_effect=$2
    alike_more=$3
    build "$alike_name" "overrun degrade { drop $alike_effect; after 1000000 ticks }
$alike_more" && run "$alike_name" "$out/script" && said degraded "$out/summary" && [ "$said" = '999 to rung 1' ]
    result $? "$alike_name: runs on a rung without $alike_effect"
    build alone "overrun count
$alike_more" --without "$alike_effect" && run alone && [ "$(wc -l <"$out/alone/trace.csv")" = 1002 ] &&
        read -r columns <"$out/alone/trace.csv" && of "$columns" "$out/$alike_name/trace.csv" | cmp - "$out/alone/trace.csv" >&2
    result $? "$alike_name: moves and shows what the scene without $alike_effect does"
    run "$alike_name" && ! of "$columns" "$out/$alike_name/trace.csv" | cmp -s - "$out/alone/trace.csv"
    result $? "found: $alike_effect in $alike_name"
}

# What follows from tunables is kept for each rung, and computed anew when one changes. Smooth inputs are so on each.
of_scene tests/isoc/plant/tunables/chain.scene
alike chain motor 'at 0.3 s set length = 0.25 m'
sed 's/1 s: 0 m, 1.4 s/0.1 s: 0 m, 0.5 s/; s/1.42 s/0.52 s/' models/quarter_car.scene >"$out/smooth.scene"
of_scene "$out/smooth.scene"
alike smooth buffers ''
grep -q 'tune_without_motor(memory->h_without_motor' "$out/chain/plant.c" &&
    grep -q 'iso_method_sample(.*equations_without_buffers' "$out/smooth/plant.c"
result $? "tunables and samples of the one and of the other stand in the memory"
of_scene tests/core/runtime/overruns/pendulum.scene

# A ladder and snapshots: the rung, and the good ticks on it, are in the record; a reset begins anew.
printf 'slow 40 1500us\nslow 50 1500us\n' >"$out/script"
plant restored 'overrun degrade { method heun; method euler; after 30 ticks }
publish next_tick; histogram' &&
    EXTRA="-O0 -I$out/restored" joined_parts rest tests/core/runtime/overruns/restored.c "$out/restored/plant.c" core/runtime/control.c &&
    EXTRA=-O0 program restored/control "$out/rest.o" "$out/loop.o" core/runtime/snapshot.c tests/host/report.c
result $? "a plant with a ladder builds"
joined restored "$out/restored/control" 0 "$out/script"
sed 's/head.rung = (uint16_t)ladder->rung;/head.rung = 1;/' core/runtime/snapshot.c >"$out/planted.c"
EXTRA=-O0 program restored/planted "$out/rest.o" "$out/loop.o" "$out/planted.c" tests/host/report.c && ! "$out/restored/planted" 0 "$out/script" >"$out/found" &&
    grep -q '^not ok .* to the same hash' "$out/found"
result $? "found: a record with another rung"

# Controls.
"$out/model" 3 "$out" catch_up 2 0
run catch_0 "$out/3.script"
said skipped "$out/3.expected"
skipped=$said
said skipped "$out/summary"
[ "$skipped" != "$said" ]
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
finish
