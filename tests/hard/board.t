#!/bin/sh
# Hard cases on the Cortex-M4F in QEMU, in float: what holds on the host, as far as there are steps for it, holds there; and
# every error and every hash of the states at the end of a run is the one that the host prints.
. tests/host/test.sh
begin m4f/hard
real float

m4f="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -ffunction-sections -fdata-sections"
steps=-DHARD_STEPS_MAX=40000

# common FOLDER COMPILER...: what all cases share, compiled once into $out/FOLDER. Their list is then $common.
common()
{
    folder=$out/$1
    shift
    mkdir -p "$folder"
    common=
    for part in "$@"; do
        object=$folder/$(basename "$part" .c).o
        common="$common $object"
        # shellcheck disable=SC2086
        $compile -c "$part" -o "$object" || return
    done
}

# shared FOLDER SOURCE...: the same of every case, and what FOLDER needs besides.
shared()
{
    common "$@" tests/hard/hard.c tests/hard/tolerance.c tests/host/report.c
    result $? "what all cases share builds for the $1"
}

# board NAME [FLAG]: builds the case NAME for the board. What newlib lacks there nobody calls.
board()
{
    # shellcheck disable=SC2086
    arm-none-eabi-gcc $FLAGS $m4f $steps ${2-} -nostartfiles --specs=nosys.specs -T port/mps2/mps2.ld \
        -Wl,--gc-sections,--defsym=STACK_BYTES=16384,--wrap=main "tests/hard/$1.c" $on_board -lm -o "$out/$1" \
        2>"$out/warnings"
}

compile="arm-none-eabi-gcc $FLAGS $m4f $steps"
shared board tests/hard/board.c port/mps2/*.c
on_board=$common
compile="$CC $FLAGS $steps"
shared host
on_host=$common

for name in bushing quarter_car van_der_pol robertson oregonator; do
    # shellcheck disable=SC2086
    EXTRA=$steps program "$name.host" "tests/hard/$name.c" $on_host && board $name
    result $? "$name builds"
    joined "$name on the board" tests/exec.sh "$out/$name"
    "$out/$name.host" | diff - "$out/tap" >"$out/differences"
    status=$?
    head -n 5 "$out/differences" | sed 's/^/# /'
    result $status "$name: the board prints what the host does"
done

# Control: with fused multiply-add in the equations it does not.
board bushing -ffp-contract=fast && tests/exec.sh "$out/bushing" >"$out/fused"
! "$out/bushing.host" | diff -q - "$out/fused" >/dev/null
result $? "control: where the case is built with fused multiply-add it prints something else"
finish
