#!/bin/sh
# make run takes a snapshot at a tick, and goes on from one: the halves of a run end with the hash of the whole, on the
# host and from there on the Cortex-M4F and back; the rows are those of the whole; what does not fit is refused, and
# touches no file.
. tests/host/test.sh
. tests/host/project.sh
begin snapshot_run
one_isoc
project
unoptimised clang
scene=models/cart_pole.scene # an input that is a function of time; by ab4 with a history
of_host=$out/project/build/host/float/cart_pole
of_board=$out/project/build/cortex-m4f/float/cart_pole

# half NAME ARGUMENT...: a run of 2 s.
half()
{
    half_name=$1
    shift
    call run SCENE=$scene METHOD=ab4 SECONDS=2 "$@"
    expect $? "$half_name: runs"
}

half "the whole, with a snapshot of tick 765" SNAPSHOT=765
read_value hash
hash=$value
printed snapshot build/host/float/cart_pole/snapshot.bin && mv "$of_host/snapshot.bin" "$out/765.bin" &&
    mv "$of_host/trace.csv" "$out/whole.csv"
expect $? "its snapshot is told, $(wc -c <"$out/765.bin") bytes"
half "from there on the board, with another of tick 1234" TARGET=cortex-m4f RESTORE="$PWD/$out/765.bin" SNAPSHOT=1234
printed hash "$hash" && printed from 765 && printed ticks $((2000 - 765))
expect $? "it ends with the hash of the whole: $hash"
sed 2,766d "$out/whole.csv" | cmp - "$of_board/trace.csv"
expect $? "and its table is the rest of that of the whole"
half "from there on the host" RESTORE="$PWD/$of_board/snapshot.bin"
printed hash "$hash" && printed from 1234 && printed snapshot ""
expect $? "it ends with the hash of the whole"
half "without a snapshot"
printed hash "$hash" && printed from "" && cmp "$out/whole.csv" "$of_host/trace.csv"
expect $? "it is the whole as well"

cp "$of_host/trace.csv" "$out/kept.csv"
# refused TEXT FILE ARGUMENT...: the run from this file fails, says TEXT, and leaves the table.
refused()
{
    text=$1
    file=$2
    shift 2
    ! call run SCENE=$scene METHOD=ab4 SECONDS=2 RESTORE="$file" "$@" && says "$text" &&
        cmp -s "$out/kept.csv" "$of_host/trace.csv" && [ ! -e "$of_host/snapshot.bin" ]
    expect $? "refused, with '$text': ${file##*/} $*"
}
{ head -c 100 "$out/765.bin" && printf 'x' && tail -c +102 "$out/765.bin"; } >"$out/damaged.bin"
refused 'the snapshot is damaged' "$PWD/$out/damaged.bin"
refused 'the run ends before the tick of the snapshot' "$PWD/$out/765.bin" SECONDS=0.764
refused 'is no snapshot' "$PWD/$out/absent.bin"
refused 'does not come by the tick of the snapshot' "$PWD/$out/765.bin" SNAPSHOT=2001
refused 'the snapshot is of another plant' "$PWD/$out/765.bin" METHOD=heun
refused 'SNAPSHOT=1e3 is no tick' "$PWD/$out/765.bin" SNAPSHOT=1e3
refused 'they are for scenes' "$PWD/$out/765.bin" SCENE=models/oscillator.c
# A method whose memory has the same size, and another step.
call run SCENE=$scene METHOD=heun SECONDS=2 SNAPSHOT=765 && mv "$of_host/snapshot.bin" "$out/heun.bin" &&
    cp "$of_host/trace.csv" "$out/kept.csv"
expect $? "by heun: runs"
refused 'the snapshot is of another plant' "$PWD/$out/heun.bin" METHOD=euler
refused 'the snapshot is of another plant' "$PWD/$out/heun.bin" METHOD=heun STEP=2ms SECONDS=4
# identity ARGUMENT...: the plant with these options, one of $identities, whose files are $interfaces.
identities=0 interfaces=
identity()
{
    identities=$((identities + 1))
    interfaces="$interfaces $out/identity_$identities/interface.c"
    isoc /dev/null "$out/errors" $scene -o "$out/identity_$identities" --link "$@"
}
for method in $(build/isoc --methods | sed -n 's/^| \([a-z0-9_]*\) | [0-9].*/\1/p'); do
    set -- --method "$method"
    [ "$method" != adams ] || set -- "$@" --tolerance 1e-6
    for step in 1ms 2ms; do
        identity "$@" --step $step
    done
done
identity --real double
different=$identities
identity
identity
# shellcheck disable=SC2086
awk -F ' = ' -v different=$different '
    /\.identity = / { if (++count <= different) twice += seen[$2]++; else same[count] = $2 }
    END { exit count != different + 2 || twice > 0 || different < 23 || same[count] == "" || same[count] != same[count - 1] }' $interfaces
expect $? "$different identities, by method, step and numbers, are different; that of one plant is the same each time"
! call size SNAPSHOT=3 && says 'SNAPSHOT has no effect on ?make size?'
expect $? "SNAPSHOT is of make run"

# Control: a program that leaves the history out of the record has another hash.
sed -i 's/memcpy(record + sizeof head, plant->memory, head.memory_bytes);/memcpy(record + sizeof head, plant->memory, 16);/' \
    "$out/project/core/runtime/snapshot.c"
call run SCENE=$scene METHOD=ab4 SECONDS=2 SNAPSHOT=765 &&
    call run SCENE=$scene METHOD=ab4 SECONDS=2 RESTORE="$PWD/$of_host/snapshot.bin"
printed from 765 && ! printed hash "$hash"
expect $? "found: a record of 16 bytes of the memory alone"
finish
