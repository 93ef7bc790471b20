#!/bin/sh
# Trees in both formulations: they say the same, and isoc keeps the one that takes less.
. tests/host/test.sh
begin formulation

# evaluation SCENE FORMULATION: the plant in the real of now, as an object; without optimisation, which changes no bit.
evaluation()
{
    made=$2_$real
    build/isoc "$1" -o "$out/$made" --real "$real" --method rk4 --formulation "$2" >"$out/$made.summary" &&
        "$CC" $FLAGS $REAL_FLAG -O0 -c "$out/$made/plant.c" -o "$out/$made.plant.o" &&
        objcopy --redefine-sym "iso_the_plant_$real=${made}_plant" "$out/$made.plant.o" &&
        "$CC" $FLAGS $REAL_FLAG "-DPLANT=${made}_plant" "-DEVALUATION=$made" -c tests/formulation/evaluation.c -o "$out/$made.o"
}

# both SCENE [ARTICULATED]: the program that compares the two formulations of a scene, or of two scenes.
both()
{
    objects=
    for real in float double; do
        real $real
        evaluation "$1" composite && evaluation "${2-$1}" articulated || return 1
        for chosen in composite articulated; do
            objects="$objects $out/${chosen}_$real.o $out/${chosen}_$real.plant.o"
        done
    done
    # shellcheck disable=SC2086
    program agree tests/formulation/agree.c tests/host/report.c $objects
}

for kind in planar spatial; do
    for n in 3 8 16; do
        sh tools/build/chain.sh $n $kind >"$out/${kind}_$n.scene"
    done
done
for file in models/*.scene tests/*/*.scene "$out"/*.scene; do
    name=$(basename "$file" .scene)
    if ! grep -q '^close ' "$file"; then
        both "$file"
        result $? "$name builds in both formulations"
        joined "$name" "$out/agree"
    fi
done

sed 's/9\.81)/9.8100001)/' models/arm6.scene >"$out/heavier.scene"
both models/arm6.scene "$out/heavier.scene" && ! "$out/agree" >"$out/tap" && grep -q '^not ok 2' "$out/tap"
result $? "found: gravity off by 1e-8 of itself"

# verdict KEPT SCENE: isoc keeps this formulation, and it takes less than the other, a division for 14 others.
verdict()
{
    build/isoc "$2" -o "$out/chosen" >"$out/summary" && awk -v wanted="$1" '
        $1 == "formulation" && $3 == "kept" { kept = $5 + $7 + 14 * $9; name = $2 }
        $1 == "formulation" && $3 == "left" { left = $5 + $7 + 14 * $9 }
        $1 == "derivative" { used = $3 + $5 + 14 * $7 }
        END { exit !(name == wanted && kept <= left && kept == used) }' "$out/summary"
}

verdict composite models/arm6.scene
result $? "an arm of six joints is composite"
verdict articulated "$out/planar_16.scene"
result $? "a planar chain of 16 is articulated"
verdict articulated "$out/spatial_16.scene"
result $? "a spatial chain of 16 is articulated"
build/isoc tests/order/four_bar.scene -o "$out/chosen" >"$out/summary" && grep -q '^formulation composite only$' "$out/summary"
result $? "a closed loop is composite, without a choice"
! build/isoc tests/order/four_bar.scene -o "$out/none" --formulation articulated >"$out/summary" 2>&1 && [ ! -e "$out/none" ]
result $? "and is not made otherwise"
finish
