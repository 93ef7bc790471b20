#!/bin/sh
# The monitor at a plant of the host: its table, a tunable that is set, a record against the trace of the same run, its
# replay, and what it says of mistakes. Nothing here is of a length of time: the run lasts until it is ended, whoever
# looks on does until so many ticks are done, and whoever waits waits for an event, or for the time that a test has
# (tests/harness/tap.py).
. tests/host/test.sh
. tests/host/project.sh
begin xcp/monitor
plant=
controller=
trap '[ -z "$plant" ] || kill "$plant" 2>/dev/null; [ -z "$controller" ] || kill "$controller" 2>/dev/null' EXIT
project
isochron a2l tests/core/xcp/masters/cart.scene --xcp open
status=$?
a2l=$out/project/$(value a2l)
program=$out/project/$(value program)
expect $status "a plant with its A2L is built"

# monitor ARGUMENT...: at a plant with as much patience as the test has.
monitor()
{
    case $* in
    *--replay*) build/monitor "$@" ;;
    *) build/monitor "$@" --patience 1800 ;;
    esac
}

# refused WORDS ARGUMENT...: the monitor ends with status 1 and says these words, and nothing else.
refused()
{
    words=$1
    shift
    monitor "$@" >"$out/output" 2>"$out/errors"
    [ $? -eq 1 ] && grep -qF "$words" "$out/errors" && [ ! -s "$out/output" ] && [ "$(wc -l <"$out/errors")" -eq 1 ]
    refused_status=$?
    [ $refused_status -eq 0 ] || sed 's/^/# /' "$out/errors"
    result $refused_status "refused: $words"
}

: >"$out/said"
ISOCHRON_CONTROLLER=unix:$out/controller ISOCHRON_CALIBRATION=tcp:0 build/trace -o "$out" -- "$program" 1000000000000000 \
    >"$out/summary" 2>"$out/said" &
plant=$!
waited "$plant" grep -q tcp: "$out/said"
at=$(sed -n 's/.* waiting at \(tcp:.*\)/\1/p' "$out/said")

monitor "$a2l" "$at" --once >"$out/table" && grep -q '^p.rod_mass  *0.2 kg ' "$out/table" &&
    grep -q '^x.hinge_speed .* rad/s ' "$out/table" && grep -q 'execution_max  *[0-9]' "$out/table"
result $? "a table with names, values, units and statistics, before a run"
monitor "$a2l" "$at" --do 'set reading_active = 1' --do 'set p.rod_mass = 0.3' >"$out/table" &&
    grep -q '^p.rod_mass  *0.3 kg ' "$out/table" && grep -q '^p.reading_active  *1 1 ' "$out/table"
result $? "a tunable and a fault are set"
refused 'p.rod_mass must be from 0.05 to 1 kg' "$a2l" "$at" --do 'set rod_mass = 2'
refused 'p.rod_mass must be from 0.05 to 1 kg' "$a2l" "$at" --do 'set rod_mass = nan'
refused 'x.rail is no tunable and no fault' "$a2l" "$at" --do 'set x.rail = 1'
refused 'there is no rod_mas' "$a2l" "$at" --do 'set rod_mas = 1'
refused 'expected set NAME = VALUE' "$a2l" "$at" --do 'set rod_mass 1'
refused "'go' is no command" "$a2l" "$at" --do go
refused 'No such file' "$a2l" "$at" --record "$out/absent/record"
sed 's/EPK "[0-9a-f]*"/EPK "0"/' "$a2l" >"$out/other.a2l"
refused 'the A2L is of 0: another program' "$out/other.a2l" "$at"

ISOCHRON_LINK=unix:$out/controller python3 -B tests/core/xcp/masters/paced.py "$(dirname "$program")" "$out/stop" 2>"$out/ended" &
controller=$!
monitor "$a2l" "$at" --seconds 1 --ticks 400 --record "$out/record.csv" >"$out/table"
result $? "records for a second and 400 ticks"
grep -q '^y.pole .*[▁▂▃▄▅▆▇█].*[▁▂▃▄▅▆▇█]' "$out/table" && sed -n 's/^y.pole .*rad *//p' "$out/table" >"$out/curve" &&
    [ "$(tr -d '\n' <"$out/curve" | wc -c)" -ge 27 ] && grep -q ▁ "$out/curve" && grep -q █ "$out/curve"
result $? "the table has curves of the run, from their least to their most"

# tick: that of the plant.
tick()
{
    monitor "$a2l" "$at" "$@" | tee "$out/table" | grep -o '^tick  *[0-9]*\| tick  *[0-9]*' | tr -dc 0-9
}

monitor "$a2l" "$at" --do pause >"$out/table"
first=$(tick) && [ "$first" -gt 0 ] && grep -q '^t .* s  rests$' "$out/table" && [ "$(tick)" = "$first" ]
result $? "a plant that is paused stays at its tick: $first"
monitor "$a2l" "$at" --do step --ticks 1 >"$out/table" && [ "$(tick)" -eq $((first + 1)) ]
result $? "a step is a tick"
monitor "$a2l" "$at" --do 'step 20' --ticks 20 >"$out/table" && [ "$(tick)" -eq $((first + 21)) ]
result $? "20 steps are 20 ticks"
refused 'expected step or step N' "$a2l" "$at" --do 'step -'
# Snapshots: to one and on again for 20 ticks, without a wire to the inputs, which stay as the controller has set them.
second=$(tick)
monitor "$a2l" "$at" --do "snapshot $out/taken.bin" >"$out/table" && [ "$(head -c 4 "$out/taken.bin")" = ISOS ]
result $? "a snapshot is written: $(wc -c <"$out/taken.bin") bytes"
monitor "$a2l" "$at" --do 'step 20' --ticks 20 >"$out/table" && [ "$(tick)" -eq $((second + 20)) ]
result $? "20 steps on"
monitor "$a2l" "$at" --do "restore $out/taken.bin" >"$out/table" && grep -q '^t .* s  rests$' "$out/table" && [ "$(tick)" -eq "$second" ]
result $? "back at the snapshot, where it rests"
monitor "$a2l" "$at" --do "snapshot $out/again.bin" >"$out/table" && cmp "$out/taken.bin" "$out/again.bin"
result $? "with the same bytes, the hash among them"
monitor "$a2l" "$at" --do 'step 20' --ticks 20 >"$out/table" && [ "$(tick)" -eq $((second + 20)) ]
result $? "and 20 steps on: its controller goes along"
{ head -c 80 "$out/taken.bin" && printf '\252\125' && tail -c +83 "$out/taken.bin"; } >"$out/damaged.bin"
refused 'the snapshot is damaged' "$a2l" "$at" --do "restore $out/damaged.bin"
head -c 80 "$out/taken.bin" >"$out/short.bin"
refused 'the snapshot is not whole' "$a2l" "$at" --do "restore $out/short.bin"
refused 'this is no snapshot' "$a2l" "$at" --do "restore $a2l"
refused 'No such file' "$a2l" "$at" --do "restore $out/absent.bin"
refused 'No such file' "$a2l" "$at" --do "snapshot $out/absent/taken.bin"
[ "$(tick)" -eq $((second + 20)) ]
result $? "what is refused leaves it where it is"
monitor "$a2l" "$at" --do run --ticks 10 >"$out/table" && ! grep -q rests "$out/table"
result $? "it runs again"
touch "$out/stop"
wait "$controller"
controller=
wait "$plant"
plant=

# same RECORD: its columns of outputs are lines of the trace, one for each tick, without a gap. Prints how many.
same()
{
    cut -d, -f 1-8 "$1" | awk 'NR == FNR { line[$0] = FNR; next } FNR == 1 || FNR == 2 { last = line[$0] - 1 }
        FNR == 1 { bad = line[$0] != 1 }
        FNR > 1 { bad = bad || line[$0] != last + 1; last = line[$0] }
        END { print FNR - 1; exit bad || FNR <= 400 }' "$out/trace.csv" -
}

rows=$(same "$out/record.csv")
result $? "a record is a part of the trace, tick by tick: $rows rows"
head -n 1 "$out/record.csv" | grep -qx 't,cart_position,.*,force,push,reading_held'
result $? "behind the outputs it has the inputs"
awk 'NR != 100' "$out/record.csv" >"$out/gap.csv" && ! same "$out/gap.csv" >/dev/null
result $? "found: a tick that is missing"
awk -F, -v OFS=, 'NR == 100 { $4 += 0.001 } { print }' "$out/record.csv" >"$out/wrong.csv" && ! same "$out/wrong.csv" >/dev/null
result $? "found: a value that is another"

build/monitor "$a2l" --replay "$out/record.csv" >"$out/table" &&
    [ "$(awk '$1 == "y.pole" { print $2 }' "$out/table")" = "$(tail -n 1 "$out/record.csv" | awk -F, '{ printf "%.6g", $4 }')" ] &&
    grep -q '^u.force .* N  *[▁█]' "$out/table" && ! grep -q '^p\.' "$out/table"
result $? "a record is shown again, with its units and curves"
build/monitor "$a2l" --replay "$out/trace.csv" --once >"$out/table" && grep -q '^y.energy .* J ' "$out/table"
result $? "so is the trace of a run"

refused 'Connection refused' "$a2l" "$at"
refused "is no address" "$a2l" 5555
refused 'No such file' "$out/absent.a2l" "$at"
sed 's/FLOAT32_IEEE unit_2/FLOAT33_IEEE unit_2/' "$a2l" >"$out/bad.a2l"
refused "bad.a2l:$(grep -n FLOAT33 "$out/bad.a2l" | head -n 1 | cut -d: -f 1): 'FLOAT33_IEEE'" "$out/bad.a2l" "$at"
: >"$out/empty.a2l"
refused 'empty.a2l:1: ' "$out/empty.a2l" "$at"
printf 't,pole\n0,1\n0.1,x\n' >"$out/bad.csv"
refused 'bad.csv:3: expected 2 numbers' "$a2l" --replay "$out/bad.csv"
printf 't,pole,bole\n' >"$out/bad.csv"
refused "bad.csv:1: the A2L has no 'bole'" "$a2l" --replay "$out/bad.csv"
printf 'pole\n' >"$out/bad.csv"
refused 'bad.csv:1: a table begins with t' "$a2l" --replay "$out/bad.csv"
build/monitor 2>"$out/errors"
[ $? -eq 2 ] && grep -q '^usage: monitor A2L ADDRESS' "$out/errors"
result $? "without arguments: how it is used"
finish
