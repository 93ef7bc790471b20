#!/bin/sh
# isochron sweep: each row is the run that its values make alone; the values are those of README.md, by an interpreter;
# what is built into a plant; a sweep that was ended goes on to the same bytes, here and by GNU parallel; runs that
# fail, and what is asked for wrongly.
#
# usage: sweep.t [all]. A sweep of 10,000 runs that is killed twice, here or by GNU parallel, by turns.
. tests/host/test.sh
. tests/host/project.sh
. tests/host/picture.sh
begin sweep

# GNU parallel searches at its first call how long a command may be, with a hundred processes, and keeps the answer for
# a user: here that of this test alone, so that it starts as many each time.
PARALLEL_HOME=$PWD/$out/parallel
export PARALLEL_HOME

turn=$(turn_of 4 "${1-}")
echo "# sweep: turn $turn of 4"
tab=$(printf '\t')

# sweep ARGUMENT...: isochron sweep; its output is in $out/output, its messages in $out/errors, the table then $table.
sweep()
{
    tools/isochron sweep "$@" >"$out/output" 2>"$out/errors" </dev/null
    sweep_status=$?
    read_value table
    table=$value
    return $sweep_status
}

# counted RUNS PLANTS FAILED: whether the last sweep had so many runs, plants, and runs that failed.
counted()
{
    printed runs "$1" && printed plants "$2" && printed failed "$3"
}

# values SET RUNS SEED: whether the table has the values that the interpreter computes.
values()
{
    python3 -B tests/tools/sweep/interpret.py "$1" "$2" "$3" "$table" >"$out/said" 2>&1
    values_status=$?
    while IFS= read -r said; do
        echo "# $said"
    done <"$out/said"
    return $values_status
}

# cell ROW COLUMN: of the table, by the name of the column.
cell()
{
    awk -F '\t' -v row="$1" -v column="$2" '
        NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
        NR > 1 && $1 == row { print $at[column] }' "$table"
}

# alone NAME SCENE REAL MILLISECONDS [OPTION...]: $alone is the hash of a run by the program of every run.
alone()
{
    alone_dir=$out/alone_$1
    alone_scene=$2
    alone_time=$4
    alone_flags=$FLAGS
    alone_objects=build/obj/host/$3
    [ "$3" = float ] || alone_flags="$FLAGS -DISO_REAL_DOUBLE"
    shift 4
    build/isoc "$alone_scene" -o "$alone_dir" "$@" >"$out/said" 2>&1 || return 1
    # shellcheck disable=SC2086
    clang $alone_flags -O0 "$alone_dir/plant.c" core/application/*.c "$alone_objects"/core/numbers/*.o "$alone_objects/core/runtime/loop.o" \
        "$alone_objects"/port/*/*.o -o "$alone_dir/program" &&
        build/trace -o "$alone_dir" -- "$alone_dir/program" "${alone_time}000000" >"$out/output" && read_value hash && alone=$value
}

# same ROW NAME SCENE REAL MILLISECONDS OPTION...: whether the row of the table has the hash of that run.
same()
{
    same_row=$1
    shift
    alone "$@" && [ -n "$alone" ] && [ "$(cell "$same_row" hash)" = "$alone" ]
}

# --- grids, random values, faults, methods and steps; each as it is alone ---

sed 's|^tunable rail_damping = .*|& in 0 N*s/m to 0.2 N*s/m|' models/cart_pole.scene >"$out/cart.scene"
set='rod_mass = 100 .. 300 g by 21; rail_damping = 0, 0.1 N*s/m'
sweep "$out/cart.scene" --seconds 0.2 --set "$set" --of 'max pole; final energy; hash' &&
    counted 42 1 0 && values "$set" 1 1
expect $? "a grid of 42 runs of one plant, with the values of the interpreter"
read -r columns <"$table" && [ "$columns" = "run${tab}rod_mass${tab}rail_damping${tab}max_pole${tab}final_energy${tab}hash${tab}status" ]
expect $? "its columns"
same 3 cart "$out/cart.scene" float 200 --set "rod_mass = $(cell 3 rod_mass) kg; rail_damping = 0.1 N*s/m"
expect $? "a row has the hash of the run alone"
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR > 1 && (NR == 2 || $at["pole"] > most) { most = $at["pole"] }
    END { print most, $at["energy"] }' "$out/alone_cart/trace.csv" >"$out/seen" && read -r seen <"$out/seen"
[ "$(cell 3 max_pole) $(cell 3 final_energy)" = "$seen" ]
expect $? "and what its trace shows: the largest angle, the last energy"
[ "$(cut -f 6 "$table" | sort -u | wc -l)" -eq 43 ]
expect $? "all runs are different"
reads_picture
awk -F '\t' 'NR > 1 { for (i = 4; i <= 5; i++)
    printf "%s|rod_mass, kg\trail_damping %s\t%s\t%s\n", (i == 4 ? "max_pole, rad" : "final_energy, J"), $3, $2, $i }' "$table" >"$out/points"
shows "${table%.tsv}.svg" "$out/points" all
result $? "its picture has a panel for each result, with all points of the table"
sed '1s/[0-9.]*$/0/' "$out/points" >"$out/others"
! shows "${table%.tsv}.svg" "$out/others" all >"$out/said"
result $? "found: a point that the table has not"

# drawn KIND X Y COLUMN RESULT...: whether the picture is that of the table; and not of one that is other in COLUMN.
drawn()
{
    drawn_kind=$1 drawn_x=$2 drawn_y=$3 drawn_column=$4
    shift 4
    awk -F '\t' -v OFS='\t' -v i="$drawn_column" '$NF == "ok" { $i *= 1.02 } 1' "$table" >"$out/others"
    python3 -B tests/tools/sweep/picture.py "$drawn_kind" "${table%.tsv}.svg" "$table" "$drawn_x" "$drawn_y" "$@" 2>"$out/errors" &&
        ! python3 -B tests/tools/sweep/picture.py "$drawn_kind" "${table%.tsv}.svg" "$out/others" "$drawn_x" "$drawn_y" "$@" 2>"$out/said" && grep -q . "$out/said"
}

set='drive.open = 0, 1; method = rk4, heun; step = 100, 50 us'
sweep models/dc_motor_bench.scene --real double --seconds 0.15 --set "$set" --of 'rms current; hash; ticks' &&
    counted 8 4 0 && values "$set" 1 1
expect $? "faults, methods and steps: 8 runs of 4 plants, in double"
same 7 motor models/dc_motor_bench.scene double 150 --real double --method heun --step '50 us' --set 'drive.open = 1' &&
    [ "$(cell 7 ticks)" = 3000 ]
expect $? "a row with a fault has the hash of the run alone"
[ "$(cell 7 rms_current)" = 0 ] && [ "$(cell 3 rms_current)" != 0 ]
expect $? "no current flows where the circuit is open"

case $turn in
1 | 3 | all)
    set='rod_mass = 100 .. 300 g by 6; rail_damping = 0 .. 0.1 N*s/m by 5'
    sweep "$out/cart.scene" --seconds 0.2 --set "$set" --of 'max pole; final energy' && cp -p "${table%.tsv}.svg" "$out/map.svg" &&
        drawn map rod_mass rail_damping 5 max_pole final_energy
    expect $? "a map has the colours of all runs; found: runs that are another"
    sweep "$out/cart.scene" --seconds 0.2 --set "$set" --of 'max pole; final energy' && [ ! "$out/map.svg" -nt "${table%.tsv}.svg" ] &&
        [ ! "$out/map.svg" -ot "${table%.tsv}.svg" ]
    expect $? "the same sweep again draws no picture again"
    # Starts: one plant is compiled for all.
    sed 's/^    start 90 deg/    start tilt/; 1i constant tilt = 90 deg' models/double_pendulum.scene >"$out/tilted.scene"
    sweep "$out/tilted.scene" --seconds 0.1 --set 'tilt = 10, 50 deg; method = rk4, heun' --of 'hash; max elbow_angle' && printed plants 4 &&
        [ "$(ls "${table%/*}"/*/plant_*.c | wc -l)" -eq 2 ]
    expect $? "of four plants, two that differ in the start alone have the code of the others"
    same 2 tilted "$out/tilted.scene" float 100 --method rk4 --set 'tilt = 50 deg' && same 1 tilted "$out/tilted.scene" float 100 --method heun --set 'tilt = 10 deg'
    expect $? "a row with a start of its own has the hash of the run alone"
    ;;
esac

cat >"$out/rail.scene" <<'END'
step 1 ms
tunable heavy = 1 kg
tunable drag = 0.5 N*s/m
body block { mass heavy }
joint rail prismatic { parent ground; child block; axis x; speed 1 m/s; damping drag }
effect rub friction { along rail; sliding 1 N; static 1.5 N }
effect slow lag { drag drag }
effect lag { value drag N*s/m; state level N*s/m = 2 * drag; rate level = -level / 1 s; output level }
output speed = speed of rail
output level = slow.level
END
set='heavy = 1, 2 kg; drag = 0.5, 0.6 N*s/m'
sweep "$out/rail.scene" --method euler --seconds 0.1 --set "$set" && printed runs 4 && printed plants 2 && values "$set" 1 1
expect $? "a mass from which a friction has its creep is built in; a damping from which a state starts is not"
same 3 rail "$out/rail.scene" float 100 --method euler --set 'heavy = 2 kg; drag = 0.6 N*s/m'
expect $? "a row of it has the hash of the run alone"

case $turn in
1 | 3 | all)
    mkdir -p "$out/models"
    for name in four_bar squeezer; do
        sed 's|^constant \([a-z_]* = [0-9.]* *[a-z*/^0-9]*\)$|tunable \1|' models/$name.scene >"$out/models/$name.scene"
    done
    # shellcheck disable=SC2046
    python3 -B tests/tools/sweep/built_in.py build/isoc "$out/models" "$out"/models/*.scene $(grep -lr --include='*.scene' '^tunable' models tests | sort) >"$out/said" &&
        read -r free built idle <"$out/said" && [ "$free" -ge 30 ] && [ "$built" -ge 4 ] && [ "$idle" -le 4 ]
    result $? "of the scenes with tunables, what is free changes no plant: free, built in, in vain: $free $built $idle"
    ;;
esac

# --- ended, and gone on ---

set='rod_mass = normal(0.2, 0.01) kg; half_length = uniform(200, 300) mm; rail_damping = 0, 0.1, 0.3 N*s/m'
sweep "$out/cart.scene" --seconds 0.05 --set "$set" --runs 8 --seed 42 --of 'peak pole_speed; mean energy; hash' --lanes 1 &&
    counted 24 1 8 && values "$set" 8 42
expect $? "random values: those of the interpreter; and 8 of 24 runs that fail"
drawn bars - - 6 peak_pole_speed mean_energy
expect $? "the histograms have the runs of the table; found: runs that are others"
cp "$table" "$out/whole.tsv"
read_value failures
cp "$value" "$out/failures.txt"
set -- "${table%/*}"/*/parts
parts=$1

# partly: some parts are gone, a file is left of one that was ended, and a mark is in one that is there.
partly()
{
    for part in 0 3 7 8 9 23; do
        set -- "$@" "$parts/$part.tsv"
    done
    rm -f "$table" "$@"
    : >"$parts/9.tsv.other.1"
    touch -d '2001-01-01' "$parts/11.tsv"
}
for engine in local parallel; do
    partly
    sweep "$out/cart.scene" --seconds 0.05 --set "$set" --runs 8 --seed 42 --of 'peak pole_speed; mean energy; hash' --lanes 1 --engine $engine &&
        cmp -s "$table" "$out/whole.tsv" && [ -n "$(find "$parts/11.tsv" ! -newermt 2002-01-01)" ] && [ ! -e "$parts/9.tsv.other.1" ]
    expect $? "with some parts of before, $engine: the same table, and these parts stay"
done
sweep "$out/cart.scene" --seconds 0.05 --set "$set" --runs 8 --seed 43 --of 'peak pole_speed; mean energy; hash' && ! cmp -s "$table" "$out/whole.tsv" &&
    values "$set" 8 43 && [ ! -d "$parts" ]
expect $? "another seed: other values, and no part of before"

# What was said of the runs that failed.
[ "$(grep -c '^run' "$out/failures.txt")" -eq 8 ] && grep -q '^run 16: refused: a value is beyond its limits' "$out/failures.txt" &&
    command=$(sed -n '2s/^ *isochron run //p' "$out/failures.txt") && ! eval "tools/isochron run $command" >"$out/output" 2>"$out/errors" &&
    grep -q "the default of 'rail_damping' is not within its limits" "$out/errors"
expect $? "a failure is listed with the command that makes it alone, which fails too"

# guard SCENE: a spring that pulls the wrong way, where its stiffness is below zero; and a plant that isoc refuses.
cat >"$out/guard.scene" <<'END'
step 1 ms
constant heavy = 1 kg
tunable pull = 1 N/m
input kick N = 1 N
effect held { joint on; value k N/m; effort on on = -k * position of on * 1000 }
body block { mass heavy }
joint rail prismatic { parent ground; child block; axis x; start 1 m; drive kick }
effect by held { on rail; k pull }
output place = position of rail
END
sweep "$out/guard.scene" --seconds 10 --set 'heavy = 0, 1 kg; pull = 1, -1 N/m' --of 'hash; ticks; max place'
printed failed 3 && cell 0 status | grep -q 'refused: .*error: ' && [ -z "$(cell 0 max_place)" ] && [ "$(cell 2 status)" = ok ] &&
    cell 3 status | grep -q '^guard: rail.* at tick [0-9]* is not finite' && [ "$(cell 3 ticks)" -gt 100 ]
expect $? "a plant that isoc refuses, and one that the guard stops, are failures of their runs"

# --- asked for wrongly ---

# refused SET OF MESSAGE [OPTION...]
refused()
{
    refused_set=$1
    refused_of=$2
    refused_text=$3
    shift 3
    ! build/isoc models/cart_pole.scene -o "$out/refused" --sweep "$refused_set" --of "$refused_of" "$@" 2>"$out/errors" >&2 &&
        says "$refused_text" && [ ! -e "$out/refused/plan" ]
    refused_status=$?
    [ $refused_status -eq 0 ] || sed 's/^/# /' "$out/errors"
    result $refused_status "refused: $refused_text"
}
m='rod_mass = 1, 2 kg'
refused 'rod_mas = 1 kg' hash "--set:1:1: error: no constant, tunable or fault is called 'rod_mas' (did you mean 'rod_mass'?)"
refused 'rod_mass = 1 m' hash "--set:1:12: error: 'rod_mass' is in kg; this is in m"
refused 'rod_mass = 1, 2' hash "'rod_mass' is in kg; this has no unit"
refused 'rod_mass = 0.1 .. 0.3 kg' hash 'expected by and the number of values'
refused 'rod_mass = 0.1 .. 0.3 kg by 1' hash 'expected the number of values, from 2 to 1000000'
refused 'rod_mass = 0.1 .. 0.3 kg by 2 m' hash 'expected , and a further value, or ; and what varies besides'
refused "$m; rod_mass = 1 kg" hash "--set:1:21: error: 'rod_mass' stands twice"
refused "$m; half_length = rod_mass * 1 m/kg" hash "'rod_mass' is varied too"
refused 'method = rk5' hash "expected a method (did you mean 'rk4'?)"
refused 'rod_mass = uniform(2, 1) kg' hash "the limits of 'rod_mass' are not in their order" --runs 2
refused 'rod_mass = normal(2, -1) kg' hash "the standard deviation of 'rod_mass' is below zero" --runs 2
refused 'rod_mass = normal(2, 1) kg' hash 'the set has random values: --runs says how many'
refused "$m" hash '--runs has no effect: nothing in the set is random' --runs 3
refused 'rod_mass = normal(2, 1) kg' hash '--runs 0 is no number of runs' --runs 0
refused 'rod_mass = 1 .. 2 kg by 1001; half_length = 1 .. 2 m by 1000' hash 'a sweep has at most 1000000 runs'
refused '' hash '--set is what varies'
refused "$m" '' '--of is what the table shows'
refused "$m" 'max pol' "--of:1:5: error: no output is called 'pol' (did you mean 'pole'?)"
refused "$m" 'maxi pole' "--of:1:1: error: 'maxi' is not known (did you mean 'max'?)"
refused "$m" 'max' "expected an output behind 'max'"
refused "$m" 'hash; hash' '--of:1:7: error: the table has hash already'

sweep "$out/guard.scene" --seconds 10 --set 'pull = 1 m' --of hash
[ "$sweep_status" -ne 0 ] && grep -q "^--set:1:8: error: 'pull' is in N/m; this is in m" "$out/errors" && [ -f "build/sweep/$(echo "$out/guard" | tr / +)/sweep.tsv" ]
expect $? "what is wrong ends with status 1, and leaves the table of before"

# --- 10,000 runs, killed twice ---

# killed ENGINE PARTS: begins the sweep, one by one, which takes longer, and kills all of it when so many of its parts
# are there; whether it was not done by then.
killed()
{
    rm -f "$table"
    killed_parts=$(python3 -B tests/tools/sweep/kill.py "${table%/*}" "$2" tools/isochron sweep "$out/cart.scene" --seconds 1 \
        --set "$set" --runs 10000 --of "$of" --lanes 1 --engine "$1") && [ "$killed_parts" -lt 256 ] && [ ! -e "$table" ]
    killed_status=$?
    echo "# killed with $killed_parts of 256 parts"
    return $killed_status
}

# many ENGINE: killed twice; then it goes on to the table of the sweep that nothing ended.
many()
{
    set='rod_mass = normal(0.2, 0.01) kg; half_length = uniform(200, 300) mm'
    of='max pole; mean energy; hash'
    [ -f "$out/many.tsv" ] || { sweep "$out/cart.scene" --seconds 1 --set "$set" --runs 10000 --of "$of" && cp "$table" "$out/many.tsv"; }
    expect $? "10,000 runs"
    values "$set" 10000 1
    result $? "they have the values of the interpreter"
    rm -rf "${table%/*}"
    killed "$1" 20 && killed "$1" 100
    expect $? "killed twice, $1"
    sweep "$out/cart.scene" --seconds 1 --set "$set" --runs 10000 --of "$of" --lanes 1 --engine "$1" && cmp -s "$table" "$out/many.tsv"
    expect $? "it went on to the same bytes, $1"
}
case $turn in
0) many local ;;
2) many parallel ;;
all) many local && many parallel ;;
esac
rm -rf build/sweep/+build+tests+sweep+*
finish
