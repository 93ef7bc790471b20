#!/bin/sh
# A plant as a part of other firmware: two plants, one of them twice, in one program; a folder that compiles alone, as C
# by three compilers and from C++; names, units and limits in the header; files that are replaced together or not at
# all.
. tests/host/test.sh
begin firmware
root=$PWD
strict="-Wall -Wextra -Werror -Wconversion"
m4f="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16"

# The compiler by itself, far from the project: it finds nothing of it.
mkdir -p "$out/tools"
cp build/isoc "$out/tools/isoc"
sed 's|^tunable rail_damping.*|tunable rail_damping = 2 N*s/m in 0.5 N*s/m to 4 N*s/m|' models/cart_pole.scene >"$out/cart.scene"
grep -q 'to 4 N' "$out/cart.scene" && cp models/pendulum.scene "$out/swing.scene"
result $? "the scenes are there"

# folder DIR [OPTION...]: both plants, each with what it needs.
folder()
{
    made=$1
    shift
    (cd "$out" && tools/isoc cart.scene -o "$made" --name cart --standalone "$@" &&
        tools/isoc swing.scene -o "$made" --name swing --standalone "$@") >"$out/summary" &&
        cp tests/use/firmware/own.c tests/use/firmware/bare.c "$out/$made"
}

# objects DIR COMPILER...: all its sources, without a path to anything else.
objects()
{
    where=$out/$1
    shift
    (
        cd "$where" || exit
        for source in *.c; do
            case $source in
            own.c | bare.c) ;;
            *) set -- "$@" "$source" ;;
            esac
        done
        # shellcheck disable=SC2086
        exec "$@" -std=c11 $strict -Wpedantic -O2 -ffp-contract=off -c
    )
}

for real in float double; do
    for method in rk4 abm4 bdf4 adams; do
        folder "$real.$method" --real $real --method $method && objects "$real.$method" gcc &&
            (cd "$out/$real.$method" && gcc -std=c11 $strict -Wpedantic own.c ./*.o -o own)
        result $? "$method, $real: the folder compiles alone"
        joined "$method, $real" "$out/$real.$method/own"
    done
done
(cd "$out/float.rk4" && g++ -std=c++17 $strict -x c++ own.c -x none ./*.o -o from_cpp)
result $? "from C++17"
(cd "$out/float.rk4" && g++ -std=c++20 $strict -fsyntax-only -x c++ own.c)
result $? "from C++20, without a warning"
joined "from C++17" "$out/float.rk4/from_cpp"
folder clang && objects clang clang && (cd "$out/clang" && clang -std=c11 $strict own.c ./*.o -o own && ./own >own.tap)
result $? "by clang"
folder m4f && objects m4f arm-none-eabi-gcc $m4f &&
    (cd "$out/m4f" && arm-none-eabi-gcc -std=c11 $strict $m4f --specs=rdimon.specs own.c ./*.o -o own.elf)
result $? "for the Cortex-M4F"
folder watched --method bdf4 && echo 'checked yes' >>"$out/swing.scene" && folder watched --method abm4 &&
    objects watched gcc && ! grep -q 'swing_plant(swing_memory \*const memory)' "$out/watched/swing.h"
result $? "a plant whose steps are made again takes room for one before"

# Controls.
rm -f "$out/clang/core/methods/progress.h"
! objects clang clang 2>"$out/errors" && grep -q progress.h "$out/errors"
result $? "found: a folder that lacks a file does not compile"
folder cpp && printf 'static inline int *bad(void) { void *p = 0; return p; }\n' >>"$out/cpp/cart.h" && objects cpp gcc &&
    ! (cd "$out/cpp" && g++ -std=c++17 -x c++ -c own.c -o own.o) 2>"$out/errors" && grep -q 'invalid conversion' "$out/errors"
result $? "found: a header that is C alone"
! (cd "$out/double.rk4" && gcc -std=c11 -c ../../../../tests/use/firmware/bare.c -I../float.rk4 -DISO_REAL_DOUBLE -o bare.o) 2>"$out/errors" &&
    grep -q 'was made with --real float' "$out/errors"
result $? "found: a header of float in a build of double"

# names OBJECT: those that it has for others.
names()
{
    nm -g --defined-only "$1" | awk '{ print $NF }'
}

names "$out/float.bdf4/cart.o" >"$out/names"
[ -s "$out/names" ] && ! grep -v '^cart_' "$out/names"
result $? "all names of the plant for others begin with its own"
awk '/^#define/ && $2 !~ /^CART_/ { bad = 1 } /^    [A-Z_]+,/ && $1 !~ /^CART_/ { bad = 1 } END { exit bad }' "$out/float.bdf4/cart.h"
result $? "so do the constants of its header"
build/isoc models/pendulum.scene -o "$out/program" >"$out/summary" && (cd "$out/program" && gcc -I"$root" -c plant.c) &&
    names "$out/program/plant.o" | grep -q '^iso_the_plant'
result $? "found: the plant of the program, without --name"
for name in Cart 9cart iso_cart 'a b' ''; do
    ! build/isoc models/pendulum.scene -o "$out/named" --name "$name" 2>"$out/errors" && grep -q -- '--name' "$out/errors" &&
        [ ! -e "$out/named" ]
    result $? "refused as a name: '$name'"
done

(cd "$out/float.rk4" && gcc -O2 -c bare.c && ! nm bare.o | grep -q 'cart_\(states\|inputs\|parameters\|outputs\)' &&
    gcc -O2 -DLOOKS -c bare.c -o looks.o && nm looks.o | grep -q cart_states)
result $? "tables take no bytes where nobody looks into them; found where somebody does"

# What a reader sees: places by name, units, the scene's own lines.
cart=$out/float.rk4/cart
! grep -E '\<(x|dx|u|p|y)\[[0-9]' "$cart.c" && grep -q 'x\[CART_X_HINGE_SPEED\]' "$cart.c"
result $? "no array is read or written by number"
grep -q 'CART_X_HINGE_SPEED, /\* rad/s \*/' "$cart.h" && grep -q 'CART_U_FORCE, /\* N \*/' "$cart.h"
result $? "places have their units"
for line in 'joint rail prismatic' 'output energy = energy' 'input force'; do
    grep -q "/\* $line" "$cart.c" && grep -q "^$line" "$out/cart.scene"
    result $? "the scene's line stands in the code: $line"
done
build/isoc models/four_bar.scene -o "$out/four_bar" >"$out/summary" &&
    awk '/\/\* close rocker_pin/ { quoted = NR } /real [a-zA-Z_]*Phi_rocker_pin/ { exit !(quoted == NR - 1) }' "$out/four_bar/plant.c"
result $? "that of a closure above its first quantity"

# limits TEXT PLACE MESSAGE: a tunable written so is refused.
limits()
{
    { cat models/pendulum.scene && echo "$1"; } >"$out/limits.scene"
    ! build/isoc "$out/limits.scene" -o "$out/limits" 2>"$out/errors" >"$out/summary" &&
        grep -q "limits.scene:[0-9]*:$2: error: $3" "$out/errors" && [ ! -e "$out/limits" ]
    result $? "refused: $1"
}

limits 'tunable k = 3 N/m in 0.5 N/m to 2 N/m' 13 "the default of 'k' is not within its limits"
limits 'tunable k = 1 N/m in 2 N/m to 0.5 N/m' 22 "the limits of 'k' are in the wrong order"
limits 'tunable k = 1 N/m in 0.5 N to 2 N/m' 22 "a limit of 'k'"
limits 'tunable k = 1 N/m in 0.5 N/m' 1 "expected to and the largest value"
limits 'constant k = 1 N/m in 0.5 N/m to 2 N/m' 20 ""
{ cat models/pendulum.scene && echo 'tunable k = 1 N/m in 1 N/m to 1 N/m'; } >"$out/limits.scene"
build/isoc "$out/limits.scene" -o "$out/limits" >"$out/summary"
result $? "accepted: limits that the default stands on"

# kept DIR: the files of before are all there, and nothing else.
kept()
{
    [ "$(ls "$out/$1")" = "$(printf 'plant.c\nplant.h')" ] && grep -qx OLD "$out/$1/plant.c" && grep -qx OLD "$out/$1/plant.h"
}

# old DIR: files of before.
old()
{
    mkdir -p "$out/$1"
    echo OLD >"$out/$1/plant.c"
    echo OLD >"$out/$1/plant.h"
}

# So many blocks of 512 bytes hold the header, not the source.
old full
! (ulimit -f 16 && build/isoc models/arm6.scene -o "$out/full") 2>"$out/errors" >"$out/summary" && [ -s "$out/errors" ] && kept full
result $? "a file that cannot be written whole: both stay as they were, nothing is left beside them"
(ulimit -f 1000 && build/isoc models/arm6.scene -o "$out/full") >"$out/summary" && ! kept full
result $? "found: with room for both, both are new"
[ "$(wc -c <"$out/full/plant.h")" -lt 8192 ] && [ "$(wc -c <"$out/full/plant.c")" -gt 8192 ]
result $? "and the limit lies between them"
old folder && rm "$out/folder/plant.c" && mkdir "$out/folder/plant.c"
! build/isoc models/pendulum.scene -o "$out/folder" 2>"$out/errors" >"$out/summary" &&
    grep -q 'plant.c: error: Is a directory' "$out/errors" && grep -qx OLD "$out/folder/plant.h" &&
    [ "$(ls "$out/folder")" = "$(printf 'plant.c\nplant.h')" ]
result $? "a folder where a file should be: the other stays as it was"
old told
! build/isoc models/pendulum.scene -o "$out/told" >/dev/full 2>"$out/errors" && grep -q 'standard output' "$out/errors"
result $? "a full standard output is told"
finish
