#!/bin/sh
# Random mechanisms, 40 trees and 40 closed loops, of all kinds of joints and closures, in every formulation and with
# every way to the factors of an implicit method, in double: reactions, Jacobian and orders.
. tests/host/test.sh
begin dynamics_family
one_isoc
. tests/isoc/dynamics/solver.sh
seeds=40

EXTRA=-O1
program generate.o -c tests/isoc/dynamics/generate.c &&
    program family.o -c tests/isoc/dynamics/family.c &&
    (EXTRA= && optimised -O1 && rolled && program general.o -c tests/general.c) &&
    program write_scene tests/isoc/dynamics/write_scene.c "$out/generate.o" $solver && "$out/write_scene" "$out" $seeds
result $? "the generator builds, and writes $seeds trees and $seeds loops"

# ways_of KIND SEED: $formulation, by turns, each with every kind of joint; and $factors, how an implicit method's are
# found, by turns; those of loops in one way only.
ways_of()
{
    ways_turn=$((($2 - 1) / 8 + 1))
    factors=full
    case $1 in
    tree)
        ways_seed=$2
        set -- composite articulated
        case $((ways_seed % 3)) in
        0) factors=sparse ;;
        1) factors=looped ;;
        esac
        ;;
    loop) set -- composite parent_axes child_axes ;;
    esac
    shift $((ways_turn % $#))
    formulation=$1
}

files=
for kind in tree loop; do
    built=0
    for seed in $(seq $seeds); do
        name=${kind}_$seed
        method=rosenbrock
        [ $((seed / 2 % 2)) -ne 0 ] || method=bdf4
        ways_of $kind "$seed"
        if isoc "$out/$name.summary" "$out/$name.messages" "$out/$name.scene" -o "$out" --name "$name" --real double --method $method \
            --formulation "$formulation" --factors "$factors"; then
            built=$((built + 1))
            files="$files $out/$name.scene $out/$name.c"
        else
            sed 's/^/# /' "$out/$name.messages"
        fi
    done
    [ "$built" -eq $seeds ]
    result $? "$built of $seeds seeds of a $kind are compiled"
done
# shellcheck disable=SC2086
awk -f tests/isoc/dynamics/family.awk $files
quick
EXTRA=
# shellcheck disable=SC2086
program family.run "$out"/*.member.c "$out/family.c" "$out/family.o" "$out/general.o" "$out/generate.o" $solver
result $? "they link into one program"
joined family "$out/family.run"
finish
