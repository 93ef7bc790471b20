#!/bin/sh
# isochron cycles: each rule of each table on a few instructions, by hand; the AVR's table against the cycles that
# simavr counts; what is told of a scene, what does not fit, and what is wrong with what was asked for; a row of
# models/cycles.md by turns.
. tests/host/test.sh
. tests/host/project.sh
. tests/tools/cycles/rules.sh
begin check/cycles
project

# traced CORE: assembles and runs the program of its rules; the listing and the trace are in $out/CORE.
traced()
{
    assembly "$1" >"$out/$1.S"
    case $1 in
    atmega1284p)
        avr-gcc -mmcu=atmega1284p "$out/$1.S" -o "$out/$1.elf" && avr-objdump -d "$out/$1.elf" >"$out/$1.listing" &&
            build/simavr_trace "$out/$1.elf" 0 >"$out/$1.trace"
        return
        ;;
    cortex-m4f) flags='-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16' machine=mps2-an386 ;;
    cortex-m7) flags='-mcpu=cortex-m7 -mfloat-abi=hard -mfpu=fpv5-d16' machine=mps2-an500 ;;
    cortex-m3) flags='-mcpu=cortex-m3' machine=mps2-an385 ;;
    cortex-m0plus*) flags='-mcpu=cortex-m0plus' machine=mps2-an385 ;;
    cortex-m0*) flags='-mcpu=cortex-m0' machine=mps2-an385 ;;
    esac
    # shellcheck disable=SC2086
    arm-none-eabi-gcc $flags -mthumb -nostdlib -Wl,-Ttext=0 -Wl,-e,reset "$out/$1.S" -o "$out/$1.elf" &&
        arm-none-eabi-objdump -d "$out/$1.elf" >"$out/$1.listing" &&
        timeout 10 qemu-system-arm -M $machine -display none -monitor none -serial none -semihosting-config enable=on,target=native \
            -singlestep -d nochain,exec -kernel "$out/$1.elf" 2>"$out/$1.trace" >/dev/null
}

# by_hand CORE: whether each line of $out/CORE.counted has the count by hand; $programs is how many there are.
by_hand()
{
    programs=0
    unlike=0
    while IFS='|' read -r text took wanted; do
        programs=$((programs + 1))
        [ "$took" = "$wanted" ] || { unlike=$((unlike + 1)) && echo "# $text: $took, by hand $wanted"; }
    done <"$out/$1.counted"
    [ $programs -gt 0 ] && [ $unlike -eq 0 ]
}

for table in tools/measure/cycles/cores/*.txt; do
    core=${table##*/}
    core=${core%.txt}
    traced "$core" && counted "$core" "$out/$core.listing" "$out/$core.trace" >"$out/$core.counted" && by_hand "$core"
    result $? "$core: $programs programs of a few instructions take what they take by hand"
    # With the small multiplier all else is as with the fast one.
    fast=tools/measure/cycles/cores/${core%-small}.txt
    case $core in
    *-small) awk 'FNR == NR { same[$0]; next } !($0 in same) && !/^(#|name|note|mul) / { exit other = 1 } END { exit other }' "$fast" "$table" ;;
    *) untried "$core" >"$out/untried" && { [ ! -s "$out/untried" ] || ! sed 's/^/# /' "$out/untried"; } ;;
    esac
    result $? "$core: each of its rules is tried"
done

# The m4f's table with a cycle more or less for a rule: found by the same programs.
sed '/^vmul\|^vadd/s/late 1/      /' tools/measure/cycles/cores/cortex-m4f.txt >"$out/early.txt"
build/cycles tick "$out/early.txt" "$out/cortex-m4f.listing" rule_3 "" none=none <"$out/cortex-m4f.trace" >"$out/tick"
awk 'FNR == NR { if (FNR == 3) counted = /[|]5 7[|]5 7$/; next } $1 == "part" && $2 == "tick" { tick = $4 } END { exit !(counted && tick == 4) }' \
    "$out/cortex-m4f.counted" "$out/tick"
result $? "found: a result that is not late"
grep -v '^vadd' tools/measure/cycles/cores/cortex-m4f.txt >"$out/less.txt"
! build/cycles tick "$out/less.txt" "$out/cortex-m4f.listing" rule_1 "" none=none <"$out/cortex-m4f.trace" >"$out/tick" 2>"$out/errors" &&
    grep -q 'no rule for the instruction vadd' "$out/errors"
result $? "found: an instruction without a rule"

# refused PROBLEM ARGUMENT...: cycles ends with an error that says this.
refused()
{
    problem=$1
    shift
    ! build/cycles "$@" <"$out/part.trace" >/dev/null 2>"$out/errors" && grep -q "$problem" "$out/errors"
    result $? "found: $problem"
}
m4f=tools/measure/cycles/cores/cortex-m4f.txt
sed '/rule_2$/q' "$out/cortex-m4f.trace" >"$out/part.trace"
refused 'no function leap' count $m4f "$out/cortex-m4f.listing" leap
refused 'no call that returns' count $m4f "$out/cortex-m4f.listing" rule_2
echo 'nop | integer | 1 | | |' >"$out/bad.txt"
refused 'bad.txt:1: it does not say where it is published' count "$out/bad.txt" "$out/cortex-m4f.listing" rule_1
echo 'nop | integer | one | | | table 1' >"$out/bad.txt"
refused 'bad.txt:1: these are no cycles' count "$out/bad.txt" "$out/cortex-m4f.listing" rule_1
echo 'nop | integer | 1 | | tardy 1 | table 1' >"$out/bad.txt"
refused 'bad.txt:1: a word is unknown' count "$out/bad.txt" "$out/cortex-m4f.listing" rule_1

# What the AVR's table makes of a model, against what simavr counts; both leave interrupts out.
#
# apart FILE: by how many millionths of its cycles a part of the tick differs at most; nothing where simavr counted
# none.
apart()
{
    awk -F '\t' '
        $1 == "part" && $6 > 0 { d = ($5 - $6) / $6 * 1e6; d = d < 0 ? -d : d; if (!n++ || d > most) most = d }
        END { if (n) printf "%.0f\n", most }' "$1"
}
built=$out/project/build/atmega1284p/float
for scene in pendulum cart_pole_drive dc_motor_bench; do
    isochron cycles models/$scene.scene --target atmega1284p --out build/atmega1284p/float/$scene --clock 1GHz
    [ "$(apart "$built/$scene/cycles/run.tsv")" -le 1000 ] && [ "$(awk '$2 == "step" { print $6 }' "$built/$scene/cycles/run.tsv")" -gt 10000 ]
    expect $? "$scene on the AVR: the table is within 0.1 % of what simavr counts: $(awk '$2 == "tick" { print $5, $6 }' "$built/$scene/cycles/run.tsv")"
done
sed '/^mul/s/| 2 /| 3 /' tools/measure/cycles/cores/atmega1284p.txt >"$out/project/tools/measure/cycles/cores/atmega1284p.txt"
isochron cycles models/pendulum.scene --target atmega1284p --out build/atmega1284p/float/pendulum --clock 1GHz
[ "$(apart "$built/pendulum/cycles/run.tsv")" -gt 1000 ]
expect $? "found: a product of three cycles"
cp tools/measure/cycles/cores/atmega1284p.txt "$out/project/tools/measure/cycles/cores/atmega1284p.txt"

# row NAME COLUMN: of the table that the last call wrote for $scene on $target.
row()
{
    awk -F '\t' -v name="$1" -v column="$2" '$1 == name || ($1 == "part" && $2 == name) { print $column; exit }' \
        "$out/project/build/$target/float/$scene/cycles.tsv"
}

target=cortex-m4f scene=cart_pole_drive
isochron cycles models/cart_pole_drive.scene --clock 168MHz && tail -n 1 "$out/output" | grep -qx fits
expect $? "cart_pole_drive on the Cortex-M4F fits"
awk -F '\t' '
    $1 == "part" && $2 != "tick" && $2 != "interrupt" { least += $4; most += $5 }
    $1 == "part" && $2 == "step" { step = $5 }
    $1 == "part" && $2 == "tick" { tick = $4 " " $5 }
    $1 == "kind" { kinds += $5; share += $6 }
    END { exit !(tick == least " " most && kinds == step && share > 99.9 && share < 100.1 && least > 0) }' \
    "$out/project/build/cortex-m4f/float/cart_pole_drive/cycles.tsv"
result $? "the parts are the tick, and the kinds the step"
grep -q 'dearest of a run with a change of the first tunable' "$out/output" && [ "$(row checks 3)" -gt 50 ]
result $? "the tick that is told is one with a change of a tunable"
load=$(row load_percent 3) stack=$(row stack 3) counted=$(row step 3)
isochron stack models/cart_pole_drive.scene --target cortex-m4f && printed stack_of_step "$stack"
expect $? "the stack of the step is that of isochron stack: $stack"
isochron run models/cart_pole_drive.scene --target cortex-m4f --seconds 0.01
read_value instructions_per_step && instructions=$value
[ "$instructions" -ge "$counted" ] && [ "$instructions" -le $((counted + 10)) ]
expect $? "the instructions of the step are those of make run, with a reading of the clock: $counted, $instructions"
isochron cycles models/cart_pole_drive.scene --clock 84MHz && [ "$(row load_percent 3 | awk -v before="$load" '{ d = $1 / before; print (d > 1.999 && d < 2.001) }')" = 1 ]
expect $? "half the clock is twice the load"
! isochron cycles models/cart_pole_drive.scene --clock 2MHz && tail -n 1 "$out/output" | grep -q '^does not fit: the tick is longer than the step$'
expect $? "found: a clock of 2 MHz is too slow"
target=cortex-m7
isochron cycles models/cart_pole_drive.scene --target cortex-m7 &&
    [ "$(awk -v least="$(row step 4)" -v most="$(row step 5)" -v n="$(row step 3)" 'BEGIN { print (least >= n / 2 && most > 1.5 * least) }')" = 1 ]
expect $? "the Cortex-M7 has a bound: $(row step 4) to $(row step 5) cycles of $(row step 3) instructions"
target=cortex-m0
isochron cycles models/pendulum.scene --target cortex-m0 --out build/cortex-m0/float/pendulum --clock 168MHz
scene=pendulum fast=$(row step 5)
isochron cycles models/pendulum.scene --target cortex-m0 --out build/cortex-m0/float/pendulum --core cortex-m0-small --clock 168MHz
[ "$(row step 5)" -gt "$fast" ]
expect $? "the small multiplier takes longer: $fast, $(row step 5)"

# A restart of the method is the dearest tick, and one that is made again dearer.
{ sed '/^method/d' models/pendulum.scene && printf 'method abm4\nchecked yes\n'; } >"$out/project/again.scene"
isochron cycles again.scene && grep -q 'dearest of a run with every second step made again' "$out/output"
expect $? "found: the tick with a step that is made again"
# Of adams all sub-steps are counted, though none but the first is needed.
counts=
target=cortex-m4f
scene=+adams.scene
for n in 1 3 4; do
    sed "s/^method.*/method adams; tolerance 1; substeps $n/" models/pendulum.scene >"$out/project/adams.scene"
    isochron cycles adams.scene --target cortex-m4f --out "build/cortex-m4f/float/$scene" && counts="$counts $(row step 5)"
done
echo "$counts" | awk '{ exit !(NF == 3 && $2 == $3 && $3 > 2.5 * $1) }'
expect $? "adams with 1, 3 and 4 sub-steps: $counts cycles; of 3 those of the next power of two"

# wrong TEXT ARGUMENT...: make ends with this error.
wrong()
{
    text=$1
    shift
    ! isochron cycles "$@" && grep -q "$text" "$out/errors"
    expect $? "found: $*"
}
wrong 'CLOCK=168 is no clock; it could be 168MHz' models/pendulum.scene --clock 168
wrong 'CLOCK=-1MHz is no clock' models/pendulum.scene --clock -1MHz
wrong 'CLOCK=1ms is no clock' models/pendulum.scene --clock 1ms
wrong 'BOARD=nano is unknown; of TARGET=cortex-m4f it can be: stm32f405' models/pendulum.scene --board nano
wrong 'CORE=cortex-m3 is no table of TARGET=cortex-m4f; it can be: cortex-m4f' models/pendulum.scene --core cortex-m3
wrong 'no table for TARGET=rv32imac: the cycles of a RISC-V core' models/pendulum.scene --target rv32imac
wrong 'no table for TARGET=cortex-m33: of the Cortex-M33 no published' models/pendulum.scene --target cortex-m33
wrong 'no table for TARGET=host' models/pendulum.scene --target host
wrong 'TARGET has no effect' --target cortex-m3

# models/cycles.md: a row of the table that `isochron cycles` prints, of the Cortex-M4F and one other core; with `all`
# every one.
turn=$(turn_of 75 "${1-}" models core tools port)
echo "# turn $turn of 75"
awk '/^<!-- end/ { on = 0 } on && NF; /^<!-- isochron cycles -->/ { on = 1 }' models/cycles.md >"$out/whole"
case $turn in
all) cp "$out/whole" "$out/table" && isochron cycles ;;
*)
    awk -F '|' -v OFS='|' -v turn="$turn" '
        NR <= 2 { print }
        NR > 2 && (NR - 3) % 25 == turn % 25 {
            for (i = 7; i < NF; i++) if (int((i - 7) / 3) != int(turn / 25)) $i = " . "
            print
        }' "$out/whole" >"$out/table"
    TURN=$((turn % 25))/25 CORES="cortex-m4f $(echo cortex-m3 cortex-m0 atmega1284p | cut -d ' ' -f $((turn / 25 + 1)))"
    export TURN CORES
    isochron cycles
    ;;
esac
grep '^|' "$out/output" >"$out/printed"
[ "$(wc -l <"$out/table")" -gt 2 ] && diff "$out/table" "$out/printed" >"$out/unlike"
status=$?
sed 's/^/# /' "$out/unlike"
expect $status "models/cycles.md has what isochron cycles prints: $(sed -n 3p "$out/table")"
sed '3s/[0-9] |/7x |/' "$out/table" >"$out/changed"
! cmp -s "$out/changed" "$out/table" && ! cmp -s "$out/changed" "$out/printed"
result $? "found: a number changed in it"
[ "$(wc -l <"$out/whole")" -eq $(($(ls models/*.scene | wc -l) + 2)) ]
result $? "models/cycles.md has all models"
finish
