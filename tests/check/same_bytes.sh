#!/bin/sh
# The same scene gives the same bytes of C, whichever compiler built isoc.
. tests/host/test.sh
begin check/same_bytes

# built NAME SOURCE...: isoc built with clang, as $out/NAME.
built()
{
    built_name=$1
    shift
    clang -std=c11 -O0 -ffp-contract=off -fno-math-errno -D_POSIX_C_SOURCE=200809L -DISO_REAL_DOUBLE -I. "$@" \
        -o "$out/$built_name" -lm
}

# bytes ISOC SCENE: all that it writes; rosenbrock, since its plants have the Jacobian too.
bytes()
{
    rm -rf "$out/plant"
    "$1" "$2" -o "$out/plant" --method rosenbrock && cat "$out/plant/plant.h" "$out/plant/plant.c"
}

# same ISOC SCENE: $out/ISOC writes what build/isoc writes.
same()
{
    bytes build/isoc "$2" >"$out/expected" && bytes "$out/$1" "$2" >"$out/bytes" && cmp -s "$out/expected" "$out/bytes"
}

built isoc tools/isoc/*.c
result $? "clang builds isoc"
for scene in models/*.scene tests/scenes/*.scene; do
    same isoc "$scene"
    result $? "$scene: the same bytes from an isoc built with clang"
done
for kind in projection lagrangian; do
    { cat tests/scenes/closures.scene && echo "stabilisation $kind"; } >"$out/$kind.scene"
    same isoc "$out/$kind.scene"
    result $? "closures held by $kind: the same bytes"
done

sed 's/const node ab = mul(g, a, b), cd = mul(g, c, d);/const node cd = mul(g, c, d), ab = mul(g, a, b);/' \
    tools/isoc/graph.c >"$out/graph.c"
# shellcheck disable=SC2046
built planted "$out/graph.c" $(ls tools/isoc/*.c | grep -v /graph.c) && ! cmp -s tools/isoc/graph.c "$out/graph.c" &&
    ! same planted models/double_pendulum.scene && [ -s "$out/bytes" ]
result $? "found: products made in another order"
finish
