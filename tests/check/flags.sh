#!/bin/sh
# PORT_OPTIMISE of each port is the optimisation with which a step takes least: on the Cortex-M4F by cycles, on the host by
# instructions; -O2 where none takes much less. The cycles of single instructions are those of the manual.
. tests/host/test.sh
. tests/host/project.sh
begin check/flags
project

# cycles NUMBER NAME INSTRUCTION...: of a function of these instructions, each in an encoding of 32 bits, with its return
# (1 cycle more).
cycles()
{
    number=$1
    name=$2
    shift 2
    {
        printf '00000100 <caller>:\n     100:\tf000 f800 \tbl\t200 <step>\n     104:\tbf00      \tnop\n\n00000200 <step>:\n'
        address=512
        for instruction; do
            printf '     %x:\t0000 0000 \t%s\n' $address "$(echo "$instruction" | sed 's/ /\t/')"
            address=$((address + 4))
        done
        printf '     %x:\t4770      \tbx\tlr\n' $address
    } >"$out/listing"
    {
        echo 'Trace 0: 0x7f [00800400/00000100/00000010/ff020201] caller'
        for at in $(seq 512 4 $address); do
            printf 'Trace 0: 0x7f [00800400/%08x/00000010/ff020201] step\n' "$at"
        done
        echo 'Trace 0: 0x7f [00800400/00000104/00000010/ff020201] caller'
    } >"$out/trace"
    build/cycles step "$out/listing" <"$out/trace" >"$out/counted" &&
        [ "$(paste -sd ' ' "$out/counted")" = "instructions $(($# + 1)) cycles $((number + 1))" ]
    result $? "$name: $number cycles; $(paste -sd ' ' "$out/counted") with the return"
}

cycles 1 "an addition" 'vadd.f32 s0, s1, s2'
cycles 2 "a product and a sum of other numbers" 'vmul.f32 s0, s1, s2' 'vadd.f32 s3, s4, s5'
cycles 3 "a product and a sum that takes it" 'vmul.f32 s0, s1, s2' 'vadd.f32 s3, s0, s5'
cycles 2 "s1 is not s10" 'vmul.f32 s1, s2, s3' 'vadd.f32 s4, s10, s5'
cycles 3 "multiply-accumulate" 'vmla.f32 s0, s1, s2'
cycles 28 "division and square root" 'vdiv.f32 s0, s1, s2' 'vsqrt.f32 s3, s4'
cycles 4 "two loads of the floating point" 'vldr s0, [r0]' 'vldr s1, [r0, #4]'
cycles 3 "two loads of whole numbers" 'ldr r0, [r1]' 'ldr r2, [r1, #4]'
cycles 9 "eight registers at once" 'vpush {s16-s23}'
cycles 4 "three at once" 'push {r4, r5, lr}'
! build/cycles leap "$out/listing" <"$out/trace" >/dev/null 2>"$out/errors" && grep -q 'no function leap' "$out/errors"
result $? "found: a function that is not there"
! head -n 2 "$out/trace" | build/cycles step "$out/listing" >/dev/null 2>"$out/errors" && grep -q 'no call that returns' "$out/errors"
result $? "found: a trace that ends within the call"

# least TABLE COLUMN: the optimisation that its last row recommends: -O2, or the least of those that take a twentieth less.
least()
{
    awk -F ' *[|] *' -v column="$2" '
        NR == 1 { for (i = 2; i < NF; i++) name[i] = $i }
        /^[|] relative to -O2/ {
            best = "-O2"
            lowest = 0.95
            for (i = 2; i < NF; i++) {
                level = name[i]
                if ((column == "cycles") != (level ~ /, cycles$/)) continue
                sub(/, cycles/, "", level)
                if (level ~ /^-O/ && $i + 0 < lowest) {
                    lowest = $i + 0
                    best = level
                }
            }
            print best
        }' "$1"
}

# chosen TARGET PORT COLUMN ARGUMENT...
chosen()
{
    target=$1
    port=$2
    column=$3
    shift 3
    call flags TARGET="$target" MODELS="models/pendulum.scene models/double_pendulum.scene" "$@"
    expect $? "make flags on $target"
    grep '^|' "$out/output" | sed 's/^/# /'
    used=$(sed -n 's/^PORT_OPTIMISE = //p' "port/$port/port.mk")
    grep '^|' "$out/output" >"$out/table"
    [ -n "$used" ] && [ "$(least "$out/table" "$column")" = "$used" ]
    result $? "$target: $used is in use, and is what the table recommends"
}

chosen cortex-m4f mps2 cycles
sed '/relative/s/| [0-9.]* |$/| 0.5 |/' "$out/table" >"$out/other"
[ "$(least "$out/other" cycles)" = -O3 ]
result $? "found: a table that recommends another"
chosen host sim instructions REAL=double
finish
