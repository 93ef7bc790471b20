#!/bin/sh
# method.sh METHOD: the cheapest of a method that keeps the bounds, without and with compensated sums. Writes
# $dir/found/METHOD-no and -yes: `METHOD COMPENSATED K N CYCLES LOAD NEXT RATIO BOUND ROW ERROR...`, NEXT the ratio of
# one step coarser, `-` if there is none; or `METHOD COMPENSATED none WHY ...`. Called by choose.sh.
. tools/measure/choose/parts.sh
method=$1
order=$(awk -v method="$method" '$2 == method { print $4 }' "$dir/methods")
evaluations=$(awk -v method="$method" '$2 == method { print $6 }' "$dir/methods")

# most_steps: in a tick of the scene, so that the evaluations alone take no more than the cheapest that was found, or
# the load.
most_steps()
{
    cat "$dir"/best-* 2>/dev/null | awk -v limit="$limit" -v evaluations="$evaluations" -v each="$each" -v period="$period" '
        BEGIN { least = limit }
        $1 < least { least = $1 }
        END { printf "%d\n", least * period * 1e-9 / (evaluations * each) }'
}

# search COMPENSATED [OPTION...]: what search.awk finds.
search()
{
    search_compensated=$1
    shift
    compute choose/search -v method="$method" -v compensated="$search_compensated" -v order="$order" -v most_n="$(most_steps)" \
        -v period="$period" -v rows="$rows" -v every="$every" -v longest="$longest" "$@" >"$dir/found/$method-$search_compensated.search"
    cat "$dir/found/$method-$search_compensated.search"
}

# count COMPENSATED: of what search found, with its cycles.
count()
{
    compensated=$1
    # shellcheck disable=SC2046
    set -- $(sed -n 's/^found //p' "$dir/found/$method-$compensated.search")
    if [ $# -eq 0 ]; then
        echo "$method $compensated $(cat "$dir/found/$method-$compensated.search")"
        return
    fi
    k=$1 n=$2
    place=$3
    shift 3
    of=$dir/count-$method-$compensated
    mkdir -p "$of"
    compute choose/edit -v statements="$(statements "$n" "$compensated")" "$dir/base.scene" >"$of/$NAME.scene"
    counted=$(cycles "$of" "$of/$NAME.scene" "$method" $((period * k))) ||
        fail "the cycles of $method cannot be counted; see $of/said"
    next=$(awk '$1 == "next" { print $4 }' "$dir/found/$method-$compensated.search")
    echo "$method $compensated $k $n $counted ${next:--} $*"
    # Cycles per second, of what may be taken.
    echo "$counted" | awk -v hz="$hz" -v load="$load" '$2 <= load { print $2 / 100 * hz }' >"$dir/best-$method-$compensated"
}

search no >"$dir/found/$method.line"
count no >"$dir/found/$method-no" || exit 255
# Compensated sums add instructions to each step: they pay where they make it longer.
if grep -q '^found' "$dir/found/$method.line"; then
    place=$(awk '$1 == "found" { print $4 }' "$dir/found/$method.line")
    search yes -v from=$((place + 1)) -v only=coarser >/dev/null
else
    search yes >/dev/null
fi
count yes >"$dir/found/$method-yes" || exit 255
count=1
while ! mkdir "$dir/done/$count" 2>/dev/null; do
    count=$((count + 1))
done
cat "$dir/found/$method-no" "$dir/found/$method-yes" |
    compute choose/told -v what=progress -v period="$period" -v hz="$hz" -v said="choose: $count of $total: $method" "$dir/columns" - >&2
