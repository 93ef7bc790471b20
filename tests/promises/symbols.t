#!/bin/sh
# What runs on the target calls nothing but itself: no heap, stdio, libm, and in the float build no double arithmetic.
. tests/host/test.sh
begin check/symbols
one_isoc
turn=$(turn_of 20 "${1-}")
echo "# turn $turn of the models"
METHODS=$(build/isoc --methods | sed -n 's/^| \([a-z0-9_]*\) | [0-9].*/\1/p')

m4f=$(of_port mps2 PORT_FLAGS)

# What may be called beside the project's own: copying and comparing memory, and whole numbers of 64 bits (EABI's
# run-time helpers).
allowed='mem(cpy|move|set|cmp)|__aeabi_mem(cpy|set|clr)[48]?|__aeabi_(uldivmod|ldivmod|lmul|llsl|llsr|lasr|lcmp|ulcmp|ldiv0|idiv0)'
linker=$(awk '$2 == "=" { print $1 }' port/mps2/sections.ld | paste -sd '|')
helpers='__(u)?divmoddi4|__udivmoddi4|__(u)?divdi3|__gnu_u?ldivmod_helper'

# objects DIR FLAGS FILE...: compiles the files for the target into $out/DIR, which is made anew.
objects()
{
    dir=$out/$1
    flags=$2
    shift 2
    [ -d "$dir" ] || mkdir "$dir" || return
    number=0
    for file; do
        number=$((number + 1))
        # shellcheck disable=SC2086
        arm-none-eabi-gcc $FLAGS $m4f $flags -c "$file" -o "$dir/$number.o" || return
    done
}

# firmware BASE SOURCES NAME: compiles and links the program of a plant with the objects of $out/BASE, which may fail:
# $count is its number; its line in $out/programs has the folders of its objects and the name.
count=0
: >"$out/programs"
# shellcheck disable=SC2046
(cd "$out" && exec mkdir $(seq 99))
firmware()
{
    count=$((count + 1))
    printf '%s\t%s\t%s\n' $count "$1" "$3" >>"$out/programs"
    # shellcheck disable=SC2086
    objects $count "" $2 && arm-none-eabi-gcc $m4f -nostartfiles --specs=nano.specs -T port/mps2/mps2.ld -Wl,--gc-sections \
        "$out/$1"/*.o "$out/$count"/*.o -o "$out/$count/firmware"
}

# generated SCENE METHOD: the same of the plant of a scene.
generated()
{
    name=${1##*/}
    name=${name%.scene}
    isoc /dev/null '' "$1" -o "$out/$name-$2" --method "$2" --real float
    firmware base "$out/$name-$2/plant.c" "$name, $2"
}

# outside: of each program of the list on its input a line, its number and two lists: the symbols that its objects need
# and none of them has, and the helpers and the heap in its firmware, but for those allowed; `-` where there is none,
# `!` where there is no object, or no firmware.
outside()
{
    find "$out" -name '*.o' -exec arm-none-eabi-nm -A -g {} + >"$out/symbols" &&
        find "$out" -name firmware -exec arm-none-eabi-nm -A {} + >"$out/linked"
    awk -F '\t' -v objects="$out/symbols" -v linked="$out/linked" -v folder="$out/" -v allowed="^($allowed|$linker)\$" -v helpers="^($allowed|$helpers)\$" '
        # folder_of LINE: in which the file of a line of nm stands; its type and its symbol are in `type` and `symbol`.
        function folder_of(line,    place, word, n) {
            n = split(line, word, " ")
            symbol = word[n]
            type = word[n - 1]
            place = substr(line, length(folder) + 1)
            sub(/\/.*/, "", place)
            return place
        }
        # missing PLACE OTHER: what the objects in one folder need, and those in it and the other do not have.
        function missing(place, other,    i, needs, text) {
            for (i = 1; i <= count[place]; i++) {
                needs = needed[place, i]
                if (!((place, needs) in has) && !((other, needs) in has) && needs !~ allowed) text = text " " needs
            }
            return text
        }
        BEGIN {
            while ((getline line <objects) > 0) {
                place = folder_of(line)
                objects_in[place]
                if (type == "U") needed[place, ++count[place]] = symbol
                else has[place, symbol]
            }
            while ((getline line <linked) > 0) {
                place = folder_of(line)
                firmware_in[place]
                if (symbol ~ /^(__aeabi_|_sbrk|_malloc|__.*[sd]f)/ && symbol !~ helpers) held[place] = held[place] " " symbol
            }
        }
        {
            needs = $1 in objects_in ? missing($1, $2) ($2 == "" ? "" : missing($2, $1)) : " !"
            held_here = $1 in firmware_in ? held[$1] : " !"
            printf "%s\t%s\t%s\n", $1, (needs == "" ? "-" : substr(needs, 2)), (held_here == "" ? "-" : substr(held_here, 2))
        }'
}

objects base "" core/numbers/*.c core/runtime/*.c core/application/*.c port/mps2/*.c
result $? "core and port compile for the target"
firmware base models/oscillator.c oscillator
# By rk4 the models that are tried in depth, and the others by turns, as promises/same_bits.t, which has the same
# objects; and one of all kinds of joints by every method.
models_of rk4
for scene in $models; do
    ! due "$scene" rk4 || generated "$scene" rk4
done
for method in $METHODS; do
    generated models/tree.scene "$method"
done

# The program of a plant with a link and with calibration.
isoc /dev/null '' models/tree.scene -o "$out/plant" --link --xcp open --real float &&
    objects with_link "" core/numbers/*.c core/runtime/*.c core/application/stream.c core/link/*.c core/xcp/*.c port/mps2/*.c
result $? "core/link and core/xcp compile for the target"
firmware with_link "$out/plant/plant.c $out/plant/interface.c" "tree, with a link"

# planted SYMBOL CODE: the call must be seen.
: >"$out/planted"
planted()
{
    count=$((count + 1))
    printf '%s\n' "$2" >"$out/planted.c"
    printf '%s\t%s\n' $count "$1" >>"$out/planted"
    objects $count "-Wno-double-promotion -Wno-conversion" "$out/planted.c"
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

tab=$(printf '\t')
outside <"$out/programs" >"$out/found"
while IFS=$tab read -r _ _ name && IFS=$tab read -r _ needs helpers <&3; do
    [ "$needs $helpers" = '- -' ] || echo "# $needs; $helpers"
    [ "$needs" = - ]
    result $? "$name: calls nothing outside"
    [ "$helpers" = - ]
    result $? "$name: holds no floating-point helper and no heap"
done <"$out/programs" 3<"$out/found"
while IFS=$tab read -r number symbol; do
    printf '%s\t\n' "$number"
done <"$out/planted" | outside >"$out/found"
while IFS=$tab read -r _ symbol && IFS=$tab read -r _ needs _ <&3; do
    case " $needs " in
    *" $symbol "*) true ;;
    *) false ;;
    esac
    result $? "found: $symbol"
done <"$out/planted" 3<"$out/found"
finish
