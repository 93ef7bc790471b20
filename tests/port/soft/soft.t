#!/bin/sh
# Float and double by instructions of integers (port/soft): bit for bit what a floating-point unit computes, on pairs
# about powers of two and on 10^7 at random for each operation, a fifth of these each time, with the argument `all` 10^8
# (of double half of what is tried of float); and without a branch that follows from an operand. Each kind of shift is
# tried on the host, and the code for the Cortex-M3 and the Cortex-M0 on a Cortex-M4F and a Cortex-M7, against its
# floating-point unit.
. tests/host/test.sh
begin soft
real float
M3="-mcpu=cortex-m3 -mthumb -mfloat-abi=soft"
M0="-mcpu=cortex-m0 -mthumb -mfloat-abi=soft -masm-syntax-unified -DSOFT_PIECES"
RV32IMAC="-march=rv32imac -mabi=ilp32 --specs=picolibc.specs"
m4f=$(of_port mps2 PORT_FLAGS)
m7=$(of_port cortex-m7 PORT_FLAGS)
turn=$(turn_of 5 "${1-}")
echo "# turn $turn of the pairs on the host"
case $turn in
all)
    pairs=100000000
    turns=
    ;;
*)
    pairs=2000000
    turns="-DTURN=${turn}U -DTURNS=5U"
    ;;
esac

# compared PROGRAM PAIRS [FLAG...]: on the host; the program is soft or wide, of float or double. A flag -I before .
# finds another port/soft.
compared()
{
    compared_by=$1
    compared_pairs=$2
    shift 2
    # shellcheck disable=SC2086
    "$CC" "$@" $FLAGS "tests/port/soft/$compared_by.c" tests/port/soft/$(operations $compared_by).c tests/tap.c port/host/*.c port/unix/console.c \
        -o "$out/soft" -lm && "$out/soft" "$compared_pairs"
}

# operations PROGRAM: the file with what it tries.
operations()
{
    case $1 in
    soft) echo operations ;;
    wide) echo wide_operations ;;
    esac
}

# on_board PROGRAM FLAGS: code for another core, on the board that has a floating-point unit.
on_board()
{
    case $1 in
    soft) set -- "$@" "$m4f" mps2-an386 17 20000 ;;
    wide) set -- "$@" "$m7" mps2-an500 5 4000 ;;
    esac
    # shellcheck disable=SC2086
    arm-none-eabi-gcc $FLAGS $2 -c "tests/port/soft/$(operations "$1").c" -o "$out/operations.o" &&
        arm-none-eabi-objcopy --remove-section .ARM.attributes "$out/operations.o" &&
        arm-none-eabi-gcc $FLAGS $3 -DEXPONENT_STEP=$5 -nostartfiles --specs=nano.specs -T port/mps2/mps2.ld \
            -Wl,--gc-sections "tests/port/soft/$1.c" "$out/operations.o" tests/tap.c port/mps2/port.c port/mps2/console.c port/mps2/s*.c \
            -lm -o "$out/board" &&
        timeout 300 qemu-system-arm -M $4 -icount shift=10,align=off,sleep=off -display none -monitor none -serial none \
            -semihosting-config enable=on,target=native,arg=soft,arg=$6 -kernel "$out/board"
}

# watched COMPILER [FLAG...]: under memcheck, with operands that are undefined.
watched()
{
    compiler=$1
    shift
    # shellcheck disable=SC2086
    "$compiler" "$@" $FLAGS tests/port/soft/poison.c tests/port/soft/operations.c tests/port/soft/wide_operations.c -o "$out/poison" &&
        valgrind --quiet --log-file="$out/memcheck" "$out/poison"
}

# branches TOOLS FLAGS HELPERS [FLAG...]: how many instructions of the helpers of a core branch on a condition.
branches()
{
    branches_tools=$1
    branches_flags=$2
    branches_helpers=$3
    shift 3
    # shellcheck disable=SC2086
    "$branches_tools-gcc" "$@" $FLAGS $branches_flags -c "port/soft/$branches_helpers.c" -o "$out/helpers.o" &&
        "$branches_tools-objdump" -d "$out/helpers.o" |
        awk '/\t(b(eq|ne|cs|cc|hs|lo|mi|pl|vs|vc|hi|ls|ge|lt|gt|le|geu|ltu|gtu|leu)(z|\.[nw])?|cbn?z)\t/ { n++ } END { print n + 0 }'
}

joined "by one shift" compared soft $pairs $turns
joined "by stages, a product in pieces" compared soft $((pairs / 10)) $turns -DSOFT_STAGES -DSOFT_PIECES
joined "double, by one shift" compared wide $((pairs / 2))
joined "double, a product in pieces" compared wide $((pairs / 20)) -DSOFT_STAGES -DSOFT_PIECES
for program in soft wide; do
    joined "$program: code for the Cortex-M3" on_board $program "$M3"
    joined "$program: code for the Cortex-M0" on_board $program "$M0"
done
for compiler in gcc clang; do
    joined "$compiler, by one shift, no branch" watched $compiler
    joined "$compiler, by stages, no branch" watched $compiler -DSOFT_STAGES -DSOFT_PIECES
done
# The loop of the quotient counts its bits.
while read -r core tools helpers loops flags; do
    [ "$(branches $tools "$flags" $helpers)" -eq "$loops" ]
    result $? "code for the $core has as many conditions as loops, $loops: $helpers.c"
done <<END
Cortex-M3 arm-none-eabi aeabi 1 $M3
Cortex-M3 arm-none-eabi aeabi_double 1 $M3
Cortex-M0 arm-none-eabi aeabi 1 $M0
Cortex-M0 arm-none-eabi aeabi_double 1 $M0
RV32IMAC riscv64-unknown-elf gcc 1 $RV32IMAC
RV32IMAC riscv64-unknown-elf gcc_sum 0 $RV32IMAC
RV32IMAC riscv64-unknown-elf gcc_double 1 $RV32IMAC
END

# planted FILE EDIT: another text of it, found by -I$out/planted.
planted()
{
    rm -rf "$out/planted"
    mkdir -p "$out/planted/port"
    cp -r port/soft "$out/planted/port"
    sed "$2" "port/soft/$1" >"$out/planted/port/soft/$1"
    ! cmp -s "port/soft/$1" "$out/planted/port/soft/$1"
}

# failed NAME...: these tests, and no other, are among those of $out/tap that did not pass.
failed()
{
    [ "$(sed -n 's/^not ok [0-9]* - //p' "$out/tap" | tr '\n' ' ')" = "$* " ]
}

rounding="sum difference product quotient from int32 from uint32 from int64 from uint64"
for term in 1 0; do
    # shellcheck disable=SC2086
    planted shifts.h "s/behind + (x & 1) + most/behind + $term + most/" && ! compared soft 1000 -DEXPONENT_STEP=3 "-I$out/planted" >"$out/tap" && failed $rounding
    result $? "found: a half that is always rounded $([ $term = 1 ] && echo up || echo down)"
done
planted binary32.h 's/ + (positive - exponent);/;/' && ! compared soft 1000 -DEXPONENT_STEP=3 "-I$out/planted" >"$out/tap" && failed product quotient
result $? "found: numbers below the least normal one that are not rounded as such"
planted binary64.h 's/soft_nonzero(behind << 1) | ((uint32_t)x & 1)/1/' && ! compared wide 1000 "-I$out/planted" >"$out/tap" &&
    failed sum difference product quotient from int64 from uint64
result $? "found: a half of a double that is always rounded up"
planted binary64.h 's/ + (positive - exponent));/);/' && ! compared wide 1000 "-I$out/planted" >"$out/tap" && failed product quotient
result $? "found: doubles below the least normal one that are not rounded as such"
planted binary64.h '/^static inline uint64_t soft64_add/,/^}/s/^    const uint64_t x = a/    if (a == 0) { return b; }\n&/' &&
    ! watched gcc "-I$out/planted" >"$out/tap" && failed double: sum double: difference
result $? "found by memcheck: a branch on a double"
[ "$(branches arm-none-eabi "$M3" aeabi_double "-I$out/planted")" -gt 1 ]
result $? "found in the code for the Cortex-M3: a branch on a double"
planted binary32.h '/^static inline uint32_t soft_multiply/,/^}/s/^    uint32_t significand;/    if (a == 0) { return 0; }\n&/' &&
    ! watched gcc "-I$out/planted" >"$out/tap" && failed product
result $? "found by memcheck: a branch on an operand"
[ "$(branches arm-none-eabi "$M0" aeabi "-I$out/planted")" -gt 1 ]
result $? "found in the code for the Cortex-M0: a branch on an operand"
[ "$(branches riscv64-unknown-elf "$RV32IMAC" gcc_sum "-I$out/planted")" -gt 0 ]
result $? "found in the code for the RV32IMAC: a branch on an operand"
finish
