#!/bin/sh
# Random mechanisms, 40 trees and 40 closed loops, of all kinds of joints and closures, in every formulation and with every
# way to the factors of an implicit method, in double: reactions, Jacobian and orders.
. tests/host/test.sh
begin dynamics_family
one_isoc
. tests/dynamics/solver.sh
seeds=40

EXTRA=-O1
# shellcheck disable=SC2086
program generate.o -c tests/dynamics/generate.c &&
    program write_scene tests/dynamics/write_scene.c "$out/generate.o" $solver
result $? "the generator builds"

# formulation_of KIND SEED: by turns, each with every kind of joint.
formulation_of()
{
    case $1 in
    tree) set -- "$2" composite articulated ;;
    loop) set -- "$2" composite parent_axes child_axes ;;
    esac
    turn=$((($1 - 1) / 8 + 1))
    shift
    shift $((turn % $#))
    echo "$1"
}

# factors_of KIND SEED: how an implicit method's are found, by turns; those of loops in one way only.
factors_of()
{
    case $1$(($2 % 3)) in
    tree0) echo sparse ;;
    tree1) echo looped ;;
    *) echo full ;;
    esac
}

# member KIND SEED: its plant, with its equations in reach.
member()
{
    name=$1_$2
    method=$([ $(($2 / 2 % 2)) -eq 0 ] && echo bdf4 || echo rosenbrock)
    "$out/write_scene" "$1" "$2" >"$out/$name.scene" || return
    isoc "$out/$name.summary" "$out/$name.messages" "$out/$name.scene" -o "$out" --name "$name" --real double --method "$method" \
        --formulation "$(formulation_of "$1" "$2")" --factors "$(factors_of "$1" "$2")" || {
        cat "$out/$name.messages"
        return 1
    }
    settle=
    if grep -q '^static void settle' "$out/$name.c"; then
        pivots=$(pivots_in "$out/$name.c")
        settle="settle(x$(grep -q '^static void settle.*\bu[,)]' "$out/$name.c" && echo ', memory.u')$(grep -q '^static void settle.*\bp[,)]' "$out/$name.c" && echo ', p')${pivots:+, pivots});"
        ! grep -q 'iterations 2' "$out/$name.scene" || settle="$settle $settle"
        settle="${pivots:+real pivots[$pivots];} $settle"
    fi
    # What the equations read of tunables and inputs: the plant keeps what follows from tunables, a step the rest.
    kept=$(sed -n 's/^    real h\[\([0-9]*\)\];$/static real kept[\1];/p' "$out/$name.c" | head -n 1)
    held='return memory.h;'
    if ! grep -q '^static void tune' "$out/$name.c"; then
        held=$([ -n "$kept" ] && echo "$kept return kept;" || echo 'return 0;')
    fi
    if grep -q '^static void hold' "$out/$name.c"; then
        held=$(echo "$held" | sed 's/return \(.*\);/hold(\1, memory.u); return \1;/')
    fi
    cat >"$out/$name.member.c" <<EOF
#include "$out/$name.c"
#include "tests/dynamics/family.h"
static ${name}_memory memory;
static iso_plant plant_of(void)
{
    return ${name}_plant(&memory);
}
static void settle_after(real *const x, const real *const p)
{
    (void)x;
    (void)p;
    $settle
}
static const real *held_of(void)
{
    $held
}
extern const family_member $name;
const family_member $name = {"$1 $2", $([ "$1" = loop ] && echo true || echo false), $2, plant_of, &equations, held_of, settle_after};
EOF
    quick_object "$out/$name.member.c" "$out/$name.o"
}

echo '#include "tests/dynamics/family.h"' >"$out/family.c"
list=
for kind in tree loop; do
    built=0
    for seed in $(seq $seeds); do
        if member $kind "$seed"; then
            built=$((built + 1))
            list="$list ${kind}_$seed"
            echo "extern const family_member ${kind}_$seed;" >>"$out/family.c"
        fi
    done
    [ "$built" -eq $seeds ]
    result $? "$built of $seeds seeds of a $kind are compiled"
done
{
    echo 'const family_member *const family[] = {'
    for name in $list; do
        echo "    &$name,"
    done
    echo '    0};'
} >>"$out/family.c"
# shellcheck disable=SC2046,SC2086
program family.run tests/dynamics/family.c tests/general.c "$out/family.c" "$out/generate.o" $solver \
    $(for name in $list; do echo "$out/$name.o"; done) $quick_library
result $? "they link into one program"
joined family "$out/family.run"
finish
