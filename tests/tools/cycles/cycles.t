#!/bin/sh
# The tables of cycles: each rule of each table on a few instructions, by hand, and what is wrong with a table or a
# trace. (isochron cycles: tests/tools/lab/test_cycles.py.)
. tests/host/test.sh
. tests/tools/cycles/rules.sh
begin check/cycles

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
finish
