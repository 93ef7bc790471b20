#!/bin/sh
# What `make run` promises to scripts: the lines it ends with, the table it writes, and its exit status.
. tests/host/test.sh
. tests/host/project.sh
begin check/run
project

keys="scene method step real ticks late overruns state hash trace"

# run ARGUMENT...: runs; the table is then $csv.
run()
{
    call run "$@"
    status=$?
    csv=$out/project/$(value trace)
    return $status
}

# rows: of the table, without its header.
rows()
{
    awk 'END { print NR - 1 }' "$csv"
}

run
expect $? "make run, with nothing said"
missing=
for key in $keys; do
    [ "$(grep -c "^$key " "$out/output")" -eq 1 ] || missing="$missing $key"
done
[ -z "$missing" ]
expect $? "each key once: $keys"
[ "$(value scene)" = double_pendulum ] && [ "$(value ticks)" = 10000 ] && [ "$(value real)" = float ]
expect $? "that is the double pendulum, 10 s, in float"
value hash | grep -Eqx '[0-9a-f]{16}'
expect $? "hash: 16 hexadecimal digits"
[ "$(value late)" = 0 ] && [ "$(value overruns)" = 0 ]
expect $? "nothing late on the simulated tick"
[ "$(value trace)" = build/host/float/double_pendulum/trace.csv ] && [ -f "$csv" ]
expect $? "trace: build/host/float/double_pendulum/trace.csv"
[ "$(rows)" = 10000 ]
expect $? "one row a tick"
columns=$(grep -c '^ *output ' "$out/project/models/double_pendulum.scene")
[ "$(head -n 1 "$csv" | cut -d, -f1)" = t ] && [ "$(head -n 1 "$csv" | tr , '\n' | wc -l)" -eq $((columns + 1)) ]
expect $? "the header: t and the names of the $columns outputs"
awk -F, 'NR == 1 { n = NF } NF != n { exit 1 }' "$csv"
expect $? "every row has as many numbers as the header has names"
awk -F, 'NR > 1 && ($1 - (NR - 1) * 1e-3) ^ 2 > 1e-18 { exit 1 }' "$csv"
expect $? "t is the tick times the step"
hash=$(value hash)
cp "$csv" "$out/first.csv"
run && [ "$(value hash)" = "$hash" ] && cmp -s "$csv" "$out/first.csv"
expect $? "a second run gives the same hash and the same table"

# The last row against the state that is printed: positions are the first two states and among the outputs.
shoulder=$(value state | cut -d' ' -f1)
tail -n 1 "$csv" | tr , '\n' | grep -Fqx -- "$shoulder"
expect $? "the first state stands in the last row, digit for digit"

# One number of the table, read by a program and printed again with enough digits, is the same text's value.
cat >"$out/read.c" <<'C'
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
int main(void)
{
    char line[4096], again[64];
    long bad = 0, numbers = 0;
    if (fgets(line, sizeof line, stdin) == NULL) {
        return 1;
    }
    while (fgets(line, sizeof line, stdin) != NULL) {
        for (char *word = strtok(line, ",\n"); word != NULL; word = strtok(NULL, ",\n")) {
            char *end = NULL;
            const float x = strtof(word, &end);
            snprintf(again, sizeof again, "%.9g", (double)x);
            bad += *end != '\0' || strtof(again, NULL) != x || strlen(word) > 16;
            numbers++;
        }
    }
    return bad == 0 && numbers > 0 ? 0 : 1;
}
C
$CC -O1 "$out/read.c" -o "$out/read" && "$out/read" <"$csv"
expect $? "every field is a number"

run METHOD=euler STEP=2ms SECONDS=1 && [ "$(value method)" = euler ] && [ "$(value ticks)" = 500 ] && [ "$(rows)" = 500 ]
expect $? "METHOD, STEP and SECONDS are heard"
run REAL=double SECONDS=1 && [ "$(value real)" = double ] && [ "$(value ticks)" = 1000 ] && [ "$(value hash)" != "$hash" ]
expect $? "REAL=double"
run SCENE=models/oscillator.c SECONDS=1 && [ "$(value scene)" = oscillator ] && [ "$(rows)" = 1000 ]
expect $? "a plant written by hand"
mkdir -p "$out/elsewhere" && cp models/pendulum.scene "$out/elsewhere/mine.scene"
run SCENE="$PWD/$out/elsewhere/mine.scene" SECONDS=1 && [ "$(value scene)" = mine ] && [ "$(rows)" = 1000 ]
expect $? "a scene outside the project"

# A step so long that the method diverges to infinity.
sed 's/^step .*/step 500 ms/' models/double_pendulum.scene >"$out/elsewhere/wild.scene"
! run SCENE="$PWD/$out/elsewhere/wild.scene" METHOD=euler STEP=500ms SECONDS=2000
expect $? "status not 0 when the state leaves the finite numbers"

# refuses TEXT ARGUMENT...: fails, and says TEXT.
refuses()
{
    text=$1
    shift
    ! run "$@" && cat "$out/output" "$out/errors" | grep -Eq -- "$text"
    expect $? "refused, with '$text': $*"
}

refuses 'absent\.scene' SCENE=models/absent.scene
refuses 'TARGET|target' TARGET=abacus
refuses 'METHOD|method' METHOD=guess
refuses 'REAL|real' REAL=decimal
refuses 'STEP|step' STEP=fast
refuses 'SECONDS|seconds' SECONDS=soon

# A machine without the cross compiler or the emulator: all tools but those that the target needs.
mkdir -p "$out/bin"
IFS=:
for folder in $PATH; do
    for tool in "$folder"/*; do
        case $(basename "$tool") in
        arm-none-eabi-* | qemu-system-*) ;;
        *) [ ! -x "$tool" ] || [ -e "$out/bin/$(basename "$tool")" ] || ln -s "$tool" "$out/bin/$(basename "$tool")" ;;
        esac
    done
done
unset IFS
full=$PATH
PATH=$PWD/$out/bin
refuses 'apt-get install.*gcc-arm-none-eabi|apt install.*gcc-arm-none-eabi' TARGET=cortex-m4f
run SECONDS=1
expect $? "the host needs neither"
ln -sf "$(PATH=$full command -v arm-none-eabi-gcc)" "$out/bin/arm-none-eabi-gcc"
refuses 'qemu-system-arm' TARGET=cortex-m4f
PATH=$full
finish
