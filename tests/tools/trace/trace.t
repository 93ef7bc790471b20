#!/bin/sh
# A run that goes wrong is told of: by build/trace, by the simulated tick's script, and by a fault on the board.
. tests/host/test.sh
. tests/host/project.sh
begin check/trace
project

isochron run models/oscillator.c --seconds 1
expect $? "a run to work on"
oscillator=$out/project/build/host/float/oscillator/program
trace=$out/project/build/trace

# tells TEXT NAME COMMAND...: build/trace fails on the command, says TEXT, and leaves no table.
tells()
{
    text=$1
    name=$2
    shift 2
    rm -rf "$out/table"
    mkdir "$out/table"
    ! "$trace" -o "$out/table" -- "$@" >"$out/output" 2>"$out/errors" && grep -q -- "$text" "$out/errors" &&
        [ -z "$(ls "$out/table")" ]
    expect $? "$name"
}

tells 'No such file' 'a command that does not exist' ./nowhere
tells 'broke off.*status 3' 'a command that fails' sh -c 'exit 3'
tells 'broke off.*signal 9' 'a command that is killed' sh -c 'kill -9 $$'
tells "not a run.*'hello'" 'something else than a run' echo hello
tells 'broke off' 'a header without a run' printf 'isochron 2\nscene x\n'
tells "'colour'" 'a header with an unknown line' printf 'isochron 2\ncolour red\n\n'
tells 'makes no sense' 'a header with more units than outputs' \
    printf 'isochron 2\nscene x\nmethod rk4\nstep 0.1\nreal float\nperiod_ns 1\nnames a,b\nunits m,m,m\n\n'
tells 'makes no sense' 'a header without a step' printf 'isochron 2\nscene x\n\n'
tells 'Bail out! hot' 'a platform that gives up' printf 'Bail out! hot\n'
"$oscillator" 1000000000 >"$out/stream"
for bytes in 100 250 5000; do
    tells 'broke off' "a run cut off after $bytes bytes" head -c $bytes "$out/stream"
done
tells 'ended with status 4' 'a whole run of a command that then fails' sh -c "cat '$out/stream'; exit 4"

mkdir "$out/kept"
echo precious >"$out/kept/trace.csv"
! "$trace" -o "$out/kept" -- false 2>"$out/errors" && [ "$(cat "$out/kept/trace.csv")" = precious ]
expect $? "a failed run leaves the last table"
if [ -e /dev/full ]; then
    ln -s /dev/full "$out/kept/trace.csv.partial"
    ! "$trace" -o "$out/kept" -- cat "$out/stream" 2>"$out/errors" && grep -q 'No space' "$out/errors"
    expect $? "a full disk"
fi
! "$trace" -o "$out/nowhere" -- true 2>"$out/errors" && grep -q 'No such file' "$out/errors"
expect $? "a folder that does not exist"
! "$trace" 2>"$out/errors" && grep -q usage "$out/errors"
expect $? "no command"

# Instructions of a step that differ are said to be of interrupts, where ticks came late; else not.
mkdir "$out/counted"
echo 'slow 5 20ms' >"$out/counted/script"
"$trace" -o "$out/counted" --clock instructions -- "$oscillator" 1000000000 "$out/counted/script" >"$out/output" &&
    grep -q '^instructions_per_step 0 20000000, up to 20000000 of them of the interrupts' "$out/output" &&
    "$trace" -o "$out/counted" --clock instructions -- "$oscillator" 1000000000 >"$out/output" && grep -qx 'instructions_per_step 0' "$out/output"
expect $? "instructions of interrupts that come during a step are told"

# script TEXT LINE: the simulated tick refuses the script and names its line.
script()
{
    printf '%b' "$1" >"$out/script"
    ! "$oscillator" 1000000 "$out/script" >/dev/null 2>"$out/errors" && grep -q "^$out/script:$2: " "$out/errors"
    expect $? "script refused at line $2: $(tail -n 1 "$out/script")"
}

script 'hurry 5\n' 1
script '# nothing\n\nlate 5\n' 3
script 'late 0 1us\n' 1
script 'late -1 1us\n' 1
script 'late 18446744073709552 1us\n' 1
script 'late 5 300\n' 1
script 'late 5 300 us\n' 1
script 'slow 5 3601s\n' 1
script 'slow 5 99999999999999999999ns\n' 1
script 'lose 7 1us\n' 1
script 'lose 7\nlose 7\n' 2
! "$oscillator" 1000000 "$out/nowhere" 2>"$out/errors" && grep -q "^$out/nowhere: No such" "$out/errors"
expect $? "a script that does not exist"
! "$oscillator" 1s 2>"$out/errors" && grep -q "'1s'" "$out/errors"
expect $? "a duration that is not a number"

# emulate FIRMWARE ARGUMENT: runs it on the board.
emulate()
{
    qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none -serial none \
        -semihosting-config "enable=on,target=native,arg=plant,arg=$2" -kernel "$1" </dev/null
}

isochron run models/double_pendulum.scene --target cortex-m4f --seconds 10
expect $? "a run on the board"
firmware=$out/project/build/cortex-m4f/float/double_pendulum/program.elf
emulate "$firmware" 10000000000 >"$out/stream"
emulate "$firmware" 10000000000 | { sleep 1 && cat; } | cmp -s - "$out/stream"
expect $? "a reader slower than the board loses nothing and costs the board no time"

# board TEXT NAME STATEMENT: a program on the board that executes the statement ends with a message and status 1.
board()
{
    printf '#include "port/port.h"\nint main(void)\n{\n%s\nreturn 0;\n}\n' "$3" >"$out/fault.c"
    arm-none-eabi-gcc -std=c11 -O1 -I. -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -nostartfiles \
        --specs=nano.specs -T port/mps2/mps2.ld "$out/fault.c" port/mps2/*.c -o "$out/fault.elf" &&
        emulate "$out/fault.elf" 0 >"$out/output" 2>"$out/errors"
    [ $? -eq 1 ] && cat "$out/output" "$out/errors" | grep -Eq "$1"
    expect $? "the board tells of $2"
}

board '^Bail out! fault 0x00008200 at 0x' 'an address without memory' '*(volatile int *)0x60000000 = 1;'
board '^Bail out! fault 0x00010000 at 0x' 'an undefined instruction' '__asm__ volatile("udf #0");'
board '^Bail out! fault 0x000000.2$' 'a stack that is too deep' \
    'for (;;) __asm__ volatile("push {r0-r7}" ::: "memory");'
finish
