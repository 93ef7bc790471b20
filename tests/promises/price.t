#!/bin/sh
# Absence costs nothing: a scene without an effect (isoc --without) gives the bytes of an isoc whose library lacks it.
# (What each effect costs: tests/tools/lab/test_price.py.)
. tests/host/test.sh
begin check/price
one_isoc

scene=tests/isoc/effects/price.scene
objects=$(find build/obj/tools/isoc -maxdepth 1 -name '*.o' ! -name '*_files.o')

# lacking NAME KIND...: $out/NAME/isoc, whose library has not the files of these kinds.
lacking()
{
    mkdir -p "$out/$1"
    lacking_name=$1
    shift
    files=$(ls models/effects/*.scene)
    for kind; do
        files=$(echo "$files" | grep -v "/$kind\.scene$")
    done
    # shellcheck disable=SC2086
    awk -f tools/build/embed.awk effect_files $files >"$out/$lacking_name/effect_files.c" &&
        $CC -std=c11 -I. -c "$out/$lacking_name/effect_files.c" -o "$out/$lacking_name/effect_files.o" &&
        $CC $objects build/obj/tools/isoc/core_files.o build/obj/tools/isoc/client_files.o build/obj/tools/isoc/help_files.o "$out/$lacking_name/effect_files.o" -o "$out/$lacking_name/isoc" -lm
}

# written NAME SED: the scene, edited, and its plant by an isoc that lacks what is left out, in $out/NAME.
written()
{
    sed "$2" $scene >"$out/$1/price.scene" && ! cmp -s $scene "$out/$1/price.scene" &&
        "$out/$1/isoc" "$out/$1/price.scene" -o "$out/$1/written" >"$out/$1/written.txt"
}

# left NAME EFFECTS: its plant without these effects.
left()
{
    isoc "$out/$1/left.txt" '' $scene -o "$out/$1/left" --without "$2"
}

same()
{
    cmp -s "$out/$1/$2/plant.c" "$out/$1/$3/plant.c" && cmp -s "$out/$1/$2/plant.h" "$out/$1/$3/plant.h"
}

# absent EFFECT KIND SED
absent()
{
    lacking "$1" "$2" && ! "$out/$1/isoc" $scene -o "$out/$1/none" 2>"$out/$1/errors" >"$out/$1/none.txt" &&
        grep -q "no effect of the kind '$2' is defined" "$out/$1/errors"
    result $? "found: an isoc that lacks $2"
    written "$1" "$3" && left "$1" "$1" && { [ "$counts_alone" = yes ] || same "$1" written left; } &&
        cmp -s "$out/$1/written.txt" "$out/$1/left.txt"
    result $? "without $1: the $([ "$counts_alone" = yes ] && echo counts || echo bytes) of an isoc that lacks $2"
    ! cmp -s "$out/$1/left/plant.c" "$out/whole/plant.c"
    result $? "found: $1"
}

isoc "$out/whole.txt" '' $scene -o "$out/whole"
result $? "the scene compiles"
[ "$(build/isoc $scene --effects | tr '\n' ' ')" = "drive dc_motor sense current_sense bearing friction ends stop slow lag " ]
result $? "isoc lists its effects"
lost='/^output lost/s/.*//; /^signal loss/s/.*//'
counts_alone=no
absent drive dc_motor "/^effect drive/s/.*//; /^at 2 s/s/.*//; /^output current/s/.*//; $lost; s/drive\.current/0 A/"
absent sense current_sense '/^effect sense/s/.*//; /^output measured/s/.*//'
absent bearing friction "/^effect bearing/s/.*//; /^output shaken/s/.*//; $lost"
absent ends stop '/^effect ends/s/.*//'
# Others read the lag, whose state has its dimension by what it reads: that can stand at another place.
counts_alone=yes
absent slow lag '/^effect slow/s/.*//; /^output slow/s/.*//; s|slow\.value|0 m/s|'
sed 's/^output wanted.*//; s/^signal bare.*//' $scene >"$out/unread.scene"
isoc "$out/unread.txt" '' "$out/unread.scene" -o "$out/unread" --without 'drive' && grep -qx 'inputs 1' "$out/unread.txt"
result $? "an input that only the effect reads is left out with it"
sed '/^output/{/measured/!d;}' $scene >"$out/measured.scene"
isoc "$out/measured.txt" '' "$out/measured.scene" -o "$out/measured" --without 'drive; sense' &&
    grep -qx 'outputs 1' "$out/measured.txt" && grep -q 'y\[PLANT_Y_MEASURED\] = R(0' "$out/measured/plant.c"
result $? "of a scene that shows nothing else, an output stays, and is zero"
lacking all dc_motor current_sense friction stop lag &&
    written all '/^effect/s/.*//; /^at/s/.*//; /^signal [sl]/s/.*//; /^output [lms]/s/.*//; /^output current/s/.*//' &&
    left all 'drive; sense; bearing; ends; slow' && same all written left
result $? "without any: the bytes of an isoc that lacks all of them"

# Every kind of the library, an eighth by turns: an isoc that lacks it refuses the models that use it, and writes the
# others to the same bytes of plant, which is all that firmware follows from.
turn=$(turn_of 8 "${1-}")
echo "# turn $turn of the kinds of effects"
models='pendulum dc_motor_bench quarter_car cart_pole_drive hopper crane'
for model in $models; do
    isoc "$out/models.txt" '' "models/$model.scene" -o "$out/models/$model"
done
number=0
for kind in $(ls models/effects | sed 's/[.]scene$//'); do
    number=$((number + 1))
    [ "$turn" = all ] || [ $((number % 8)) -eq "$turn" ] || continue
    lacking rest "$kind"
    used='' equal=''
    for model in $models; do
        if "$out/rest/isoc" "models/$model.scene" -o "$out/rest/$model" >"$out/rest.txt" 2>"$out/errors"; then
            cmp -s "$out/rest/$model/plant.c" "$out/models/$model/plant.c" &&
                cmp -s "$out/rest/$model/plant.h" "$out/models/$model/plant.h" && equal="$equal $model"
        elif grep -q "no effect of the kind '$kind' is defined" "$out/errors"; then
            used="$used $model"
        fi
    done
    [ "$(echo $equal $used | wc -w)" -eq 6 ] && [ -n "$equal" ]
    result $? "without $kind: the same bytes of$equal${used:+; refused:$used}"
done

# refused WITHOUT PATTERN
refused()
{
    cp "$out/whole/plant.c" "$out/before.c"
    ! isoc "$out/output" "$out/errors" $scene -o "$out/whole" --without "$1" && grep -q -e "$2" "$out/errors" &&
        cmp -s "$out/before.c" "$out/whole/plant.c"
    result $? "refused: --without '$1'"
}
refused drve "^--without:1:1: error: no effect is called 'drve' (did you mean 'drive'?)$"
refused 'drive ends' "^--without:1:7: error: expected ; and a further effect; found 'ends'$"
refused 'drive; 3' "^--without:1:8: error: expected the name of an effect; found '3'$"
finish
