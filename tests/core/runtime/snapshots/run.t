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
    isochron run $scene --method ab4 --seconds 2 "$@"
    expect $? "$half_name: runs"
}

half "the whole, with a snapshot of tick 765" --snapshot 765
read_value hash
hash=$value
printed snapshot build/host/float/cart_pole/snapshot.bin && mv "$of_host/snapshot.bin" "$out/765.bin" &&
    mv "$of_host/trace.csv" "$out/whole.csv"
expect $? "its snapshot is told, $(wc -c <"$out/765.bin") bytes"
half "from there on the board, with another of tick 1234" --target cortex-m4f --restore "$PWD/$out/765.bin" --snapshot 1234
printed hash "$hash" && printed from 765 && printed ticks $((2000 - 765))
expect $? "it ends with the hash of the whole: $hash"
sed 2,766d "$out/whole.csv" | cmp - "$of_board/trace.csv"
expect $? "and its table is the rest of that of the whole"
half "from there on the host" --restore "$PWD/$of_board/snapshot.bin"
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
    case ${1-} in
    *.c) of=$1 && shift ;;
    *) of=$scene ;;
    esac
    ! isochron run "$of" --method ab4 --seconds 2 --restore "$file" "$@" && says "$text" &&
        cmp -s "$out/kept.csv" "$of_host/trace.csv" && [ ! -e "$of_host/snapshot.bin" ]
    expect $? "refused, with '$text': ${file##*/} $*"
}
{ head -c 100 "$out/765.bin" && printf 'x' && tail -c +102 "$out/765.bin"; } >"$out/damaged.bin"
refused 'the snapshot is damaged' "$PWD/$out/damaged.bin"
refused 'the run ends before the tick of the snapshot' "$PWD/$out/765.bin" --seconds 0.764
refused 'is no snapshot' "$PWD/$out/absent.bin"
refused 'does not come by the tick of the snapshot' "$PWD/$out/765.bin" --snapshot 2001
refused 'the snapshot is of another plant' "$PWD/$out/765.bin" --method heun
refused '--snapshot 1e3 is no TICK' "$PWD/$out/765.bin" --snapshot 1e3
refused 'they are for scenes' "$PWD/$out/765.bin" models/oscillator.c
# A method whose memory has the same size, and another step.
isochron run $scene --method heun --seconds 2 --snapshot 765 && mv "$of_host/snapshot.bin" "$out/heun.bin" &&
    cp "$of_host/trace.csv" "$out/kept.csv"
expect $? "by heun: runs"
refused 'the snapshot is of another plant' "$PWD/$out/heun.bin" --method euler
refused 'the snapshot is of another plant' "$PWD/$out/heun.bin" --method heun --step 2ms --seconds 4
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
! isochron size models/double_pendulum.scene --snapshot 3 && says '--snapshot has no effect on size'
expect $? "--snapshot is of isochron run"

# Control: a program that leaves the history out of the record has another hash.
sed -i 's/memcpy(snapshot + sizeof head, plant->memory, head.memory_bytes);/memcpy(snapshot + sizeof head, plant->memory, 16);/' \
    "$out/project/core/runtime/snapshot.c"
isochron run $scene --method ab4 --seconds 2 --snapshot 765 &&
    isochron run $scene --method ab4 --seconds 2 --restore "$PWD/$of_host/snapshot.bin"
printed from 765 && ! printed hash "$hash"
expect $? "found: a record of 16 bytes of the memory alone"
finish
