#!/bin/sh
# The hard cases, each in float and in double: what must hold for which method and step is said in the file of the case.
. tests/host/test.sh
begin hard
one_isoc
optimised -O1
unrolled=$FLAGS
rolled

# Each case is tried in one real each time, in both with the argument `all`.
turn=$(turn_of 2 "${1-}")
echo "# turn $turn of the reals"

# share: what all cases share, in the real of now, compiled once. Their list is then $common. The steps of adams alone
# are compiled soon and run for long.
share()
{
    common=
    for part in tests/promises/hard/hard.c tests/general.c tests/promises/hard/tolerance.c tests/promises/hard/chain.c tests/host/report.c; do
        object=$out/$(basename "$part" .c).$real.o
        common="$common $object"
        case $part in
        */tolerance.c) flags=$unrolled ;;
        *) flags=$FLAGS ;;
        esac
        # shellcheck disable=SC2086
        "$CC" $flags $REAL_FLAG -c "$part" -o "$object" || return
    done
}

# hard NAME SOURCE...: builds and runs the case NAME of these sources.
hard()
{
    name=$1
    shift
    # shellcheck disable=SC2086
    program "$name.$real" "$@" $common
    result $? "$name builds in $real"
    joined "$name, $real" "$out/$name.$real"
}

# generated CASE SCENE [LINE]: the case CASE on the plant of tests/promises/hard/SCENE.scene, with a further LINE in it.
generated()
{
    folder=$out/$2.$real${3:+.with}
    mkdir -p "$folder"
    { cat "tests/promises/hard/$2.scene" && echo "${3-}"; } >"$folder/$2.scene"
    isoc "$folder/summary" '' "$folder/$2.scene" -o "$folder" --real "$real"
    result $? "$2${3:+, $3,} is compiled in $real"
    case_name=$1.$2${3:+.with}
    # shellcheck disable=SC2086
    program "$case_name.$real" "tests/promises/hard/$1.c" $common "$folder/plant.c"
    result $? "$1 of $2 builds in $real"
    joined "$1, $2${3:+, $3}, $real" "$out/$case_name.$real"
}

# counts METHOD FROM: instructions of a thousand steps of the decay.
counts()
{
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect=hard_go \
        "$out/denormals.$real" count "$1" "$2" 2>&1 | sed -n 's/.*Collected : //p'
}

# costs_the_same METHOD NAME: whether the numbers are normal or denormal; and the count sees a run that stops early.
costs_the_same()
{
    normal=$(counts "$1" from-one)
    denormal=$(counts "$1" from-denormals)
    stopped=$(counts "$1" from-infinity)
    [ -n "$normal" ] && [ "$normal" = "$denormal" ] && [ "$stopped" -lt "$normal" ]
    result $? "$2 in $real: $normal instructions from 1, $denormal among denormals; control: $stopped where it stops"
}

share
result $? "what all cases share builds in $real"
hard jacobian tests/promises/hard/jacobian.c
for number in float double; do
    real $number
    share
    result $? "what all cases share builds in $number"
    case $turn,$number in
    all,*) names='long_run robertson bushing inputs rounding light_tip van_der_pol oregonator quarter_car denormals heavy_tip' ;;
    0,float | 1,double) names='long_run robertson bushing inputs rounding light_tip' ;;
    *) names='van_der_pol oregonator quarter_car denormals heavy_tip' ;;
    esac
    for name in $names; do
        case $name in
        *_tip) generated mass_ratio $name ;;
        rounding)
            # shellcheck disable=SC2086
            program "rounding.$real" tests/promises/hard/rounding.c $common
            result $? "rounding builds in $real"
            joined "rounding, $real" "$out/rounding.$real" "$out/rounding_$real.tsv"
            ;;
        *) hard $name tests/promises/hard/$name.c ;;
        esac
        [ $name != denormals ] || { costs_the_same 2 rk4 && costs_the_same 24 'bdf4, compensated,'; }
    done
done
finish
