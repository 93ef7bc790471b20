#!/bin/sh
# A build that would change bits is refused: by the preprocessor where it sees the flag, else by iso_self_check at
# start.
. tests/host/test.sh
. tests/host/project.sh
begin check/unsafe

cat >"$out/main.c" <<'C'
#include <stdio.h>
#include "core/numbers/self_check.c"
#ifdef MODE
#include <xmmintrin.h>
#endif
int main(void)
{
#ifdef MODE
    _mm_setcsr(_mm_getcsr() | MODE);
#endif
    puts(iso_self_check() ? "kept" : "changed");
    return 0;
}
C

# checked ANSWER NAME COMPILER FLAG...: what the self-check says of these flags; skipped where the machine has none
# such.
checked()
{
    answer=$1
    name=$2
    shift 2
    "$@" -I. "$out/main.c" -o "$out/checked" 2>"$out/errors" && [ "$("$out/checked" 2>&1)" = "$answer" ]
    expect $? "$name"
}

# refused TEXT NAME COMPILER FLAG...: the preprocessor stops, with a text that says the right flag.
refused()
{
    text=$1
    name=$2
    shift 2
    ! "$@" -std=c11 -I. -c core/numbers/self_check.c -o "$out/refused.o" 2>"$out/errors" && says "error*$text"
    expect $? "$name"
}

bare_numbers

for real in float double; do
    real $real
    for optimisation in -O0 -O2 -Os; do
        checked kept "$real $optimisation: kept" "$CC" -std=c11 $optimisation -ffp-contract=off $REAL_FLAG
    done
    refused 'without them and without -Ofast' "$real: -ffast-math" "$CC" -ffast-math $REAL_FLAG
    refused '-fexcess-precision=fast' "$real: float computed in double, as on s390x" "$CC" -U__FLT_EVAL_METHOD__ \
        -D__FLT_EVAL_METHOD__=1 $REAL_FLAG
    checked kept "$real: half precision computed as such, as on a Cortex-M55: kept" "$CC" -std=gnu17 -O2 -ffp-contract=off \
        -U__FLT_EVAL_METHOD__ -D__FLT_EVAL_METHOD__=16 $REAL_FLAG
    refused 'is not known' "$real: float computed in a type that is not known" "$CC" -U__FLT_EVAL_METHOD__ \
        -D__FLT_EVAL_METHOD__=-1 $REAL_FLAG
    refused 'without them and without -Ofast' "$real: a part of it" "$CC" -ffinite-math-only $REAL_FLAG
    case $(uname -m) in
    x86_64)
        checked changed "$real: flush to zero is found" "$CC" -std=c11 -O2 -ffp-contract=off -DMODE=0x8000 $REAL_FLAG
        checked changed "$real: denormal operands taken for zero are found" "$CC" -std=c11 -O2 -ffp-contract=off \
            -DMODE=0x0040 $REAL_FLAG
        for mode in 0x2000:down 0x4000:up 0x6000:zero; do
            checked changed "$real: rounding ${mode#*:} is found" "$CC" -std=c11 -O2 -ffp-contract=off \
                -DMODE="${mode%:*}" $REAL_FLAG
        done
        refused '-msse2 -mfpmath=sse' "$real: x87" gcc -mfpmath=387 $REAL_FLAG
        checked changed "$real: x87 is found by itself" gcc -std=c11 -O2 -mfpmath=387 -U__FLT_EVAL_METHOD__ \
            -D__FLT_EVAL_METHOD__=0 $REAL_FLAG
        checked changed "$real: division by a reciprocal is found by itself" gcc -std=c11 -O2 -ffp-contract=off \
            -freciprocal-math -U__RECIPROCAL_MATH__ $REAL_FLAG
        checked changed "$real: zeros without a sign are found by itself" gcc -std=c11 -O2 -fno-signed-zeros \
            -U__NO_SIGNED_ZEROS__ $REAL_FLAG
        if grep -qw fma /proc/cpuinfo; then
            checked kept "$real: gcc does not fuse" gcc -std=gnu11 -O2 -mfma -ffp-contract=fast $REAL_FLAG
            checked changed "$real: fused multiply-add is found" gcc "-I$out/bare" -std=gnu11 -O2 -mfma $REAL_FLAG
            checked changed "$real: so it is by clang" clang -O2 -mfma -ffp-contract=fast $REAL_FLAG
        fi
        ;;
    esac
done

# built FOLDER COMPILER FLAG...: the program of tests/core/methods/order/top.scene, by its compiler alone.
built()
{
    folder=$1
    shift
    "$@" -I. "$out/top/plant.c" core/numbers/*.c core/runtime/*.c core/application/*.c port/"$folder"/*.c \
        $([ "$folder" = mps2 ] || echo port/unix/console.c) -o "$out/built"
}

# told ARGUMENT...: what it writes says that it does not run.
told()
{
    ! "$@" >"$out/output" 2>"$out/errors" && grep -q '^Bail out! .*-ffp-contract=off' "$out/output"
}

real float
mkdir -p "$out/top"
build/isoc tests/core/methods/order/top.scene -o "$out/top" >"$out/summary"
strict='-std=c11 -O2 -ffp-contract=off -fno-tree-vectorize -fno-tree-slp-vectorize'
# shellcheck disable=SC2086
built host "$CC" $strict && "$out/built" 100000000 >"$out/stream" && built host "$CC" $strict -march=native &&
    "$out/built" 100000000 | cmp -s - "$out/stream"
expect $? "the same run with all that this processor can"
if grep -qw fma /proc/cpuinfo; then
    built host gcc "-I$out/bare" -std=gnu11 -O2 -mfma && told "$out/built" 100000000
    expect $? "a program that fuses says so and does not run"
fi

# board FLAG...: the program by the flags of the board's compiler, and these.
board()
{
    built mps2 arm-none-eabi-gcc "$@" -std=gnu11 -O2 -fno-math-errno -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 \
        -ffunction-sections -nostartfiles --specs=nano.specs -T port/mps2/mps2.ld -Wl,--gc-sections
}
run="qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none -serial none
    -semihosting-config enable=on,target=native,arg=plant,arg=100000000 -kernel $out/built"
# shellcheck disable=SC2086
board "-I$out/bare" && told $run
expect $? "nor does that of the board, with the flags of its compiler"
# shellcheck disable=SC2086
mkdir -p "$out/board" "$out/host" && board && build/trace -o "$out/board" -- $run >"$out/output" 2>"$out/errors" </dev/null && read_value hash && hash=$value && [ -n "$hash" ] &&
    built host "$CC" $strict && build/trace -o "$out/host" -- "$out/built" 100000000 >"$out/output" && printed hash "$hash"
expect $? "with the pragmas it moves as on the host: $hash"
finish
