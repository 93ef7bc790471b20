#!/bin/sh
# PORT_OPTIMISE of each port is the optimisation with which a step takes least: on the Cortex-M4F by cycles, on the host
# by instructions; -O2 where none takes much less.
. tests/host/test.sh
. tests/host/project.sh
begin check/flags
project

# One of the two targets by turns, both with the argument `all`.
turn=$(turn_of 2 "${1-}" core tools models)
echo "# turn $turn of the targets"

# least TABLE COLUMN: the optimisation that its last row recommends: -O2, or the least of those that take a twentieth
# less.
least()
{
    awk -F ' *[|] *' -v column="$2" '
        NR == 1 { for (i = 2; i < NF; i++) name[i] = $i }
        /^[|] relative to -O2/ {
            best = "-O2"
            lowest = 0.95
            for (i = 2; i < NF; i++) {
                level = name[i]
                if ((column == "cycles") != (level ~ /, cycles$/)) continue
                sub(/, cycles/, "", level)
                if (level ~ /^-O/ && $i + 0 < lowest) {
                    lowest = $i + 0
                    best = level
                }
            }
            print best
        }' "$1"
}

# chosen TARGET PORT COLUMN ARGUMENT...: by plants with and without effects, and with a closed loop.
chosen()
{
    target=$1
    port=$2
    column=$3
    shift 3
    isochron flags --target "$target" --models "models/double_pendulum.scene models/cart_pole_drive.scene models/four_bar.scene" "$@"
    expect $? "isochron flags on $target"
    grep '^|' "$out/output" | sed 's/^/# /'
    used=$(of_port "$port" PORT_OPTIMISE)
    grep '^|' "$out/output" >"$out/table"
    [ -n "$used" ] && [ "$(least "$out/table" "$column")" = "$used" ]
    result $? "$target: $used is in use, and is what the table recommends"
}

# found COLUMN LEVEL: the table of the last target, with half in its last column, recommends that level.
found()
{
    sed '/relative/s/| [0-9.]* |$/| 0.5 |/' "$out/table" >"$out/other"
    [ "$(least "$out/other" "$1")" = "$2" ]
    result $? "found: a table that recommends another"
}

if [ "$turn" != 1 ]; then
    chosen cortex-m4f mps2 cycles
    stated port/README.md "$(awk -F ' *[|] *' '/^[|] relative/ {
        printf "-Os takes %s of the instructions of -O2 and %s of its cycles, -O3 %s of its cycles", $7, $8, $10
    }' "$out/table")"
    result $? "port/README.md has these parts"
    found cycles -O3
fi
if [ "$turn" != 0 ]; then
    chosen host host instructions --real double
    found instructions -O3
fi
finish
