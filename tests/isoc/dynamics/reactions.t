#!/bin/sh
# Reactions of joints and closures of generated plants against the independent dynamics, and in simple cases by hand.
. tests/host/test.sh
begin reactions
one_isoc
optimised -O0
. tests/isoc/dynamics/solver.sh

# reacting SCENE TABLE: the scene shows the reactions of all joints and then of all closures, as the table wants them,
# with nothing added to the equations of motion to hold the closures; the plant against the table.
reacting()
{
    name=${1##*/}
    name=${name%.scene}
    [ -f "$out/$name.scene" ] || {
        isoc "$out/dot" '' "$1" --dot
        awk '
            FILENAME == ARGV[1] { sub(/^stabilisation (baumgarte|projection).*/, "stabilisation none"); print; next }
            / -> / && match($0, /label="[A-Za-z0-9_]*\\n/) {
                of = substr($0, RSTART + 7, RLENGTH - 9)
                print "output force_of_" of " = force of " of "\noutput moment_of_" of " = moment of " of
            }' "$1" "$out/dot" >"$out/$name.scene"
    }
    # shellcheck disable=SC2086
    isoc "$out/summary" '' "$out/$name.scene" -o "$out/$name" --real "$real" &&
        program "$name.reactions" "$2" "$out/$name/plant.c" $reactions
    result $? "$name builds in $real"
    joined "$name in $real" "$out/$name.reactions"
}

for real in float double; do
    real $real
    compare
    # shellcheck disable=SC2086
    "$CC" $quick $REAL_FLAG -c tests/isoc/dynamics/reactions.c -o "$out/reactions.$real.o"
    result $? "tests/isoc/dynamics/reactions.c compiles in $real"
    reactions="$out/reactions.$real.o"
    for object in $compare; do
        case $object in
        */compare*) ;;
        *) reactions="$reactions $object" ;;
        esac
    done
    for name in arm6 tree pendulum double_pendulum cart_pole; do
        reacting "models/$name.scene" "tests/isoc/dynamics/table_$name.c"
    done
    for name in ball_chain satellite stage; do
        reacting "tests/isoc/mechanism/$name.scene" "tests/isoc/mechanism/table_$name.c"
    done
    for name in four_bar slider_crank; do
        reacting "models/$name.scene" "tests/isoc/mechanism/table_$name.c"
    done
    # The larger ones take seconds, and show nothing in float that the others would not.
    [ $real = float ] || for name in squeezer stewart; do
        reacting "models/$name.scene" "tests/isoc/mechanism/table_$name.c"
    done

done
finish
