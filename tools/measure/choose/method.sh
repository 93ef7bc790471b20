#!/bin/sh
# method.sh METHOD: the cheapest of a method that keeps the bounds, without and with compensated sums. Writes
# $dir/found/METHOD-no and -yes: `METHOD COMPENSATED K N CYCLES LOAD NEXT RATIO BOUND ROW ERROR...`, NEXT the ratio of
# one step coarser, `-` if there is none; or `METHOD COMPENSATED none WHY ...`. Called by choose.sh.
. tools/measure/choose/parts.sh
method=$1 file=$1
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

# tick_of_adams N: cycles of the dearest tick of so many sub-steps, at the scene's step.
tick_of_adams()
{
    of=$dir/count-adams-$1
    mkdir -p "$of"
    compute choose/edit -v statements="$(statements "$1" no adams-1e-06)" "$dir/base.scene" >"$of/$NAME.scene"
    counted=$(cycles "$of" "$of/$NAME.scene" adams "$period") || fail "the cycles of adams cannot be counted; see $of/said"
    echo "${counted% *}"
}

# search_adams: what adams.awk finds. The cheapest that was found bounds what is tried.
search_adams()
{
    one=$(tick_of_adams 1) && eight=$(tick_of_adams 8) || exit 255
    least=$(cat "$dir"/best-* 2>/dev/null | awk -v limit="$limit" 'BEGIN { least = limit } $1 < least { least = $1 } END { print least }')
    compute choose/adams -v one="$one" -v more=$(((eight - one) / 7)) -v least="$least" -v ticks="$(long_ticks)" -v period="$period" -v rows="$rows" \
        -v every="$every" -v longest="$longest"
}

# count COMPENSATED: of what search found, with its cycles.
count()
{
    compensated=$1
    # shellcheck disable=SC2046
    set -- $(sed -n 's/^found //p' "$dir/found/$file-$compensated.search")
    if [ $# -eq 0 ]; then
        echo "$method $compensated $(cat "$dir/found/$file-$compensated.search")"
        return
    fi
    k=$1 n=$2
    place=$3
    shift 3
    of=$dir/count-$file-$compensated
    mkdir -p "$of"
    compute choose/edit -v statements="$(statements "$n" "$compensated" "$method")" "$dir/base.scene" >"$of/$NAME.scene"
    counted=$(cycles "$of" "$of/$NAME.scene" "$method" $((period * k))) ||
        fail "the cycles of $method cannot be counted; see $of/said"
    next=$(awk '$1 == "next" { print $4 }' "$dir/found/$file-$compensated.search")
    echo "$method $compensated $k $n $counted ${next:--} $*"
    # Cycles per second, of what may be taken.
    echo "$counted" | awk -v hz="$hz" -v load="$load" '$2 <= load { print $2 / 100 * hz }' >"$dir/best-$file-$compensated"
}

if [ "$method" = adams ]; then
    search_adams >"$dir/found/adams-no.search"
    method=$(awk '$1 == "found" { print $2; had++ } END { if (!had) print "adams" }' "$dir/found/adams-no.search")
    sed -i 's/^found [^ ]*/found/' "$dir/found/adams-no.search"
    count no >"$dir/found/adams-no" || exit 255
    : >"$dir/found/adams-yes"
else
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
fi
book 1
cat "$dir/found/$file-no" "$dir/found/$file-yes" |
    compute choose/bound -f tools/measure/choose/told.awk -v what=progress -v period="$period" -v hz="$hz" \
        -v said="choose: $count of $total: $file" "$dir/columns" - >&2
