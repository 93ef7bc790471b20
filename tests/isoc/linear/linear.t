#!/bin/sh
# Linear models. Those of random scenes with effects, trees and closed loops, away from rest, equal central differences
# of their plants (central.c); Bode plots of five models meet the sines that the plants answer, one of them also by
# waiting until all else has decayed (decay.c); equilibria, modes and errors in words.
. tests/host/test.sh
begin linear
one_isoc
rolled
optimised -O0

# linear NAME SCENE [OPTION...]: plant and linear model in $out/NAME, what isoc says in $out/said.
linear()
{
    linear_name=$1
    linear_scene=$2
    shift 2
    isoc "$out/summary" "$out/said" "$linear_scene" -o "$out/$linear_name" --real double &&
        build/isoc "$linear_scene" -o "$out/$linear_name" --linear "$@" >"$out/said" 2>&1
}

# object SOURCE: compiled once for all plants.
object()
{
    # shellcheck disable=SC2086
    "$CC" $FLAGS $REAL_FLAG -D_POSIX_C_SOURCE=200809L -c "$1" -o "$out/$(basename "$1" .c).o"
}

# on NAME PROGRAM OBJECT...: the program with that plant.
on()
{
    on_name=$1
    on_program=$2
    shift 2
    program "$on_name/$on_program" "$@" "$out/$on_name/plant.c"
}

seeds=$(seq 20)
# shellcheck disable=SC2086
python3 -B tests/isoc/linear/write_scene.py "$out" $seeds
object tests/isoc/linear/central.c
for seed in $seeds; do
    linear "$seed" "$out/$seed.scene" && on "$seed" central "$out/central.o" &&
        "$out/$seed/central" "$out/$seed" "$out/$seed.geometry" >"$out/found"
    result $? "seed $seed, $(cut -d ' ' -f 1 "$out/$seed.geometry"): model and differences, apart by $(cat "$out/found")"
done

# planted SEED WHAT PROGRAM: a model that the awk program changes is found.
planted()
{
    mkdir -p "$out/planted"
    cp "$out/$1/states.tsv" "$out/planted"
    awk -F '\t' -v OFS='\t' "$3" "$out/$1/matrices.tsv" >"$out/planted/matrices.tsv"
    ! cmp -s "$out/$1/matrices.tsv" "$out/planted/matrices.tsv" &&
        ! "$out/$1/central" "$out/planted" "$out/$1.geometry" >"$out/found"
    result $? "found in seed $1: $2"
}
planted 1 'a wrong sign in B' '$1 == "B" && $4 != 0 && !done { $4 = -$4; done = 1 } 1'
planted 1 'an entry of A that is off by a part of 1e-5' '$1 == "A" && $4 * $4 > 0.01 && $4 != 1 && !done { $4 *= 1.00001; done = 1 } 1'
planted 4 'in a closed loop, no rate by the position' '$1 == "A" && $2 == "j0_speed" && $3 == "j0" { $4 = 0 } 1'
planted 4 'a row that is missing' '!($1 == "D" && !left_out++)'

# Sines. A model at a point, an input and an output; what isoc says of it, and within how many per cent the plant is, as
# tools/linear/README.md has it.
for source in linear/model linear/sine linear/main table/table file/file; do
    object tools/$source.c
done
while IFS='|' read -r name conditions pair words most; do
    linear "$name" "models/$name.scene" --trim "$conditions" && grep -q "$words" "$out/said"
    result $? "$name with '$conditions': $words"
    on "$name" linear "$out/model.o" "$out/sine.o" "$out/main.o" "$out/table.o" "$out/file.o" &&
        "$out/$name/linear" bode "$out/$name/point.txt" "$pair" >"$out/$name/bode.tsv" 2>"$out/found" &&
        grep -q '^measured 5 of 5 ' "$out/found" &&
        sed 's/.* within \(.*\) % of .*/\1/' "$out/found" |
        awk -v most="$most" '$1 >= 0 && $1 <= most + 0 { good = 1 } END { exit !good }' &&
        stated tools/linear/README.md "\`$pair\` | $most % |"
    result $? "$name, $pair: $(cat "$out/found")"
done <<'END'
cart_pole|pole = 0; input force = 0|force to pole|^unstable: doubles every 0.121 s: hinge of body 'rod'|1e-5
dc_motor_bench|speed = 100 rad/s; free volts|volts to speed|^input volts 5.28 V|2e-5
four_bar|free motor; crank_angle = 90 deg|motor to rocker_angle|^equilibrium yes|1e-5
quadrotor|rest|thrust_front to place_x|^unstable: swings at 0.1268 Hz|1e-5
quarter_car|rest|road to body|^kink the rate of strut_speed|1
END

# The same plant with a model that is wrong: the measured gain stays, and the difference shows.
awk '/^B / { for (i = 3; i <= NF; i++) $i = -$i } 1' "$out/cart_pole/point.txt" >"$out/wrong.txt"
"$out/cart_pole/linear" bode "$out/wrong.txt" 'force to pole' >"$out/wrong.tsv" 2>"$out/found"
sed 's/.* within \(.*\) % of .*/\1/' "$out/found" | awk '$1 > 199 && $1 < 201 { good = 1 } END { exit !good }' &&
    grep '^plant' "$out/wrong.tsv" | cut -f 1-3 >"$out/sines" && grep '^plant' "$out/cart_pole/bode.tsv" | cut -f 1-3 | cmp - "$out/sines"
result $? "found: a wrong sign in B, $(cat "$out/found")"

on dc_motor_bench decay tests/isoc/linear/decay.c &&
    "$out/dc_motor_bench/decay" "$out/dc_motor_bench/bode.tsv" 0 2 1 <"$out/dc_motor_bench/point.txt" >"$out/found"
result $? "dc_motor_bench, driven until all else has decayed: five frequencies apart by $(tail -n 1 "$out/found")"
awk -F '\t' -v OFS='\t' '$1 == "model" { $3 *= 1.02 } 1' "$out/dc_motor_bench/bode.tsv" >"$out/wrong.tsv"
! "$out/dc_motor_bench/decay" "$out/wrong.tsv" 0 2 1 <"$out/dc_motor_bench/point.txt" >"$out/found"
result $? "found: a gain that is off by 2 %, $(tail -n 1 "$out/found")"

# A state that a run reaches, with its tunables; and the same numbers for Python and Octave.
linear drive models/cart_pole_drive.scene && on drive linear "$out/model.o" "$out/sine.o" "$out/main.o" "$out/table.o" "$out/file.o" &&
    "$out/drive/linear" reach 8100000000 >"$out/state.txt" &&
    grep -qx 'p 2 1 0' "$out/state.txt" && isoc "$out/said" '' models/cart_pole_drive.scene -o "$out/drive" --linear --state "$out/state.txt" &&
    grep -q '^point a state of the run$' "$out/said" && grep -q '^left_out disc_count' "$out/said" &&
    awk -F '\t' '$1 == "A" && $2 == "drive_current" && $3 == "rail_speed" { good = $4 == 0 } END { exit !good }' "$out/drive/matrices.tsv"
result $? "after 8.1 s the circuit of a motor is open in its linear model"
python3 -B - "$out/drive" <<'END'
import sys
folder = sys.argv[1]
there = {}
exec(open(folder + "/linear_model.py").read(), there)
octave = open(folder + "/linear_model.m").read()
for line in open(folder + "/matrices.tsv").read().splitlines()[1:]:
    matrix, row, column, value, _ = line.split("\t")
    sides = {"A": ("state", "state"), "B": ("state", "input"), "C": ("output", "state"), "D": ("output", "input")}[matrix]
    i, k = there[sides[0] + "_names"].index(row), there[sides[1] + "_names"].index(column)
    rows = octave.split("\n%s = [\n" % matrix)[1].split("\n];")[0].splitlines()
    assert float(value) == there[matrix][i][k] == float(rows[i].strip("; ").split(", ")[k])
END
result $? "Python and Octave get the numbers of the table"

# told CONDITIONS WORDS...: refused, with these words.
told()
{
    conditions=$1
    shift
    ! build/isoc models/quadrotor.scene -o "$out/none" --linear --trim "$conditions" >"$out/said" 2>&1 && [ ! -e "$out/none" ] || return 1
    for words; do
        grep -q -- "$words" "$out/said" || return 1
    done
}
told 'thrust_front = 1 N' "no equilibrium found: 'air_turn_y_speed' of body 'frame' keeps a rate of 22.* rad/s^2"
result $? 'told: what is left where there is no equilibrium, and of which body'
told 'thrust = 1 N' "no input, output or state is called 'thrust'" && told 'thrust_front = 1 m' "'thrust_front' is in N; this is in m" &&
    told 'free place_x' "only an input can be free" && told 'place_z 1 m' 'expected = and a value' &&
    told 'rest place_z = 1 m' 'expected ;'
result $? 'told: conditions that are none'
finish
