#!/bin/sh
# Where every method is stable, in float and in double; and that isoc knows it, from the kernels.
. tests/host/test.sh
begin stability
rolled
optimised -O1

for type in float double; do
    real $type
    program $type.run tests/isoc/stability/stability.c tests/isoc/stability/theory.c tests/host/report.c
    result $? "$type builds"
    joined $type "$out/$type.run"
done

# derived NAME: what isoc derives from the kernels.
derived()
{
    program "$1" tests/isoc/stability/growth.c tests/isoc/stability/theory.c tools/isoc/method/growth.c \
        tools/isoc/method/step_map.c tools/isoc/base/eigenvalues.c tools/isoc/base/least_squares.c tools/isoc/base/arena.c tests/host/report.c
}
real double
optimised -O0
derived growth
result $? "growth builds"
joined growth "$out/growth"

# broken FILE FROM TO METHOD: with this kernel changed, the growth of this method is not the published one.
broken()
{
    mkdir -p "$out/broken"
    cp -R core "$out/broken/"
    sed "s/$2/$3/" "core/methods/$1" >"$out/broken/core/methods/$1"
    ! cmp -s "core/methods/$1" "$out/broken/core/methods/$1" &&
        (FLAGS="-I$out/broken $FLAGS" && derived broken.run) &&
        ! "$out/broken.run" >"$out/broken.tap" && grep -q "^not ok .* $4: the growth of its kernel" "$out/broken.tap"
    result $? "control: the growth of $4 with $3 in $1 is noticed"
    rm -rf "$out/broken" "$out/broken.run"
}
broken ab4.h '{55, -59, 37, -9}' '{55, -58, 37, -9}' ab4
broken bdf4.h '{23, -13, 3}' '{23, -13, 4}' bdf4
broken rosenbrock.h 'c32 = ISO_SCALAR(9.2' 'c32 = ISO_SCALAR(9.3' rosenbrock
finish
