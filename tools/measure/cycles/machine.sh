#!/bin/sh
# The machine of `make cycles`: machine.sh TARGET CORE BOARD CLOCK, of which the last three may be empty. Prints the
# core's table, the clock in Hz, the board, and its bytes of flash and RAM; or a line with `error` and the problem.
cores=
for file in tools/measure/cycles/cores/"$1"*.txt; do
    file=${file##*/}
    [ "$file" = "$1*.txt" ] || cores="$cores ${file%.txt}"
done
if [ -z "$cores" ]; then
    case $1 in
    cortex-m33 | cortex-m55) why="of the Cortex-M${1#cortex-m} no published table of cycles is used here" ;;
    rv32*) why='the cycles of a RISC-V core are a matter of its maker, and no published table of one is used here' ;;
    stm32*) why='its core is a Cortex-M4F: TARGET=cortex-m4f, with BOARD and CLOCK, counts the same code' ;;
    *) why='a processor with caches and a system beside the plant has none' ;;
    esac
    echo "error make cycles has no table for TARGET=$1: $why. It can be:" \
        "$(awk -F ' *[|] *' '!/^#/ && !told[$2]++ { print $2 }' tools/measure/cycles/boards.txt | tr '\n' ' ')"
    exit
fi
exec awk -F ' *[|] *' -v tables="$cores" -v target="$1" -v core="$2" -v board="$3" -v clock="$4" '
    function refuse(text) { print "error " text; exit }
    # Hertz of a number with a unit; 0 if it is none.
    function hertz(text) {
        if (text !~ /^([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][0-9]+)? *[kMG]?Hz$/) return 0
        return text * (text ~ /kHz/ ? 1e3 : text ~ /MHz/ ? 1e6 : text ~ /GHz/ ? 1e9 : 1)
    }
    BEGIN {
        n = split(tables, name, " ")
        for (i = 1; i <= n; i++) known[name[i]]
    }
    /^#/ || $2 != target { next }
    { boards = boards " " $1 }
    board == "" ? chosen == "" : board == $1 { chosen = $1; own = $3; speed = $4; flash = $5; ram = $6 }
    END {
        if (chosen == "") refuse("BOARD=" board " is unknown; of TARGET=" target " it can be:" boards)
        if (core == "") core = own
        if (!(core in known)) refuse("CORE=" core " is no table of TARGET=" target "; it can be:" tables)
        if (clock == "") clock = speed
        hz = hertz(clock)
        if (hz < 1e3 || hz > 1e10) refuse("CLOCK=" clock " is no clock; it could be 168MHz, from 1kHz to 10GHz")
        printf "%s %.0f %s %s %s\n", core, hz, chosen, flash, ram
    }' tools/measure/cycles/boards.txt
