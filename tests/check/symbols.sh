#!/bin/sh
# What runs on the target calls nothing but itself: no heap, stdio, libm, and in the float build no double arithmetic.
. tests/host/test.sh
begin check/symbols
turn=$(turn_of 10 "${1-}" core tools/isoc models)
echo "# turn $turn of the models"
METHODS=$(build/isoc --methods | sed -n 's/^| \([a-z0-9_]*\) | [0-9].*/\1/p')

m4f=$(awk '$1 == "PORT_FLAGS" { sub(/^[^=]*= /, ""); print }' port/mps2/port.mk)

# What may be called beside the project's own: copying and comparing memory, and whole numbers of 64 bits (EABI's run-time helpers).
allowed='mem(cpy|move|set|cmp)|__aeabi_mem(cpy|set|clr)[48]?|__aeabi_(uldivmod|ldivmod|lmul|llsl|llsr|lasr|lcmp|ulcmp|ldiv0|idiv0)'
linker=$(awk '$2 == "=" { print $1 }' port/mps2/sections.ld | paste -sd '|')
helpers='__(u)?divmoddi4|__udivmoddi4|__(u)?divdi3|__gnu_u?ldivmod_helper'

# outside OBJECT...: symbols that the objects need and none of them has, but for those allowed.
outside()
{
    arm-none-eabi-nm -g --defined-only "$@" | awk 'NF == 3 { print $3 }' | sort -u >"$out/defined"
    arm-none-eabi-nm -u "$@" | awk '$1 == "U" { print $2 }' | sort -u | comm -23 - "$out/defined" |
        grep -Ev "^($allowed|$linker)\$"
}

# objects DIR FLAGS FILE...: compiles the files for the target into $out/DIR.
objects()
{
    dir=$out/$1
    flags=$2
    shift 2
    rm -rf "$dir"
    mkdir -p "$dir"
    for file in "$@"; do
        # shellcheck disable=SC2086
        arm-none-eabi-gcc $FLAGS $m4f $flags -c "$file" -o "$dir/$(echo "$file" | tr / -).o" || return 1
    done
}

# firmware SOURCES NAME: two tests of the program of one plant.
firmware()
{
    rm -f "$out/firmware" "$out/found"
    # shellcheck disable=SC2086
    objects plant "" $1
    outside "$out"/base/*.o "$out"/plant/*.o >"$out/found"
    sed 's/^/# /' "$out/found"
    [ -n "$(ls "$out/plant")" ] && [ ! -s "$out/found" ]
    result $? "$2: calls nothing outside"

    # shellcheck disable=SC2086
    arm-none-eabi-gcc $m4f -nostartfiles --specs=nano.specs -T port/mps2/mps2.ld -Wl,--gc-sections \
        "$out"/base/*.o "$out"/plant/*.o -o "$out/firmware" &&
        arm-none-eabi-nm "$out/firmware" | awk '{ print $NF }' | grep -E '^(__aeabi_|_sbrk|_malloc|__.*[sd]f)' |
        grep -Ev "^($allowed|$helpers)\$" >"$out/found"
    sed 's/^/# /' "$out/found"
    [ -f "$out/firmware" ] && [ ! -s "$out/found" ]
    result $? "$2: holds no floating-point helper and no heap"
}

# generated SCENE METHOD: the same of the plant of a scene.
generated()
{
    name=$(basename "$1" .scene)
    build/isoc "$1" -o "$out/$name-$2" --method "$2" --real float >/dev/null
    firmware "$out/$name-$2/plant.c" "$name, $2"
}

objects base "" core/numbers/*.c core/runtime/*.c core/application/*.c port/mps2/*.c
result $? "core and port compile for the target"
firmware models/oscillator.c oscillator
# By rk4 the models that are tried in depth, and the others by turns, as check/same_bits.sh, which has the same objects; and one of
# all kinds of joints by every method.
models_of rk4
for scene in $models; do
    ! due "$scene" rk4 || generated "$scene" rk4
done
for method in $METHODS; do
    generated models/tree.scene "$method"
done

# The program of a plant with a link and with calibration.
build/isoc models/tree.scene -o "$out/linked" --link --xcp open --real float >/dev/null &&
    objects base "" core/numbers/*.c core/runtime/*.c core/application/stream.c core/link/*.c core/xcp/*.c port/mps2/*.c
result $? "core/link and core/xcp compile for the target"
firmware "$out/linked/plant.c $out/linked/interface.c" "tree, with a link"

# planted SYMBOL CODE: the call must be seen.
planted()
{
    printf '%s\n' "$2" >"$out/planted.c"
    objects planted "-Wno-double-promotion -Wno-conversion" "$out/planted.c" && outside "$out"/planted/*.o | grep -qx "$1"
    result $? "found: $1"
}

planted malloc '#include <stdlib.h>
char *f(void); char *f(void) { return malloc(4); }'
planted printf '#include <stdio.h>
void f(int); void f(int x) { printf("%d", x); }'
planted sinf '#include <math.h>
float f(float); float f(float x) { return sinf(x); }'
planted sqrt '#include <math.h>
double f(double); double f(double x) { return sqrt(x); }'
planted __aeabi_dmul 'double f(double); double f(double x) { return x * x; }'
planted __aeabi_f2d 'double f(float); double f(float x) { return x; }'
planted __aeabi_dcmplt 'int f(double); int f(double x) { return x < 1; }'
planted __aeabi_i2d 'double f(int); double f(int x) { return x; }'
finish
