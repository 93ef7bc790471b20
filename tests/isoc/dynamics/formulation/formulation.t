#!/bin/sh
# All formulations of a tree, and of closed loops, say the same; and isoc keeps the one that takes least.
. tests/host/test.sh
. tests/isoc/dynamics/formulation/evaluation.sh
begin formulation
one_isoc
quick

# evaluation SCENE FORMULATION PLACE: the plant in the real of now.
evaluation()
{
    made=$3_$real
    isoc "$out/$made.summary" '' "$1" -o "$out/$made" --real "$real" --method rk4 --formulation "$2" &&
        as_evaluation "$made"
}

# both SCENE FORMULATION [SCENE [SOURCE]]: the program that compares a scene as composite bodies with this formulation
# of it, or of another scene.
both()
{
    with=${4-tests/isoc/dynamics/formulation/agree.c}
    objects=
    for real in float double; do
        real $real
        evaluation "$1" composite first && evaluation "${3-$1}" "$2" second || return 1
        for place in first second; do
            objects="$objects $out/${place}_$real.o"
        done
    done
    # shellcheck disable=SC2086
    program agree "$with" tests/host/report.c $objects
}

for kind in planar spatial; do
    for n in 3 8 16; do
        python3 tools/lab/chain.py $n $kind >"$out/${kind}_$n.scene"
    done
done

# written FILE: the scene is there; those of random rods and legs are written when they are first asked for.
written()
{
    case $1 in
    "$out"/rods_* | "$out"/legs_*)
        written_name=${1##*/}
        written_seed=${written_name#*_}
        [ -f "$1" ] || awk -v seed="${written_seed%.scene}" -f "tests/isoc/dynamics/formulation/${written_name%_*}.awk" >"$1"
        ;;
    esac
}

# kept SCENE FORMULATION: isoc keeps it in float.
kept()
{
    build/isoc "$1" -o "$out/chosen" --real float >"$out/summary" 2>&1 && grep -q "^formulation $2 kept" "$out/summary"
}

# rounds_alike: the formulation in $out/agree is off in float by no more than 4 times what composite bodies are.
rounds_alike()
{
    "$out/agree" | awk '/in float the first/ { sub(",", "", $9); found = 1; bad = $NF > 4 * $9 } END { exit !found || bad }'
}

# held SCENE FORMULATION: it says the same as composite bodies do.
held()
{
    written "$1"
    name=${1##*/}
    name=${name%.scene}
    both "$1" "$2"
    result $? "$name builds as composite and as $2"
    joined "$name, $2" "$out/agree"
    case $2 in
    legs*)
        ! kept "$1" "$2" || rounds_alike
        result $? "$name: in float, isoc keeps no $2 that round more"
        ;;
    esac
}

# Effects have the same equations in each.
rods=$(printf "$out/rods_%d.scene " 1 2 3 4 5 6 7 8 9)
legs=$(printf "$out/legs_%d.scene " 1 2 3 4 5 6 7 8)
for file in $(grep -L '^ *close \|^ *effect ' models/*.scene "$out"/planar_*.scene) $rods "$out"/spatial_*.scene; do
    held "$file" articulated
done
for file in models/stewart.scene $legs; do
    case $file in
    *stewart* | *[147].scene) held "$file" legs_in_child_axes ;;
    *[258].scene) held "$file" legs_in_parent_axes ;;
    *) held "$file" legs ;;
    esac
done
for file in models/four_bar.scene models/squeezer.scene tests/isoc/mechanism/slot.scene tests/isoc/scene/closures.scene; do
    held "$file" parent_axes
    held "$file" child_axes
done

sed 's/9\.81)/9.8100001)/' models/arm6.scene >"$out/heavier.scene"
both models/arm6.scene articulated "$out/heavier.scene" && ! "$out/agree" >"$out/tap" && grep -q '^not ok 2' "$out/tap"
result $? "found: gravity off by 1e-8 of itself"

# A leg that is stretched, where the elimination leg by leg divides by nearly nothing.
sed 's/bend = 0.8 rad/bend = 0 rad/' tests/isoc/dynamics/formulation/stretched.scene >"$out/straight.scene"
sed 's/mass 2 kg/mass 2.0001 kg/' tests/isoc/dynamics/formulation/stretched.scene >"$out/heavier_plate.scene"
for formulation in legs legs_in_parent_axes legs_in_child_axes; do
    both "$out/straight.scene" $formulation tests/isoc/dynamics/formulation/stretched.scene tests/isoc/dynamics/formulation/stretched.c
    result $? "a stretched leg builds as $formulation"
    joined "a stretched leg, $formulation" "$out/agree"
done
both "$out/straight.scene" legs "$out/heavier_plate.scene" tests/isoc/dynamics/formulation/stretched.c && ! "$out/agree" >"$out/tap" &&
    [ "$(grep -c '^not ok [23]' "$out/tap")" -eq 2 ]
result $? "found: a plate heavier by 5e-5 of itself"

# verdict KEPT SCENE: isoc keeps this formulation, and it takes least, a division for 14 others.
verdict()
{
    isoc "$out/summary" '' "$2" -o "$out/chosen" && awk -v wanted="$1" '
        $1 == "formulation" && $3 == "kept" { kept = $5 + $7 + 14 * $9; name = $2 }
        $1 == "formulation" && $3 == "left" { cost = $5 + $7 + 14 * $9; left = left == "" || cost < left ? cost : left }
        $1 == "derivative" { used = $3 + $5 + 14 * $7 }
        END { exit !(name == wanted && kept <= left && kept == used) }' "$out/summary"
}

verdict composite models/arm6.scene
result $? "an arm of six joints is composite"
verdict articulated "$out/planar_16.scene"
result $? "a planar chain of 16 is articulated"
verdict articulated "$out/spatial_16.scene"
result $? "a spatial chain of 16 is articulated"
verdict child_axes models/four_bar.scene
result $? "the closure of a four-bar stands in the axes of its coupler"
verdict legs_in_child_axes models/stewart.scene
result $? "the closures of a Stewart platform are eliminated leg by leg"
written "$out/legs_7.scene"
verdict legs "$out/legs_7.scene"
result $? "those of four legs with knees too"
verdict parent_axes "$out/straight.scene"
result $? "and not those of a leg that is stretched at the start"

# The projection divides by factors of the last stage of a step; its gaps are those of the end, also where a factor is a
# part of a gap, as the sine of an arm is here. So what a step leaves is the square of its local error: less than 8 ulp
# of a meter.
real double
{ cat tests/core/methods/order/governor.scene && echo 'output gap = violation'; } >"$out/governor.scene"
isoc "$out/summary" '' "$out/governor.scene" -o "$out/plant" --real double &&
    EXTRA="-I$out/plant" program rows tests/isoc/effects/laws/rows.c "$out/plant/plant.c" && "$out/rows" 500 |
    awk '$NF > largest { largest = $NF } END { print "# " largest " m"; exit !(NR == 501 && largest < 8 * 2 ^ -52) }'
result $? "a step of the governor closes its loops to rounding"

# refused SCENE FORMULATION: isoc makes no such plant.
refused()
{
    ! build/isoc "$1" -o "$out/none" --formulation "$2" >"$out/summary" 2>&1 && grep -q 'no such formulation' "$out/summary" &&
        [ ! -e "$out/none" ]
}

refused models/four_bar.scene articulated
result $? "a closed loop is not articulated"
refused models/four_bar.scene legs
result $? "one closure has no legs"
refused models/arm6.scene child_axes
result $? "a tree has no closures"
finish
