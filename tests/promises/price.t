#!/bin/sh
# tools/isochron cost ...: what each effect of a scene costs and changes. Each row is the difference to the scene in
# which the statement of the effect is not written. And absence costs nothing: a scene without an effect gives the bytes
# of an isoc whose library lacks it.
. tests/host/test.sh
. tests/host/project.sh
begin check/price
one_isoc

# --- isoc --without ---

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
turn=$(turn_of 8 "${1-}" models tools/isoc)
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

# --- isochron cost ---

project
cat >"$out/project/sleds.scene" <<'END'
# Two sleds that do not know of each other.
step 1 ms
method rk4
body first { mass 1 kg }
body second { mass 2 kg }
joint left prismatic { parent ground; child first; axis x; speed 1 m/s; spring 40 N/m }
joint right prismatic { parent ground; child second; axis x; speed 2 m/s; spring 30 N/m }
effect rub friction { along left; sliding 0.3 N }
effect count counter { what speed of right }
effect counter {
    signal what
    memory sum = 0
    next sum = sum + what / 1 m * 1 s
    output sum
}
output left = position of left
output right = position of right
output sum = count.sum
END
isochron cost sleds.scene --seconds 0.2
expect $? "isochron cost ... prints its tables"
cp "$out/output" "$out/tables"
folder=$(sed -n 's|/effects.tsv$||p' "$out/tables")
table=$out/project/$folder/effects.tsv
grep -q '^| rub, friction |' "$out/tables" && grep -q '^| count, counter |' "$out/tables" && [ -s "$table" ] &&
    [ -s "$out/project/$folder/effects.svg" ] && [ -s "$out/project/$folder/effects.png" ]
result $? "a row for each effect, a table and pictures"

# cell TABLE ROW COLUMN: of the row of an effect, or of base, sum or whole.
cell()
{
    awk -F '\t' -v row="$2" -v column="$3" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == column) at = i; next }
        ($1 == row || ($1 == "" && $2 == row)) && at { print $at; n++ } END { exit n != 1 }' "$1"
}

# adds TABLE: the effects do not know of each other: base and sum are the whole, in all that is counted without a
# compiler.
adds()
{
    awk -F '\t' '
        NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
        { row = $1 == "" ? $2 : $1; for (i = 1; i <= NF; i++) cell[row, i] = $i }
        END {
            count = split("add mul div sincos states memories", column, " ")
            for (c = 1; c <= count; c++) {
                i = at[column[c]]
                sum = cell["sum", i]
                if (sum == "" || cell["rub", i] + cell["count", i] != sum || cell["base", i] + sum != cell["whole", i]) exit 1
            }
        }' "$1"
}
adds "$table"
result $? "effects that do not know of each other: base and sum are the whole"
awk -F '\t' -v OFS='\t' '$1 == "rub" { $3++ } 1' "$table" >"$out/planted.tsv"
! adds "$out/planted.tsv"
result $? "found: an operation too many"
[ "$(cell "$table" rub add)" -gt 0 ] && [ "$(cell "$table" count memories)" -eq 1 ] && [ "$(cell "$table" count step)" -eq 0 ] &&
    [ "$(cell "$table" count tick)" -gt 0 ]
result $? "friction stands in the step, a counter in the tick"

# drawn TABLE: the numbers at the bars of the picture are those of the table.
drawn()
{
    awk -F '\t' '
        FNR == NR && FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
        FNR == NR { for (i = 1; i <= NF; i++) cell[$1, i] = $i; next }
        { for (; match($0, /> [^<]*</); $0 = substr($0, RSTART + RLENGTH)) drawn = drawn " " substr($0, RSTART + 2, RLENGTH - 3) }
        END {
            count = split("step tick text memory", column, " ")
            for (c = 1; c <= count; c++) wanted = wanted " " cell["rub", at[column[c]]] " " cell["count", at[column[c]]]
            wanted = wanted sprintf(" %.3g %.3g", 100 * cell["rub", at["part"]], 100 * cell["count", at["part"]])
            gsub(/ +/, " ", drawn)
            sub(/ $/, "", drawn)
            exit drawn != wanted
        }' "$1" "$out/project/$folder/effects.svg"
}
drawn "$table"
result $? "the picture shows the numbers of the table"
awk -F '\t' -v OFS='\t' '$1 == "count" { $8++ } 1' "$table" >"$out/planted.tsv"
! drawn "$out/planted.tsv"
result $? "found: another number in the picture"

# The same counts of a scene in which the effect is not written.
sed '/^effect rub/s/.*//' "$out/project/sleds.scene" >"$out/project/smooth.scene"
isochron run smooth.scene --seconds 0.2 --target cortex-m4f --out build/smooth
expect $? "a scene without friction runs"
read_value instructions_per_step && without=$value
whole=$(cell "$table" whole step)
[ "$(cell "$table" rub step)" -eq $((whole - without)) ]
result $? "the row is the difference: $whole less $without instructions"

# changed TABLE COLUMN: what the table has for the output left, and the same from the two traces.
changed()
{
    given=$(cell "$1" rub "left_$2") && paste -d , "$out/project/$folder/cortex-m4f-float/whole/trace.csv" \
        "$out/project/build/smooth/trace.csv" | awk -F , -v kind="$2" -v given="$given" '
            NR == 1 { half = NF / 2; for (i = 2; i <= half; i++) at = $i == "left" ? i : at
                for (i = half + 1; i <= NF; i++) other = $i == "left" ? i : other; next }
            { d = $at - $other; squares += d * d; n++; size = d < 0 ? -d : d; most = size > most ? size : most }
            END { made = kind == "rms" ? sqrt(squares / n) : most; off = made - given
                exit !(made > 0 && off * off < 1e-16 * made * made) }'
}
changed "$table" rms && changed "$table" largest
result $? "the change of an output is the difference of the two runs"
awk -F '\t' -v OFS='\t' 'NR == 1 { for (i = 1; i <= NF; i++) at = $i == "left_rms" ? i : at } $1 == "rub" { $at *= 1.001 } 1' \
    "$table" >"$out/planted.tsv"
! changed "$out/planted.tsv" rms
result $? "found: another change"
[ "$(cell "$table" rub right_largest)" = 0 ] && [ "$(cell "$table" count left_largest)" = 0 ] && [ -z "$(cell "$table" count sum_rms)" ]
result $? "an output that does not know of an effect does not change; its own is gone"

! isochron cost models/pendulum.scene && grep -q 'models/pendulum.scene has no effect' "$out/errors"
expect $? "told: a scene without effects"
! isochron cost sleds.scene --parts models && grep -q 'PARTS has no effect on .isochron cost SCENE' "$out/errors"
expect $? "told: PARTS of one scene"
! isochron cost models/oscillator.c && grep -q 'isochron cost is of scenes' "$out/errors"
expect $? "told: a plant in C"
finish
