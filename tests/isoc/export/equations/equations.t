#!/bin/sh
# What `isoc --equations` writes, as text, gives the accelerations, corrections, memories, outputs and functions of time
# of the plant, to a bound of the rounding (compare.py): all models and ten random scenes, in double. As LaTeX it says
# the same equations, with other names one to one, and all that it opens it closes.
. tests/host/test.sh
begin equations
one_isoc
quick

# documents SCENE FOLDER REAL: both, in that folder.
documents()
{
    mkdir -p "$2"
    for style in text latex; do
        isoc /dev/null "$out/said" "$1" --equations $style --real "$3" -o "$2/$style" || return 1
    done
}

# The calls of what plant.c has for corrections, and for the next values of memories.
calls='
    /^static void tune\(/ { held = "tune(h, p->p), " }
    /^static void hold\(/ { held = held "hold(h, p->u), " }
    /^static void settle\(/ {
        settle = "settle(p->x" (/const u[,)]/ ? ", p->u" : "") (/const p[,)]/ ? ", p->p" : "") (/pivots/ ? ", kept" : "") (/sines/ ? ", kept_at(p, " (held ? "(" held "h)" : "p->p") ")" : "") ")"
    }
    /^static void (follow|advance)\(/ { nexts = nexts == "" ? substr($3, 1, index($3, "(") - 1) "(p->memory)" : nexts }
    END {
        flags = "-DSETTLE=" settle " -DNEXTS=" nexts
        gsub(/, /, ",", flags)
        print flags
    }'

# values FOLDER: what its plant computes at three points.
values()
{
    EXTRA="-DPLANT=\"$1/plant.c\" $(awk "$calls" "$1/plant.c")" program values tests/isoc/export/equations/values.c &&
        "$out/values" 3 1 >"$1/values"
}

# tried SCENE NAME: the documents of a scene against its plant.
tried()
{
    documents "$1" "$out/$2" double && isoc "$out/summary" "$out/said" "$1" -o "$out/$2" --real double &&
        values "$out/$2" && python3 -B tests/isoc/export/equations/compare.py "$out/$2/text" "$out/$2/latex" "$out/$2/values" >"$out/found"
    tried_status=$?
    {
        IFS= read -r found
        result $tried_status "$2: $found"
        while IFS= read -r found; do
            echo "$found"
        done
    } <"$out/found"
}

for file in models/*.scene; do
    name=${file##*/}
    tried "$file" "${name%.scene}"
done
for seed in 1 2 3 4 5 6 7 8 9 10; do
    python3 tests/promises/random/write_scene.py "$seed" >"$out/random.scene"
    tried "$out/random.scene" "seed_$seed"
done

# Controls. Each sign between two terms of the derivatives of a closed loop, turned in the text, is found in the numbers
# and beside the LaTeX; so is what is open or missing there.
[ -d "$out/four_bar" ] || tried models/four_bar.scene four_bar
python3 -B tests/isoc/export/equations/compare.py "$out/four_bar/text" "$out/four_bar/latex" "$out/four_bar/values" planted >"$out/found"
result $? "found: each turned sign, by the numbers and beside the LaTeX: $(paste -sd ' ' "$out/found")"
# planted WHAT SAID SED: the LaTeX that is changed so is refused, with these words.
planted()
{
    sed "$3" "$out/four_bar/latex" >"$out/latex"
    ! cmp -s "$out/latex" "$out/four_bar/latex" &&
        ! python3 -B tests/isoc/export/equations/compare.py "$out/four_bar/text" "$out/latex" "$out/four_bar/values" >"$out/found" &&
        grep -q " 0 off $2" "$out/found"
    result $? "found: $1"
}
planted 'a brace that is open' 'something is open' '0,/}\$\\par/s//$\\par/'
planted 'a name that is another' 'another equation of' '0,/= t_{1} /s//= t_{2} /'
planted 'an equation that is missing' 'more or fewer equations' '0,/^\$.displaystyle/{//d}'

# What cannot be asked for.
! isoc /dev/null "$out/said" models/pendulum.scene --equations html && grep -q 'must be text or latex, not html' "$out/said" &&
    ! isoc /dev/null "$out/said" models/pendulum.scene --equations text -o "$out/four_bar" && grep -q 'directory' "$out/said"
result $? 'another form, and a folder in the place of a file, are refused'
build/isoc models/four_bar.scene --equations latex --real double 2>"$out/said" | cmp - "$out/four_bar/latex"
result $? 'standard output has what a file has'
finish
