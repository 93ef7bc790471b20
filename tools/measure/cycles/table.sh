#!/bin/sh
# The cycles of the dearest tick of each model on four cores, and how much of its step that is at some clocks, as a
# Markdown table. Called by `make cycles`, with the make to call in $MAKE and the scenes in $MODELS. With $TURN only
# some rows (`due` of tools/measure/common.sh); with $CORES only these cores, and dots for the others
# (tests/tools/cycles/cycles.t).
WHAT='make cycles'
. tools/measure/common.sh
cores=${CORES:-cortex-m4f cortex-m3 cortex-m0 atmega1284p}

# add_cells MODEL TARGET MHZ...: adds to $cells the cycles, and the load at each clock; dashes where the target has no
# room for the program.
add_cells()
{
    dir=${1##*/}
    dir=build/cost/cycles/$2/${dir%.scene}
    folders "$dir"
    : >"$dir/cycles.tsv"
    # It fails where the tick is longer than the step, too.
    make_alone "$2/float" "$dir" cycles SCENE="$1" CLOCK=100MHz >"$dir/said" 2>&1 </dev/null
    shift 2
    if [ ! -s "$dir/cycles.tsv" ]; then
        grep -q "region .* overflowed\|relocation truncated\|will not fit" "$dir/said" ||
            fail "no cycles of $dir; see $dir/said"
        add_same ' - |' cycles "$@"
        return
    fi
    awk -F '\t' -v clocks="$*" '
        $1 == "part" && $2 == "tick" { cycles = $5 }
        $1 == "load_percent" { load = $3 }
        END {
            printf " %.0f |", cycles
            n = split(clocks, mhz, " ")
            for (i = 1; i <= n; i++) {
                percent = load * 100 / mhz[i]
                printf (percent < 10 ? " %.2f %% |" : percent < 100 ? " %.1f %% |" : " %.0f %% |"), percent
            }
            print ""
        }' "$dir/cycles.tsv" >"$dir/cells"
    IFS= read -r more <"$dir/cells"
    cells=$cells$more
}

# add_same CELL WORD...: the cell for each of the words.
add_same()
{
    same=$1
    shift
    for _; do
        cells=$cells$same
    done
}

echo '| model | step | Cortex-M4F | 84 MHz | 168 MHz | Cortex-M3 | 84 MHz | 168 MHz | Cortex-M0 | 84 MHz | 168 MHz | AVR | 20 MHz |'
echo '|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|'
row=-1
for scene in $MODELS; do
    due || continue
    name=${scene##*/}
    name=${name%.scene}
    line="| $name |"
    cells=
    for asked in 'cortex-m4f 84 168' 'cortex-m3 84 168' 'cortex-m0 84 168' 'atmega1284p 20'; do
        case " $cores " in
        *" ${asked%% *} "*) ;;
        *) add_same ' . |' $asked && continue ;;
        esac
        # shellcheck disable=SC2086
        add_cells "$scene" $asked
    done
    step=$(awk '$1 == "step" && $3 == "s" { print $2 * 1000 " ms" }' "build/cost/cycles/cortex-m4f/$name/plant.txt")
    echo "$line $step |$cells"
done
