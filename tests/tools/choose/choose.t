#!/bin/sh
# isochron choose: what it takes keeps its bounds in a run of its own, and nothing is cheaper by more than 10 %, by a
# search of all methods, ticks and sub-steps; what cannot be; what is asked for wrongly; what it writes into a scene. Of
# eight scenes, four of them random, with three bounds each, one by turns with one method, of which a fifth is tried;
# with `all` all with every method, which takes an hour.
. tests/host/test.sh
. tests/host/project.sh
begin choose
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES SCENE METHOD METHODS STEP SECONDS TARGET REAL

# ask ARGUMENT...: isochron choose; its output is in $out/output, its messages in $out/errors.
ask()
{
    make --no-print-directory choose "$@" >"$out/output" 2>"$out/errors" </dev/null
}

# expect STATUS NAME: a result; a failure is explained.
expect()
{
    [ "$1" -eq 0 ] || tail -n 8 "$out/output" "$out/errors" | sed 's/^/# /'
    result "$1" "$2"
}

# refused TEXT ERROR [LOAD]: without make, ends with a message that has this text.
refused()
{
    ! dir='' SCENE=$out/swing.scene NAME=swing FOLDER=choose.t MACHINE='cortex-m4f 168000000 stm32f405' ERROR=$2 LOAD=${3:-50%} \
        NANOSECONDS=1000000000 STEP='' INPUTS='' RECORDED='' SET='' WITHOUT='' METHODS=rk4 KEEP='' \
        sh tools/measure/choose/choose.sh >"$out/output" 2>"$out/errors" && grep -qF -- "$1" "$out/errors"
    expect $? "refused: $1"
}

cp models/pendulum.scene "$out/swing.scene"
refused "'1 mm of top': there is no output top; the scene has: theta rate tip energy" '1 mm of top'
refused "'1 s of tip': s is no unit of tip, which is in m" '1 mm of tip; 1 s of tip'
refused "'mm of tip' is no bound; it could be '1 mm of tip'" 'mm of tip'
refused "unknown unit 'mn'" '1 mn of tip'
refused 'ERROR is missing' ''
refused 'LOAD=half is no load; it could be 50%' '1 mm of tip' half

# Statements of a scene: those at its top only.
cat >"$out/told.scene" <<'END'
step 1 ms; method rk4 # method ab4; step
effect hold spring { along rail
    substeps 4 }
overrun degrade { method euler; after 3 ticks }
include "a;b.scene" ; compensated yes
END
awk -f tools/measure/choose/edit.awk -v statements='step 4 ms; method heun; substeps 2; compensated -' -v must=step "$out/told.scene" >"$out/edited"
cat >"$out/wanted" <<'END'
step 4 ms; method heun # method ab4; step
effect hold spring { along rail
    substeps 4 }
overrun degrade { method euler; after 3 ticks }
include "a;b.scene" ;
substeps 2
END
sed 's/ *$//' "$out/edited" | cmp -s - "$out/wanted"
result $? "statements at the top of a scene are replaced, others are not"
! awk -f tools/measure/choose/edit.awk -v statements='step 4 ms' -v must=step "$out/wanted" >"$out/edited" || ! grep -q 'step 4 ms' "$out/edited"
missing=$?
sed '/^step/d' "$out/wanted" | awk -f tools/measure/choose/edit.awk -v statements='step 4 ms' -v must=step >"$out/edited"
[ $? -eq 1 ] && [ $missing -eq 1 ] && [ ! -s "$out/edited" ]
result $? "a step that stands in no line of the file is not added"

! ask "$out/swing.scene" --error '1 nm of tip' --seconds 0.1 --step 10ms --methods rk4 --write &&
    tail -n 1 "$out/output" | grep -q '^none: no method keeps 1 nm of tip within 50 % of the chip$' && cmp -s models/pendulum.scene "$out/swing.scene"
expect $? "a bound below what a float holds cannot be met, which is said; the scene stays as it is"

# A core whose table lacks a rule: for an instruction of adams alone, and for one of every method.
project
lacking()
{
    sed "/^$1 /d" tools/measure/cycles/cores/cortex-m4f.txt >"$out/project/tools/measure/cycles/cores/cortex-m4f.txt"
}
lacking smulbb && isochron choose models/dc_motor_bench.scene --error '10 mA of current' --seconds 0.02 --methods 'rk4 adams' &&
    grep -q '^adams  .* no cycles are known: the table of the Cortex-M4F has no rule for the instruction smulbb$' "$out/output" &&
    tail -n 1 "$out/output" | grep -q '^take: rk4 at '
expect $? "a method without a price is a row that says so, and the others are advised"
lacking vadd && ! isochron choose models/pendulum.scene --error '1 mm of tip' --seconds 0.1 --methods 'rk4 adams' &&
    [ "$(grep -c ' no cycles are known: the table of the Cortex-M4F has no rule for the instruction v[a-z]*[.]f32$' "$out/output")" -eq 2 ] &&
    tail -n 1 "$out/output" | grep -qx 'none: of no method that keeps 1 mm of tip the cycles are known'
expect $? "where no method has a price, that is said"

make --no-print-directory -n cycles SCENE=models/pendulum.scene BOARD=stm32f411 >"$out/output" 2>"$out/errors"
expect $? "isochron cycles and isochron choose take a BOARD that is no target of its own"

# The cases: scene, method of the turn and what else is asked for, bound.
cat >"$out/cases" <<'END'
models/pendulum.scene|heun|10 mm of tip
models/pendulum.scene|rk4|1 mm of tip
models/pendulum.scene|ab4|10 um of tip
seed 1|rk4|10 mm of tip
seed 1|ab4|10 um of tip
seed 1|heun|1 um of tip
models/cart_pole.scene|adams STEP=1ms|10 mm of cart_position
models/cart_pole.scene|rk4|1 mm of cart_position; 1 deg of pole
models/cart_pole.scene|rosenbrock|1 um of cart_position
seed 2|rk4|10 mm of tip
seed 2|heun|1 mm of tip
seed 2|ab4|10 um of tip
models/double_pendulum.scene|abm4|10 mm of tip
models/double_pendulum.scene|rk4|1 mm of tip
models/double_pendulum.scene|ab4|10 um of tip
seed 3|rk4|10 mm of tip
seed 3|abm4_pec|1 mm of tip
seed 3|ab4|10 um of tip
models/top.scene|heun|1 mm of stem
models/top.scene|rk4|0.1 mm of stem
models/top.scene|rosenbrock|10 um of stem
seed 4|rk4|10 mm of tip
seed 4|heun|1 mm of tip
seed 4|ab4|10 um of tip
END
turn=$(turn_of 24 "${1-}" core tools/isoc tools/measure/choose)

# Of the turns of the double pendulum one. Its largest exponent of Lyapunov has a time below a second.
case $turn in
all | 13)
    ask models/double_pendulum.scene --error '1 mm of tip' --seconds 20 --methods rk4 --clock 168MHz &&
        grep -q '^From 1[0-9][.][0-9]* s on no method in float can keep the bound' "$out/output" &&
        tail -n 1 "$out/output" | grep -q '^take: rk4 at .*, compensated: 0' &&
        stated tools/measure/choose/README.md "$(grep '^From ' "$out/output")" &&
        stated tools/measure/choose/README.md "$(tail -n 1 "$out/output")"
    expect $? "a chaotic motion: $(grep -o '^From [^ ]* s on no method\|Judged up to .*' "$out/output" | tr '\n' ' ')"
    ;;
esac

number=0
while IFS='|' read -r scene methods bound; do
    number=$((number + 1))
    [ "$turn" = all ] || [ "$turn" -eq $((number - 1)) ] || continue
    case $scene in
    seed*)
        python3 tests/tools/choose/write_scene.py "${scene#seed }" >"$out/case_$number.scene"
        ;;
    *) cp "$scene" "$out/case_$number.scene" ;;
    esac
    set -- --methods "${methods%% *}"
    [ "$methods" = "${methods#* }" ] || set -- "$@" "${methods#* }"
    [ "$turn" != all ] || set --
    echo "# $scene: $bound"
    if ask "$out/case_$number.scene" --error "$bound" --seconds 1 --write "$@"; then
        grep -q '^It ran as .*: its error is [0-9]* % of the bound' "$out/output" && tail -n 1 "$out/output" | grep -q '^take: .* of the chip$'
        expect $? "$scene, $bound: $(tail -n 1 "$out/output")"
        folder=$(sed -n 's|^It ran as \(.*\)/advised.scene.*|\1|p' "$out/output")
        sh tests/tools/choose/exhaustive.sh "$folder" ${1:+5} >"$out/tried" 2>"$out/errors"
        [ ! -s "$out/errors" ] && awk '$1 == "kept" && $NF < 0.9 { print "#", $0; bad = 1 } END { exit bad || !/^tried/ }' "$out/tried"
        expect $? "nothing is cheaper by more than 10 %: $(tail -n 1 "$out/tried")"
        read -r method compensated k n rest <"$folder/best"
        grep -q "^kept $method $compensated $k $n " "$out/tried"
        result $? "found: what it took, as it costs what it costs"
        grep -qx "method ${method%%-*}" "$out/case_$number.scene" && build/isoc "$out/case_$number.scene" -o "$out/plant" >"$out/plant.txt" 2>&1 &&
            awk -v step="$(sed -n 's/.*step \([^;]*\);.*/\1/p' "$out/output" | head -n 1)" '
                $1 == "step" && $3 == "s" { split(step, part, " "); scale = part[2] == "ms" ? 1e-3 : 1e-6; good = ($2 - part[1] * scale) ^ 2 < 1e-18 }
                END { exit !good }' "$out/plant.txt"
        result $? "the scene has it now"
    else
        tail -n 1 "$out/output" | grep -q '^none: no method keeps '
        expect $? "$scene, $bound: $(tail -n 1 "$out/output")"
    fi
done <"$out/cases"
finish
