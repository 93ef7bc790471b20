# shellcheck shell=sh
# The ways out if no candidate keeps the bounds within the load: a larger error, another chip, an effect less. Read
# by choose.sh; the last line says `none`.

# larger_error: the least error of all runs that were made, whose tick fits. A tick that was too dear stands for all
# with as many steps in a time.
larger_error()
{
    cat "$dir"/tries/* | awk '$5 != "inf" && $5 < 1000 { print $5, $0 }' | sort -g >"$dir/least"
    dear=1e9
    left=8
    while [ $left -gt 0 ] && read -r ratio method compensated k n errors; do
        awk -v n="$n" -v k="$k" -v dear="$dear" 'BEGIN { exit !(n / k < dear) }' || continue
        left=$((left - 1))
        of=$dir/least-$method-$compensated
        cycles_at "$of" "$method" "$compensated" "$k" "$n" || continue
        awk -v most_load="$load" '{ exit !($2 <= most_load) }' "$of/counted" || {
            dear=$(awk -v n="$n" -v k="$k" 'BEGIN { printf "%.17g", n / k }')
            continue
        }
        echo "$method $compensated $k $n $counted - $errors" >"$dir/least.line"
        echo "A larger error: ERROR='$(awk -F '|' -v ratio="$ratio" '
            { bound = $2 * $5 * (ratio > 1 ? ratio : 1) * 1.05; text = text (NR > 1 ? "; " : "") sprintf("%.2g %s of %s", bound, $4, $6) }
            END { print text }' "$dir/columns")': $(told take "$dir/least.line")."
        return
    done <"$dir/least"
    echo "A larger error: up to a thousand times as large, nothing that was tried fits into $load % of this chip."
}

# another_chip: the cheapest that keeps the bounds, whatever it takes of this chip, on the boards that have a unit for
# floats.
another_chip()
{
    best=$(told any "$dir/candidates")
    if [ -z "$best" ]; then
        limit=1e30
        rm -f "$dir"/best-*
        candidates $methods_of_another_chip
        best=$(told any "$dir/candidates")
    fi
    if [ -z "$best" ]; then
        echo "Another chip: none; in float no method that was tried keeps the bounds, however fast the chip."
        return
    fi
    echo "$best" >"$dir/best"
    clock=$(echo "$best" | awk -v hz="$hz" -v most_load="$load" '{ printf "%.3g MHz", hz * $6 / most_load / 1e6 }')
    echo "Another chip: $(told take "$dir/best"): a clock of $clock."
    # shellcheck disable=SC2086
    set -- $best
    # Where its cycles on this chip were counted.
    its_scene=$dir/count-${1%%-*}-$2/$NAME.scene
    grep -v '^#' tools/measure/cycles/boards.txt | tr -d ' ' | while IFS='|' read -r name target _ clock _; do
        case $target-$name in
        *-"$board" | *-mps2-*) continue ;;
        cortex-m4f-* | cortex-m7-*) ;;
        *) continue ;;
        esac
        TARGET=$target BOARD=$name CLOCK=$clock CORE=
        of=$dir/chip/$name
        cycles "$of" "$its_scene" "$1" $((period * $3)) || continue
        echo "    $name, TARGET=$target, at $clock: $(awk -v most_load="$load" '{ printf "%.3g %%%s\n", $2, ($2 <= most_load ? ", within the load" : "") }' "$of/counted")"
    done
}

# without EFFECT: the cheapest method without this effect, and how far its removal moves the outputs.
without()
{
    echo "choose: without $1" >&2
    if ! FOLDER=$FOLDER/without-$1 WITHOUT="${WITHOUT:+$WITHOUT; }$1" METHODS=$methods_of_another_chip KEEP='' NESTED=yes \
        sh tools/measure/choose/choose.sh >"$dir/without.txt" 2>/dev/null; then
        echo "    without $1: $(grep -q '^none' "$dir/without.txt" && echo "none either" || echo "it cannot be left out for this bound")"
        return
    fi
    for which in "$dir" "$dir/without-$1"; do
        reference_rows "$which" >"$which/reference.rows"
    done
    moved=$(paste "$dir/reference.rows" "$dir/without-$1/reference.rows" |
        compute choose/bound -f tools/measure/choose/apart.awk "$dir/columns" -)
    echo "    without $1: $(sed -n 's/^take: //p' "$dir/without.txt"); but that changes $moved"
}

[ -z "${NESTED-}" ] || {
    echo "none"
    exit 1
}
methods_of_another_chip=
for method in rk4 heun rosenbrock; do
    case " $METHODS " in
    *" $method "*) methods_of_another_chip="$methods_of_another_chip $method" ;;
    esac
done
[ -n "$methods_of_another_chip" ] || methods_of_another_chip=$METHODS
echo
echo "What would do:"
echo "$(larger_error)"
echo "$(another_chip)"
build/isoc "$dir/base.scene" --effects ${WITHOUT:+--without "$WITHOUT"} 2>/dev/null | awk '{ print $1 }' >"$dir/effects"
if [ -s "$dir/effects" ]; then
    echo "An effect less:"
    while read -r effect; do
        without "$effect"
    done <"$dir/effects"
fi
echo "none: no method keeps $ERROR within $load % of the chip"
