#!/bin/sh
# Hard cases on the Cortex-M4F in QEMU, in float: what holds on the host, as far as there are steps for it, holds there;
# and every error and every hash of the states at the end of a run is the one that the host prints. Of three cases one
# has its turn.
. tests/host/test.sh
. tests/host/emulators.sh
begin hard/board
turn=$(turn_of 3 "${1-}")
echo "# turn $turn of three cases"
rolled
of_board=$FLAGS
optimised -O1
real float

m4f=$(of_port mps2 PORT_FLAGS)
steps=-DHARD_STEPS_MAX=40000

# share FOLDER COMMAND SOURCE...: what all cases share, and these sources, compiled by COMMAND into $out/FOLDER;
# general.c for the host is compiled as by hard.t. Their list is then $common.
share()
{
    folder=$out/$1
    compile=$2
    shift 2
    mkdir -p "$folder"
    common=
    for part in tests/promises/hard/hard.c tests/general.c tests/promises/hard/tolerance.c tests/host/report.c "$@"; do
        object=$folder/$(basename "$part" .c).o
        common="$common $object"
        case $part in
        */hard.c) bounded=$steps ;;
        *) bounded= ;;
        esac
        $compile $bounded -c "$part" -o "$object" || return
    done
}

# board NAME [FLAG FLAG]: builds the case NAME for the board; the first flag stands before those of all, the second
# behind. What newlib lacks there nobody calls.
board()
{
    # shellcheck disable=SC2086
    arm-none-eabi-gcc ${2-} $of_board $m4f $steps ${3-} -nostartfiles --specs=nosys.specs -T port/mps2/mps2.ld \
        -Wl,--gc-sections,--defsym=STACK_BYTES=16384,--wrap=main "tests/promises/hard/$1.c" $on_board -lm -o "$out/$1" \
        2>"$out/warnings"
}

share board "arm-none-eabi-gcc $of_board $m4f" tests/promises/hard/board.c port/mps2/*.c
result $? "what all cases share builds for the board"
on_board=$common
share host "$CC $FLAGS"
result $? "what all cases share builds for the host"
on_host=$common

case $turn in
0) names=van_der_pol ;;
1) names=robertson ;;
2) names=oregonator ;;
all) names='van_der_pol robertson oregonator' ;;
esac
for name in bushing quarter_car $names; do
    # shellcheck disable=SC2086
    EXTRA=$steps program "$name.host" "tests/promises/hard/$name.c" $on_host && board $name
    result $? "$name builds"
    joined "$name on the board" emulated cortex-m4f "$out/$name"
    "$out/$name.host" | diff - "$out/tap" >"$out/differences"
    status=$?
    head -n 5 "$out/differences" | sed 's/^/# /'
    result $status "$name: the board prints what the host does"
done

# Control: with fused multiply-add in the equations it does not.
bare_numbers
board bushing "-I$out/bare" -ffp-contract=fast
result $? "bushing builds with fused multiply-add"
emulated cortex-m4f "$out/bushing" >"$out/fused"
grep -q '^1\.\.' "$out/fused" && ! "$out/bushing.host" | diff -q - "$out/fused" >/dev/null
result $? "control: with fused multiply-add it prints something else"
finish
