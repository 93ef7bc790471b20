#!/bin/sh
# Random scenes (write_scene.py), by gcc and by clang: no branch and no address of a step, of memories and of outputs
# depends on data, and a run has the same bits by both compilers, with and without optimisation, and on the Cortex-M4F,
# where each step takes one number of instructions. One seed by turns; with `all` 60; with a number that seed alone:
#
#     tests/promises/random/random.t all
. tests/host/test.sh
. tests/host/project.sh
begin random
one_isoc
. tests/host/poison.sh
. tests/host/bits.sh
seeds=1
case ${1-} in
[0-9]*) first=$1 seeds=1 ;;
*)
    turn=$(turn_of 1000 "${1-}")
    [ "$turn" != all ] || turn=0 seeds=60
    first=$((turn * seeds + 1))
    ;;
esac
last=$((first + seeds - 1))
echo "# seeds $first to $last"

# The scenes, and in $cases a word SEED:METHOD of each.
written=0 cases=
seed=$((first - 1))
while [ $((seed += 1)) -le "$last" ]; do
    python3 tests/promises/random/write_scene.py "$seed" >"$out/random_$seed.scene" &&
        isoc "$out/output" "$out/errors" "$out/random_$seed.scene" -o "$out/plant/$seed" && written=$((written + 1)) || explain
    method=
    while read -r word method_of; do
        [ "$word" != method ] || method=$method_of
    done <"$out/random_$seed.scene"
    cases="$cases $seed:$method"
done
result $((written != seeds)) "$written of $seeds scenes are compiled"

# With an implicit method what puts the states onto the closures meets the effects as they are, and so the inputs.
python3 tests/promises/random/write_scene.py 1271 >"$out/inputs.scene" && isoc "$out/output" '' "$out/inputs.scene" -o "$out/inputs" &&
    grep -q '^static void settle(real \*const x, const real \*const u,' "$out/inputs/plant.c" &&
    $CC $FLAGS -fsyntax-only "$out/inputs/plant.c"
result $? "closures with an implicit method, and an effect of inputs"

for compiler in gcc clang; do
    batch $compiler float $compiler
    generated tests/promises/random/selections.scene rk4 2>"$out/errors"
    for case in $cases; do
        generated "$out/random_${case%:*}.scene" "${case#*:}" 2>"$out/errors"
    done
    joined "by $compiler" watch
done

# Bits. Half a second, or less where the guard ends the run, then on all in the same tick.
while read -r variant; do
    # shellcheck disable=SC2086
    variant $variant
    result $? "$variant: core and port compile"
    for case in $cases; do
        seed=${case%:*}
        method=${case#*:}
        runs "$out/plant/$seed/plant.c" 200000000
        read_value hash
        hash=$value
        [ -f "$out/hash/$seed" ] || echo "$hash" >"$out/hash/$seed"
        read -r known <"$out/hash/$seed"
        case $hash in
        *[!0-9a-f]*) false ;;
        ????????????????) [ "$hash" = "$known" ] ;;
        *) false ;;
        esac
        expect $? "seed $seed, $method: $variant, $hash"
        [ "$port" != mps2 ] || {
            counted "$method"
            expect $? "seed $seed: $instructions instructions on every step"
        }
    done
done <<END
gcc host gcc -O0
gcc-O2 host gcc -O2
clang host clang -O2
Cortex-M4F mps2 arm-none-eabi-gcc $(of_port mps2 PORT_OPTIMISE)
END
[ "$(cat "$out"/hash/* | sort -u | wc -l)" -eq "$seeds" ]
result $? "the hashes tell the scenes apart"

# Controls. A branch in the outputs of a random scene; and clang on a core that hides no mask from it.
small=$(ls -rS "$out"/plant/[0-9]*/plant.c | head -n 1)
small=${small%/plant.c}
planted='static volatile int met; if (((plant_memory *)instance)->x[0] > R(0.25)) { met++; }'
for compiler in gcc clang; do
    batch planted_$compiler float $compiler
    sed "/^static void output(void \*const instance)\$/{n;s/{/{ $planted/;}" "$small/plant.c" >"$out/plant/planted.c"
    cp "$small/plant.h" "$out/plant"
    add "planted" "$out/plant/planted.c"
    ! watch >"$out/tap" && [ "$(grep '^not ok' "$out/tap")" = "not ok 3 - planted: nor do the memories and the outputs" ]
    result $? "found: a branch in the outputs of seed ${small##*/}, by $compiler"
done
batch bare float clang
mkdir -p "$out/bare_core"
cp -r core "$out/bare_core"
sed -i '/__asm__/d' "$out/bare_core/core/numbers/real.h"
isoc "$out/summary" "$out/errors" tests/promises/random/selections.scene -o "$out/plant/bare"
FLAGS=$(echo "$FLAGS" | sed "s| -I\.| -I$out/bare_core -I.|")
add "bare" "$out/plant/bare/plant.c"
! watch >"$out/tap" && grep -q '^not ok 3' "$out/tap"
result $? "found: what clang makes of masks that are not hidden"
finish
