#!/bin/sh
# Nothing in a step branches, loops or indexes on state, input or parameter: memcheck says so with all of them marked
# undefined, for every scene and the plant written by hand, with each method, in float and in double.
. tests/host/test.sh
begin check/poison

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

for real in float double; do
    flag=$([ $real = double ] && echo -DISO_REAL_DOUBLE)
    for method in euler heun rk4 ab4; do
        upper=$(echo $method | tr a-z A-Z)
        examine "oscillator, $method, $real" models/oscillator.c "-DISO_METHOD=ISO_$upper" $flag
        for scene in models/*.scene; do
            name=$(basename "$scene" .scene)
            build/isoc "$scene" -o "$out/$name" --method $method --real $real >/dev/null
            examine "$name, $method, $real" "$out/$name/plant.c" $flag
        done
    done
done

# planted KIND NAME TEST: memcheck finds it, in the test of that number and no other.
planted()
{
    for method in EULER HEUN RK4 AB4; do
        build tests/check/planted_plant.c "-DPLANTED=$1" "-DISO_METHOD=ISO_$method" && watch >"$out/tap"
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
