#!/bin/sh
# What `isochron run` promises to scripts: the lines it ends with, the table it writes, and its exit status.
. tests/host/test.sh
. tests/host/project.sh
begin check/run
# The compilers themselves: a test copies them into a folder of its own.
PATH=${PATH#/usr/lib/ccache:}
project
unoptimised

keys="scene method step real ticks late overruns state hash trace"

# run ARGUMENT...: runs; the table is then $csv.
run()
{
    case ${1--} in
    -*) set -- models/double_pendulum.scene "$@" ;;
    esac
    isochron run "$@"
    status=$?
    read_value trace && csv=$out/project/$value
    return $status
}

# has_rows COUNT: whether the table has so many, without its header.
has_rows()
{
    awk -v count="$1" 'END { exit NR - 1 != count }' "$csv"
}

run
expect $? "isochron run, with nothing said"
sed -n '/^scene /h; /^scene /!H; $ { x; p; }' "$out/output" >"$out/summary"
missing=
found=
while read -r key _; do
    found="$found $key "
done <"$out/summary"
for key in $keys; do
    case $found in
    *" $key "*" $key "*) missing="$missing $key" ;;
    *" $key "*) ;;
    *) missing="$missing $key" ;;
    esac
done
[ -z "$missing" ]
expect $? "it ends with a summary that has each key once: $keys"
printed scene double_pendulum && printed ticks 10000 && printed real float
expect $? "that is the double pendulum, 10 s, in float"
read_value hash && case $value in *[!0-9a-f]*) false ;; ????????????????) ;; *) false ;; esac
expect $? "hash: 16 hexadecimal digits"
printed late 0 && printed overruns 0
expect $? "nothing late on the simulated tick"
printed trace build/host/float/double_pendulum/trace.csv && [ -f "$csv" ]
expect $? "trace: build/host/float/double_pendulum/trace.csv"
has_rows 10001
expect $? "a row for the start, and one for each tick"
header=t,shoulder_angle,elbow_angle,shoulder_rate,elbow_rate,tip_x,tip_y,tip_z,energy
read -r first <"$csv" && [ "$first" = $header ]
expect $? "the header: t and the names of the outputs"
awk -F, 'NR == 1 { n = NF } NF != n { exit 1 }' "$csv"
expect $? "every row has as many numbers as the header has names"
awk -F, 'NR > 1 && ($1 - (NR - 2) * 1e-3) ^ 2 > 1e-18 { exit 1 }' "$csv"
expect $? "t is the tick times the step, from 0 on"
read_value hash && hash=$value
cp "$csv" "$out/first.csv"
run && printed hash "$hash" && cmp -s "$csv" "$out/first.csv"
expect $? "a second run gives the same hash and the same table"

# The table reads back exactly: from its columns, which begin with the four states, comes the hash of the run: that of
# ticks 1 and after.
cat >"$out/hash.c" <<'C'
#include "core/runtime/hash.h"
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    enum { STATES = 4, BYTES = 4096 };
    char line[BYTES];
    uint64_t hash = ISO_HASH_START;
    for (long row = 0; fgets(line, sizeof line, stdin) != NULL; row++) {
        real x[STATES];
        char *at = line;
        (void)strtod(line, &at);
        for (int i = 0; row > 0 && i < STATES; i++) {
            x[i] = strtof(at + 1, &at);
        }
        hash = row > 1 ? iso_hash_reals(hash, x, STATES) : hash;
    }
    printf("%016llx\n", (unsigned long long)hash);
    return 0;
}
C
$CC -std=c11 -I. "$out/hash.c" -o "$out/hash" && [ "$("$out/hash" <"$csv")" = "$hash" ]
expect $? "the table reads back exactly: it has the states that the hash is of"
read_value state && awk -F, -v state="$value" 'END { exit ($2 " " $3 " " $4 " " $5) != state }' "$csv"
expect $? "state: as in the last row"

run --method euler --step 2ms --seconds 1 && printed method euler && printed ticks 500 && has_rows 501
expect $? "METHOD, STEP and SECONDS are heard"
run --real double --seconds 1 && printed real double && printed ticks 1000 && ! printed hash "$hash"
expect $? "--real double"
run models/oscillator.c --seconds 1 && printed scene oscillator && has_rows 1001
expect $? "a plant written by hand"
mkdir -p "$out/elsewhere" && cp models/pendulum.scene "$out/elsewhere/mine.scene"
run "$PWD/$out/elsewhere/mine.scene" --seconds 1 && printed scene mine && has_rows 1001
expect $? "a scene outside the project"

# A step so long that the method diverges to infinity.
sed 's/^step .*/step 500 ms/' models/double_pendulum.scene >"$out/elsewhere/wild.scene"
! run "$PWD/$out/elsewhere/wild.scene" --method euler --step 500ms --seconds 2000
expect $? "status not 0 when the state leaves the finite numbers"

# Ticks that go wrong: the statistics are exact, and the trajectory is the same.
cat >"$out/script" <<'S'
late 5 300us
lose 20
lose 21
slow 40 2500us
S
run --script "$PWD/$out/script" && printed hash "$hash"
expect $? "ticks that are late, lost or slow do not change the trajectory"
# Late: 5; 20 and 21, done with 22; 41 and 42, after 40 at 42.5 ms. Lost, since told of with a later one: 20, 21; 41.
# Overruns: 20, at 22 ms (21 is done when 22 is due); 40 and 41, at 42.5 ms.
printed ticks 10000 && printed late 5 && printed lost 3 && printed overruns 3
expect $? "they are accounted: 5 late, 3 lost, 3 overruns"

# refuses TEXT ARGUMENT...: fails, and says TEXT.
refuses()
{
    text=$1
    shift
    ! run "$@" && grep -Eq -- "$text" "$out/output" "$out/errors"
    expect $? "refused, with '$text': $*"
}

refuses 'absent\.scene' models/absent.scene
refuses 'TARGET|target' --target abacus
refuses 'METHOD|method' --method guess
refuses 'REAL|real' --real decimal
refuses 'STEP|step' --step fast
refuses 'SECONDS|seconds' --seconds soon

# A plant by hand with no more than a derivative is not compiled for a method that needs a Jacobian.
run models/oscillator.c --seconds 1 && read_value hash && hash=$value && printed local_error ''
expect $? "a plant in C is not checked"
run models/oscillator.c --seconds 1 --checked && printed hash "$hash" && ! printed local_error ''
expect $? "--checked: it is, with the same motion"
run models/oscillator.c --seconds 1 --compensated && ! printed hash "$hash"
expect $? "--compensated: its sums are compensated"
run models/oscillator.c --method ab4 --seconds 2 --checked && printed restarts 1
expect $? "a check with a history finds the step of its force, and begins anew"
run models/oscillator.c --method adams --tolerance 1e-9 --real double --seconds 1 &&
    read_value local_error && awk -v error="$value" 'BEGIN { exit !(error > 0 && error <= 1e-9) }'
expect $? "--tolerance of a plant in C: a local error of at most 1e-9"
run models/oscillator.c --method adams --seconds 1 && read_value substeps && [ "$value" -ge 1000 ]
expect $? "a plant by hand runs with adams"
sed '/^#define ISO_HAS_JACOBIAN/d; /^static void factor/,/^}/d; /^static void solve/,/^}/d
s/^static const iso_equations.*/static const iso_equations equations = {.derivative = derivative};/' \
    models/oscillator.c >"$out/elsewhere/simple.c"
refuses 'needs a Jacobian, and this plant has none' "$PWD/$out/elsewhere/simple.c" --method bdf4
run "$PWD/$out/elsewhere/simple.c" --method heun --seconds 1
expect $? "a plant without a Jacobian runs with a method that needs none"

# A machine without the cross compiler or the emulator: all tools but those that the target needs.
mkdir -p "$out/bin"
IFS=:
for folder in $PATH; do
    # What a folder before it has is there already.
    ln -s "$folder"/* "$out/bin" 2>"$out/errors"
done
unset IFS
rm -f "$out"/bin/arm-none-eabi-* "$out"/bin/qemu-system-*
full=$PATH
PATH=$PWD/$out/bin
refuses 'apt-get install.*gcc-arm-none-eabi|apt install.*gcc-arm-none-eabi' --target cortex-m4f
run --seconds 1
expect $? "the host needs neither"
ln -sf "$(PATH=$full command -v arm-none-eabi-gcc)" "$out/bin/arm-none-eabi-gcc"
refuses 'qemu-system-arm' --target cortex-m4f
PATH=$full
finish
