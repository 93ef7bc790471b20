#!/bin/sh
# Only what the scene calls for: an effect that it does not name leaves no instruction, no byte and no symbol in the
# plant's object for the Cortex-M4F; one that it names is there. The effects are those of tools/measure/effects.txt.
. tests/host/test.sh
begin check/effects
one_isoc

list=tools/measure/effects.txt
base=models/pendulum.scene
m4f="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16"

# object NAME [OPTION...]: compiles $out/NAME/pendulum.scene to $out/NAME/plant.o, a line of $objects.
objects=
object()
{
    folder=$out/$1
    shift
    objects="$objects
$folder/plant.o"
    # shellcheck disable=SC2086
    isoc "$folder/summary" '' "$folder/pendulum.scene" -o "$folder" "$@" &&
        arm-none-eabi-gcc $FLAGS $m4f -c "$folder/plant.c" -o "$folder/plant.o"
}

# edited NAME SED: the base scene, edited; compiled.
edited()
{
    sed "$2" $base >"$out/$1/pendulum.scene" && ! cmp -s $base "$out/$1/pendulum.scene" && object "$1"
}

# with NAME: the base scene with an effect of the list; compiled. Then the same with each line commented out that the
# base scene has not, in a folder of its own.
with()
{
    object "$1" || return
    commented=
    while IFS= read -r line; do
        case "
$base_text
" in
        *"
$line
"*) echo "$line" ;;
        *) echo "# $line" && commented=yes ;;
        esac
    done <"$out/$1/pendulum.scene" >"$out/$1.without/pendulum.scene"
    [ -n "$commented" ] && object "$1.without"
}

# contents NAME: of its object, $symbols, without what the compiler adds to them, and $memory, the bytes of all that its
# plant keeps.
contents()
{
    symbols=' '
    memory=
    contents_here=
    while read -r line; do
        case $line in
        *:) contents_here=${line%:} ;;
        esac
        [ "$contents_here" = "$out/$1/plant.o" ] && [ -n "$line" ] && [ "$line" != "$contents_here:" ] || continue
        symbol=${line##* }
        [ "$symbol" != memory ] || { memory=${line#* } && memory=$((0x${memory%% *})); }
        case $symbols in
        *" ${symbol%%.*} "*) ;;
        *) symbols="$symbols${symbol%%.*} " ;;
        esac
    done <"$out/nm"
}

# sum NAME: $sum is the checksum of its object with the length, nothing where there is none.
sum()
{
    sum=
    while read -r sum_number sum_length sum_file; do
        [ "$sum_file" != "$out/$1/plant.o" ] || sum="$sum_number $sum_length"
    done <"$out/sums"
}

# same NAME: its object is that of the base scene.
same()
{
    sum base
    same_base=$sum
    sum "$1"
    [ -n "$sum" ] && [ "$sum" = "$same_base" ]
}

# holds WHAT SYMBOLS BYTES NAME: the object has these symbols beside those of every plant, and this memory.
holds()
{
    contents "$4"
    holds_left=$symbols
    holds_missing=
    for holds_symbol in derivative finish iso_the_derivative_float iso_the_plant_float memory output plant_derivative plant_model start step $2; do
        case $holds_left in
        *" $holds_symbol "*) holds_left="${holds_left%% "$holds_symbol" *} ${holds_left#* "$holds_symbol" }" ;;
        *) holds_missing="$holds_missing $holds_symbol" ;;
        esac
    done
    # shellcheck disable=SC2086
    set -- "$1" "$2" "$3" $holds_left $holds_missing
    [ $# -eq 3 ]
    result $? "$1: symbols are those of every plant${2:+, $2}"
    [ "$memory" -eq "$3" ]
    result $? "$1: the memory is $3 bytes"
}

# All objects, then their contents and sums at once.
base_text=$(cat $base)
sed -n 's/^\([^#|][^|]*[^ |]\) *|.*/\1/p' $list >"$out/names"
set -- base zero unused weightless free euler heun ab4
number=0
while IFS= read -r effect; do
    number=$((number + 1))
    set -- "$@" effect_$number effect_$number.without
done <"$out/names"
for folder; do
    echo "$out/$folder"
done | xargs mkdir -p
for name in base euler heun ab4; do
    echo "$base_text" >"$out/$name/pendulum.scene"
done
object base
result $? "the base scene compiles"
for method in euler heun ab4; do
    object $method --method $method
done
# What is not there in the end costs nothing, whatever the text.
edited zero 's|axis z|axis z; damping 0 N*m*s/rad; spring 0 N*m/rad rest 10 deg|'
edited unused 's|^method rk4|&\nconstant resistance = 0.1 N*m*s/rad|'
edited weightless 's|^gravity.*|gravity (0, 0, 0) m/s^2|'
edited free '/^gravity/d'
# The scenes with each effect, as the table of costs has them.
PYTHONPATH=tools python3 -B -c '
import sys
from lab import cost
for number, (_, inside, statement) in enumerate(cost.listed_effects(), 1):
    with open(f"{sys.argv[1]}/effect_{number}/pendulum.scene", "w") as file:
        file.write(cost.with_effect(cost.PENDULUM.read_text(), inside, statement))' "$out"
number=0
while IFS= read -r effect; do
    number=$((number + 1))
    with effect_$number
done <"$out/names"
# shellcheck disable=SC2086
cksum $objects >"$out/sums"
# shellcheck disable=SC2086
arm-none-eabi-nm -S $objects >"$out/nm"

# Two states, six outputs, and the six that are published while one is not finite; a sine and a cosine, which outputs
# and the next step share.
holds "no effect" "prime range" 64 base
[ -z "$(arm-none-eabi-nm -u "$out/base/plant.o")" ]
result $? "no effect: the plant needs nothing of others"
same zero
result $? "damping and a spring of zero: the same object"
same unused
result $? "a constant that nothing uses: the same object"
sum weightless
weightless=$sum
sum free
[ -n "$sum" ] && [ "$sum" = "$weightless" ]
result $? "gravity of zero and none: the same object"
! same free
result $? "found: gravity"

number=0
while IFS= read -r effect; do
    number=$((number + 1))
    name=effect_$number
    sum "$name"
    [ -n "$sum" ] && ! same "$name"
    result $? "found: $effect"
    same "$name.without"
    result $? "commented out: the same object as without: $effect"
    case $effect in
    "damping, tunable") holds "$effect" "admit amiss defaults prime range" 72 "$name" ;;
    # The last sample, three differences, and whether there is one.
    "input, smooth") holds "$effect" "admit amiss prime range" 92 "$name" ;;
    "input, "*) holds "$effect" "admit amiss drive prime range" 72 "$name" ;;
    # An input and its last good value; that nobody drives: it is the port's.
    input) holds "$effect" "admit amiss prime range" 72 "$name" ;;
    # An angle that is kept within a turn has no range to be guarded, and no sine that is shared.
    continuous) holds "$effect" "" 64 "$name" ;;
    "continuous, output of turns") holds "$effect" "" 72 "$name" ;;
    "output of acceleration") holds "$effect" "prime range" 72 "$name" ;;
    "output of a point's velocity") holds "$effect" "prime range" 88 "$name" ;;
    # What rounding took of two states; three sums of derivatives of two states, and four words of progress.
    "compensated sums") holds "$effect" "prime range" 72 "$name" ;;
    "steps checked") holds "$effect" "derivative_by_sines iso_plant_tell derivative_prepared prime range" 104 "$name" ;;
    *) holds "$effect" "prime range" 64 "$name" ;;
    esac
done <"$out/names"
[ "$(grep -c . "$out/names")" -ge 8 ]
result $? "the list has its effects: $(grep -c . "$out/names")"

holds euler range 56 euler
holds heun "prime range" 64 heun
# Three older derivatives of two states.
holds "ab4, the method with a history" "prime range" 80 ab4
finish
