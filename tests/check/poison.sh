#!/bin/sh
# Nothing in a step branches, loops or indexes on state, input or parameter: memcheck says so with all of them marked
# undefined, for every scene and the plant written by hand, with each method, in float and in double.
. tests/host/test.sh
begin check/poison
METHODS=$(build/isoc --methods | sed -n 's/^| \([a-z0-9_]*\) | [0-9] |.*/\1/p')

# build PLANT FLAG...: makes $out/program of the plant.
build()
{
    rm -f "$out/program"
    # shellcheck disable=SC2086
    $CC $FLAGS -g tests/check/poison.c "$@" -o "$out/program"
}

watch()
{
    valgrind --quiet "$out/program" 2>"$out/errors"
}

# examine NAME PLANT FLAG...: the plant's step is free of data.
examine()
{
    name=$1
    shift
    if build "$@"; then
        joined "$name" watch
    else
        result 1 "$name: builds"
    fi
}

# generated SCENE METHOD REAL FLAG...: the plant of a scene.
generated()
{
    name=$(basename "$1" .scene)
    build/isoc "$1" -o "$out/$name" --method "$2" --real "$3" >/dev/null
    scene=$1
    method=$2
    real=$3
    shift 3
    examine "$(basename "$scene" .scene), $method, $real" "$out/$name/plant.c" "$@"
}

# Every method on every model; in double, and with a check and compensation, on one that has all kinds of joints.
for method in $METHODS; do
    upper=$(echo "$method" | tr a-z A-Z)
    for scene in models/*.scene; do
        generated "$scene" "$method" float
    done
    generated models/tree.scene "$method" double -DISO_REAL_DOUBLE
    { cat models/tree.scene && printf 'checked yes\ncompensated yes\n'; } >"$out/tree_checked.scene"
    generated "$out/tree_checked.scene" "$method" float
    examine "oscillator, $method, float" models/oscillator.c "-DISO_METHOD=ISO_$upper"
    examine "oscillator, $method, checked and compensated, double" models/oscillator.c \
        "-DISO_METHOD=(ISO_$upper|ISO_CHECKED|ISO_COMPENSATED)" -DISO_REAL_DOUBLE
done

# planted KIND NAME TEST: memcheck finds it, in the test of that number and no other.
planted()
{
    for method in EULER RK4 AB4 ABM4 BDF4 ROSENBROCK; do
        build tests/check/planted_plant.c "-DPLANTED=$1" "-DISO_METHOD=ISO_$method" -DISO_METHOD_NAME=any && watch >"$out/tap"
        [ "$(sed -n 's/^not ok \([0-9]*\) .*/\1/p' "$out/tap" | paste -sd ' ')" = "$3" ] && grep -qx 1..3 "$out/tap"
        result $? "$method: $2"
    done
}

planted NOTHING "the plant that the violations are planted in is clean" ""
planted BRANCH "found: a branch on the state" 2
planted INDEX "found: an index from the state" 2
planted LOOP "found: a loop count from the state" 2
planted OUTPUT "found: a branch on the state in the outputs" 3
finish
