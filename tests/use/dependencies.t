#!/bin/sh
# make builds what a change asks for, and nothing else: after every kind of change something is rebuilt, and then
# nothing.
. tests/host/test.sh
. tests/host/project.sh
begin check/dependencies
project
unoptimised clang

program=build/host/float/double_pendulum/double_pendulum
scene=$out/project/models/double_pendulum.scene

newline='
'
# state: $state has sizes, dates and names of everything built, a line each, but for the tables, which every run writes
# anew. Where nothing is built, find meets all in the same order.
state()
{
    state=$(find "$out/project/build" -type f ! -name 'trace.csv*' ! -name 'units.csv*' ! -name 'last.txt*' -printf '%s %T@ build/%P\n')$newline
}

# line_of FILE STATE: $line is what a state has of the file; fails where that is nothing.
line_of()
{
    line=${2%%" $1$newline"*}
    [ "$line" != "$2" ] && line=${line##*"$newline"}
}

# built FILE...: the last call made these anew since the state in $before; the state is $after then.
built()
{
    state && after=$state
    for file in "$@"; do
        line_of "$file" "$after" || return 1
        line_after=$line
        ! line_of "$file" "$before" || [ "$line" != "$line_after" ] || return 1
    done
}

# unbuilt FILE...: the last call left these as they were.
unbuilt()
{
    state && after=$state
    for file in "$@"; do
        line_of "$file" "$after" || return 1
        line_after=$line
        line_of "$file" "$before" && [ "$line" = "$line_after" ] || return 1
    done
}

# still ARGUMENT...: after a call with the state $after behind it, another one builds nothing.
still()
{
    call run SECONDS=1 "$@" && state && [ "$state" = "$after" ]
}

# change NAME FILES ARGUMENT...: after what was altered just now, make builds FILES and then nothing.
change()
{
    name=$1
    files=$2
    shift 2
    # shellcheck disable=SC2086
    call run SECONDS=1 "$@" && built $files
    expect $? "$name: builds anew $files"
    still "$@"
    expect $? "$name: then nothing"
}

# touched FILE: its date is now, and later than that of all that was built before, of which the last state tells.
touched()
{
    before=$state
    touch "$out/project/$1"
}

call run SECONDS=1 && state && after=$state && still
expect $? "nothing changed: nothing built"

touched core/numbers/real.h
change "core/numbers/real.h" "$program build/obj/host/float/core/runtime/loop.o build/host/float/double_pendulum/plant.o"
touched core/numbers/sincos.h
change "core/numbers/sincos.h, which the plant includes" "$program build/host/float/double_pendulum/plant.o"
touched core/runtime/loop.c
change "core/runtime/loop.c" "$program build/obj/host/float/core/runtime/loop.o"
unbuilt build/isoc
result $? "core/runtime/loop.c: the scene compiler is left alone"
touched port/host/script.h
change "port/host/script.h" "$program build/obj/host/float/port/host/sim.o"
touched tools/isoc/graph/graph.h
change "tools/isoc/graph/graph.h" "build/isoc build/host/float/double_pendulum/plant.c"
touched tools/trace/main.c
change "tools/trace/main.c" "build/trace"

before=$state
sed -i 's/^body upper {/& # a heavier one/; s/mass 1 kg/mass 2 kg/' "$scene"
change "the scene" "$program build/host/float/double_pendulum/plant.c"
cp models/double_pendulum.scene "$scene"

printf 'include "weight.scene"\n' >>"$scene"
echo 'constant unused = 1' >"$out/project/models/weight.scene"
call run SECONDS=1 && state && before=$state
echo 'tunable unused = 1' >"$out/project/models/weight.scene"
change "a file that the scene includes" "$program build/host/float/double_pendulum/plant.c"
rm "$out/project/models/weight.scene"
! call run SECONDS=1 && grep -q "cannot include 'weight.scene': No such file" "$out/errors"
expect $? "an included file that is gone: told"
cp models/double_pendulum.scene "$scene"
call run SECONDS=1 && state && before=$state

change "METHOD" "$program build/host/float/double_pendulum/plant.o" METHOD=heun
printed method heun
expect $? "METHOD: the program that ran is the new one"
before=$state
change "STEP" "$program build/host/float/double_pendulum/plant.o" STEP=2ms
printed ticks 500
expect $? "STEP: the program that ran is the new one"
before=$state
call run SECONDS=2 STEP=2ms && printed ticks 1000 && unbuilt $program build/isoc
expect $? "SECONDS: builds nothing and runs for longer"
before=$state
call run SECONDS=1 REAL=double && unbuilt $program build/isoc &&
    [ -x "$out/project/build/host/double/double_pendulum/double_pendulum" ]
expect $? "REAL: builds beside, in a folder of its own"

before=$state
change "METHOD of a plant in C" "build/host/float/oscillator/oscillator" SCENE=models/oscillator.c METHOD=heun
printed method heun
expect $? "METHOD of a plant in C: the program that ran is the new one"
touched models/oscillator.c
change "a plant in C" "build/host/float/oscillator/oscillator" SCENE=models/oscillator.c METHOD=heun

# A flag that changes no object, so that none is compiled for it; the step is that of the last program. All that follows
# keeps it: a change builds everything.
before=$state
change "CFLAGS" "$program build/obj/host/float/core/runtime/loop.o build/host/float/double_pendulum/plant.o" CFLAGS=-MP STEP=2ms
before=$state
call build/isoc build/trace CFLAGS='-MP -include port/stm32f4/pins_example.h' && unbuilt build/isoc build/trace build/obj/tools/flags
expect $? "a file that CFLAGS include, for a plant's program: no tool is built"
flags=$out/project/build/obj/tools/flags
cp -p "$flags" "$out/flags"
call build/obj/tools/flags CFLAGS='-MP -DPLANTED' && built build/obj/tools/flags
expect $? "control: they would be for another flag"
cp -p "$out/flags" "$flags"

# A Makefile that forgets a header is found: without the lists of included files, a touched header builds nothing, if it
# is no part of isoc.
sed -i 's/^-include .*//' "$out/project/Makefile" "$out/project/tools/build/goals.mk" "$out/project/tools/build/tools.mk"
call run SECONDS=1 CFLAGS=-MP && state
touched core/runtime/loop.h
! { call run SECONDS=1 CFLAGS=-MP && built $program; }
expect $? "found: headers that make does not know of"
finish
