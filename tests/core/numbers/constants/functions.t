#!/bin/sh
# The functions of core/numbers: the measurements (tests/core/numbers/exhaustive) notice a wrong digit in a constant; no
# branch and no address depends on an argument, with either compiler; without an FPU the bits are the same.
. tests/host/test.sh
begin check/functions

# measure NAME FLAG: builds tests/core/numbers/exhaustive/NAME.c with the core/ in $out/tree first, and runs a part of
# it.
measure()
{
    rm -f "$out/program"
    # shellcheck disable=SC2086
    $CC -I"$out/tree" $FLAGS $2 "tests/core/numbers/exhaustive/$1.c" -o "$out/program" -lm && "$out/program" 97 >"$out/tap"
}

# planted NAME REAL FROM TO: the measurement fails with FROM changed into TO, by its own judgement.
planted()
{
    sed "s/$3/$4/" "core/numbers/$1.h" >"$out/tree/core/numbers/$1.h"
    flag=$([ "$2" = double ] && echo -DISO_REAL_DOUBLE)
    ! measure "$1" "$flag" && grep -q '^not ok' "$out/tap" && grep -q '^1\.\.' "$out/tap" &&
        ! cmp -s "core/numbers/$1.h" "$out/tree/core/numbers/$1.h"
    result $? "found in $1, $2: $3 changed into $4"
    cp "core/numbers/$1.h" "$out/tree/core/numbers"
}

mkdir -p "$out/tree/core/numbers"
cp core/numbers/*.h "$out/tree/core/numbers"
planted exp float 4.166810215e-2 4.166910215e-2
planted exp float 2.12194440e-4 2.12195440e-4
planted exp double 4.16666666666666366e-02 4.16666666666676366e-02
planted log float 3.997757435e-1 3.987757435e-1
planted log double 1.81835732292057822e-01 1.81835742292057822e-01
planted tanh float 8.332042024e-3 8.333042024e-3
planted tanh double 2.75573192113544247e-06 2.75573202113544247e-06
planted angle float 1.997761428e-1 1.998761428e-1
planted angle float '0.414213562373095049' '0.614213562373095049'
planted angle double 7.69208048088145246e-02 7.69209048088145246e-02

# shellcheck disable=SC2086
$CC $FLAGS -DPLANTED tests/core/numbers/exhaustive/round.c -o "$out/round" -lm && ! "$out/round" 4 >"$out/tap" &&
    grep -q '^not ok 1 - round: worst error' "$out/tap" && grep -q '^ok 2 - floor' "$out/tap"
result $? 'found: halves that are rounded away from zero'
$CC $FLAGS -DPLANTED tests/core/numbers/exhaustive/noise.c -o "$out/noise" -lm && ! "$out/noise" 4 >"$out/tap" &&
    grep -q '^not ok .* correlation with a later tick' "$out/tap"
result $? "found in noise: ticks in pairs"

# Under memcheck with the arguments undefined.
for compiler in $CC clang; do
    # shellcheck disable=SC2086
    $compiler $FLAGS tests/core/numbers/constants/functions.c -o "$out/poisoned" -lm && valgrind --quiet --error-exitcode=9 "$out/poisoned"
    result $? "$compiler: no branch and no address depends on an argument"
done
# shellcheck disable=SC2086
$CC $FLAGS -DPLANTED tests/core/numbers/constants/functions.c -o "$out/poisoned" -lm &&
    ! valgrind --quiet --error-exitcode=9 "$out/poisoned" 2>"$out/errors" && grep -q uninitialised "$out/errors"
result $? "found: a branch"

# The unit test, with its bits, where numbers are computed by functions: only the start of the program knows the FPU.
soft="-mcpu=cortex-m4 -mthumb -mfloat-abi=soft"
# shellcheck disable=SC2086
arm-none-eabi-gcc $FLAGS -mcpu=cortex-m4 -mthumb -mfloat-abi=softfp -mfpu=fpv4-sp-d16 -c port/mps2/start.c \
    -o "$out/start.o" &&
    arm-none-eabi-gcc $FLAGS $soft -nostartfiles --specs=nano.specs -T port/mps2/mps2.ld tests/core/numbers/functions.c tests/tap.c \
        $(ls port/mps2/*.c | grep -v start.c) "$out/start.o" -lm -o "$out/soft"
result $? "a program without an FPU builds"
arm-none-eabi-nm "$out/soft" | grep -q __aeabi_fadd
result $? "it adds by a function"
joined "without an FPU" \
    qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none \
    -serial none -semihosting-config enable=on,target=native -kernel "$out/soft"
finish
