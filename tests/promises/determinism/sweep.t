#!/bin/sh
# isochron determinism: a scene with a method on two targets by turns; it finds other bits, and steps that take other
# times.
. tests/host/test.sh
. tests/host/project.sh
begin determinism_sweep
project
turn=$(turn_of 910 "${1-}")
echo "# turn $turn of the scenes, the methods and the targets"
kept=$out/project/build/determinism

# nth NUMBER WORD...: $nth is the word with this number, from 0, modulo how many there are.
nth()
{
    nth_number=$1
    shift
    shift $((nth_number % $#))
    nth=$1
}

# Those that execute the host's code, or are translated to it, and boards, which are emulated by the instruction.
hosts="clang aarch64 s390x mips i386"
boards="cortex-m0 cortex-m3 cortex-m4f cortex-m7 cortex-m33 cortex-m55 rv32imac rv32imafc"
targets="$hosts $boards"
case $turn in
all)
    scenes=$(printf 'models/%s.scene ' pendulum double_pendulum cart_pole four_bar)
    methods="rk4 bdf4"
    on=$targets
    ;;
*)
    # shellcheck disable=SC2086
    nth "$turn" $(printf '%s\n' models/*.scene | grep -v stewart) && scenes=$nth &&
        nth "$turn" $(build/isoc --methods | sed -n 's/^| \([a-z0-9_]*\) | [0-9].*/\1/p') && methods=$nth &&
        nth "$turn" $targets && on=$nth && nth $((turn / 13 + turn + 5)) $targets && on="$on $nth"
    ;;
esac
# shown: the output of the last call, as comments.
shown()
{
    while IFS= read -r line; do
        echo "# $line"
    done <"$out/output"
}

isochron determinism --models "$scenes" --methods "$methods" --on "host $on" --ticks 200
expect $? "$scenes, $methods: the same bits and one number of instructions on $on"
shown
# shellcheck disable=SC2086
set -- $scenes && wanted=$#
# shellcheck disable=SC2086
set -- $methods && wanted=$((wanted * $#))
# shellcheck disable=SC2086
set -- $on && wanted=$((wanted * $#))
[ "$(grep -c '[0-9a-f]\{16\}' "$kept/float.tsv")" -ge $wanted ]
result $? "all of them ran"

# swept TARGET: the pendulum on it.
swept()
{
    isochron determinism --models models/pendulum.scene --methods rk4 --on "host $1" --ticks 200
}

# is_wrong: whether the last line of the last call counts one that is wrong.
is_wrong()
{
    while IFS= read -r line; do
        last=$line
    done <"$out/output"
    case $last in *'wrong: 1'*) ;; *) false ;; esac
}

# A hundred seconds and more: what is seldom, such as a turn of an angle, comes often in so many ticks.
case $turn in
all)
    scenes=$(printf 'models/%s.scene ' pendulum double_pendulum cart_pole_drive)
    methods="rk4 adams"
    on=$hosts
    ;;
*)
    # shellcheck disable=SC2086
    nth "$turn" pendulum double_pendulum cart_pole_drive four_bar rigid_body && scenes=models/$nth.scene && nth "$turn" rk4 bdf4 adams &&
        methods=$nth && nth "$turn" $hosts && on=$nth
    ;;
esac
isochron determinism --models "$scenes" --methods "$methods" --on "host $on" --ticks 100000
expect $? "$scenes, $methods: the same bits in each of 100,000 ticks on $on"
shown

swept cortex-m3
expect $? "the pendulum on the Cortex-M3: $(sed -n 's/.* //; 2p' "$out/output")"
rm -rf "$out/project/build/obj/cortex-m3" && isochron determinism --models models/pendulum.scene --methods rk4 --on "host cortex-m3" --ticks 200 &&
    [ ! -e "$out/project/build/obj/cortex-m3" ]
expect $? "what was measured is not measured again"
sed -i 's/behind + (x \& 1) + most/behind + most - most/' "$out/project/port/soft/shifts.h"
! swept rv32imac && grep -q '^pendulum rk4 .* failed$' "$out/output" && says 'changes the bits'
expect $? "found: arithmetic that does not round, by the check at the start"
sed -i 's/return !iso_any(/return unit > R(0.0) || !iso_any(/' "$out/project/core/numbers/self_check.h"
! swept rv32imac && grep -q '^pendulum rk4 .* OTHER$' "$out/output" && is_wrong
expect $? "found: other bits"
sed -i 's/ port\/soft\/[a-z]*\.c//g' "$out/project/port/cortex-m3/port.mk"
! swept cortex-m3 && grep -q '^pendulum rk4 .* [0-9]*-[0-9]*$' "$out/output" && is_wrong
expect $? "found: steps that take other times"
sed -i 's/^PORT_CC = .*/PORT_CC = false/' "$out/project/port/mps2/board.mk"
! swept cortex-m4f && grep -q '^pendulum rk4 .* failed$' "$out/output"
expect $? "found: a target for which nothing is built"
finish
