#!/bin/sh
# `compensated yes` in closed loops with the projection, in float: what the projection moves is added with the
# compensation too, so that the runs come nearer to that in double as those of trees do. Loops of five kinds of closures
# and methods of each kind, from 16 starts each, since one run alone may be near by chance; over all of them ten times
# nearer. Control: where the projection adds without it, at most a third is gained. By itself one method for each loop,
# by turns; with an argument all of them.
. tests/host/test.sh
begin compensated
one_isoc
seconds=2
methods='heun rk4 ab4 rosenbrock'
turn=$(turn_of 4 "${1-}")
echo "# turn $turn of 4"
optimised -O1

# The step as a float has it, which the run in double takes too: else its time would be another one.
float_step='R(9.9999997473787516e-05)'

# built NAME SCENE METHOD REAL yes|no [EDIT]: the program $out/NAME, of a plant that EDIT has changed, a script of sed.
built()
{
    { cat "tests/core/methods/compensated/$2.scene" && echo "compensated $5"; } >"$out/$2.scene" && real "$4" &&
        isoc "$out/$1.summary" '' "$out/$2.scene" -o "$out/$1.plant" --method "$3" --real "$4" &&
        sed -i "s/R(0\.0001)/$float_step/; ${6-}" "$out/$1.plant/plant.c" &&
        program "$1" tests/core/methods/compensated/run.c "$out/$1.plant/plant.c"
}

# ran NAME SCENE METHOD REAL yes|no [EDIT]: what it prints is $out/NAME.rows.
ran()
{
    built "$@" && "$out/$1" $seconds >"$out/$1.rows"
}

# nearer NAME: how many times nearer to the run in double than the plain one; the root of the mean squares.
nearer()
{
    paste -d ' ' "$out/truth.rows" "$out/plain.rows" "$out/$1.rows" | awk '
        { n = NF / 3; for (i = 1; i <= n; i++) { plain += ($(n + i) - $i) ^ 2; other += ($(2 * n + i) - $i) ^ 2 } }
        END { printf "%.2f %.1e %.1e\n", sqrt(plain / other), sqrt(plain / NR / n), sqrt(other / NR / n) }'
}

# at_least NUMBER BOUND
at_least()
{
    awk -v number="$1" -v bound="$2" 'BEGIN { exit !(number >= bound) }'
}

without='s/iso_method_move(.*/for (int i = 0; i < (int)(sizeof moved \/ sizeof *moved); i++) x[settled_states[i]] += moved[i];/'
at=0
for scene in four_bar slider_crank driven ball geared; do
    for method in $([ "$turn" = all ] && echo "$methods" || echo "$methods" | cut -d ' ' -f $(((at + turn) % 4 + 1))); do
        ran truth $scene "$method" double yes && ran plain $scene "$method" float no && ran summed $scene "$method" float yes
        built=$?
        gain=$(nearer summed)
        echo "${gain%% *}" >>"$out/gains"
        [ $built -eq 0 ] && at_least "${gain%% *}" 3
        result $? "$scene, $method: $(echo "$gain" | awk '{ print $1 " times nearer: off by " $3 ", plain by " $2 }')"
    done
    # What the projection of a gear moves is nearly nothing, and of quaternions the length, which their turns do not
    # feel.
    case $scene in
    ball | geared) ;;
    *)
        ran control $scene "$method" float yes "$without" && lesser=$(nearer control) &&
            at_least "${gain%% *}" "$(awk -v times="${lesser%% *}" 'BEGIN { print 3 * times }')"
        result $? "control: $scene, $method, the projection adds without compensation: ${lesser%% *} times"
        ;;
    esac
    at=$((at + 1))
done
mean=$(awk '{ sum += log($1) } END { print exp(sum / NR) }' "$out/gains")
at_least "$mean" 10
result $? "over all of them $mean times, the geometric mean"
[ "$turn" != all ] || {
    stated core/README.md "five loops in float come $(printf %.0f "$mean") times nearer to their runs in double"
    result $? "as core/README.md says"
}
finish
