#!/bin/sh
# The same scene gives the same bytes of C, whichever compiler built isoc.
. tests/host/test.sh
begin check/same_bytes
one_isoc

# compiled SOURCE...: objects of it by clang, in $out/objects, without optimisation: it compiles for longer than it
# saves here. The kernels stay rolled, as make has them.
mkdir -p "$out/objects"
compiled()
{
    for source in "$@"; do
        object=${source##*/}
        clang -std=c11 -O0 $NUMERICS -D_POSIX_C_SOURCE=200809L -DISO_REAL_DOUBLE -DISO_UNROLL= -I. \
            -c "$source" -o "$out/objects/${object%.c}.o" || return 1
    done
}

# linked PROGRAM: of all objects.
linked()
{
    clang "$out"/objects/*.o -o "$1" -lm
}

# same ISOC SCENE [METHOD]: $out/ISOC writes what build/isoc writes; by rosenbrock, since its plants have the Jacobian
# too.
same()
{
    rm -rf "$out/expected" "$out/plant"
    isoc "$out/summary" "$out/errors" "$2" -o "$out/expected" --method "${3-rosenbrock}" &&
        "$out/$1" "$2" -o "$out/plant" --method "${3-rosenbrock}" >"$out/summary" 2>"$out/errors" &&
        diff -r "$out/expected" "$out/plant" >"$out/found"
}

# shellcheck disable=SC2046
compiled tools/isoc/*.c $(isoc_parts c) && linked "$out/isoc"
result $? "clang builds isoc"
with_events=" $(grep -l '^ *when ' models/*.scene tests/isoc/scene/*.scene | tr '\n' ' ')"
with_residual=" $(grep -l residual models/*.scene tests/isoc/scene/*.scene | tr '\n' ' ')"
for scene in models/*.scene tests/isoc/scene/*.scene tests/isoc/mechanism/*.scene; do
    case $with_residual in
    *" $scene "*) same isoc "$scene" bdf4 ;;
    *)
        case $with_events in
        *" $scene "*) same isoc "$scene" rk4 ;;
        *) same isoc "$scene" ;;
        esac
        ;;
    esac
    result $? "$scene: the same bytes from an isoc built with clang"
done
for kind in projection lagrangian; do
    { cat tests/isoc/scene/closures.scene && echo "stabilisation $kind"; } >"$out/$kind.scene"
    same isoc "$out/$kind.scene" rk4
    result $? "closures held by $kind: the same bytes"
done

sed 's/const node ab = mul(g, a, b), cd = mul(g, c, d);/const node cd = mul(g, c, d), ab = mul(g, a, b);/' \
    tools/isoc/graph/graph.c >"$out/other.c"
sed "s|tools/isoc/graph/graph.c|$out/other.c|" build/obj/tools/isoc/graph.c >"$out/graph.c"
! cmp -s tools/isoc/graph/graph.c "$out/other.c" && compiled "$out/graph.c" && linked "$out/planted" &&
    ! same planted models/double_pendulum.scene && [ -s "$out/found" ]
result $? "found: products made in another order"
finish
