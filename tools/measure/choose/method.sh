#!/bin/sh
# method.sh METHOD: the cheapest of a method that keeps the bounds, without and with compensated sums. Writes
# $dir/found/METHOD-no and -yes: `METHOD COMPENSATED K N CYCLES LOAD NEXT RATIO BOUND ROW ERROR...`, NEXT the ratio of
# one step coarser, `-` if there is none; or `METHOD COMPENSATED none WHY ...`, where WHY is `unpriced` if make cycles
# could not count the cycles. Called by choose.sh.
. tools/measure/choose/parts.sh
method=$1 file=$1
order='' evaluations=''
while read -r _ word _ its_order _ its_evaluations _; do
    [ "$word" != "$method" ] || order=$its_order evaluations=$its_evaluations
done <"$dir/methods"

# least_rate: $least, cycles per second: those of the cheapest that was found, or the load.
least_rate()
{
    awk -v limit="$limit" 'BEGIN { least = limit } $1 < least { least = $1 } END { print least }' "$dir"/best-* >"$dir/found/$file.least"
    read -r least <"$dir/found/$file.least"
}

# search COMPENSATED [OPTION...]: $dir/found/METHOD-COMPENSATED.search has the result of search.awk.
search()
{
    search_compensated=$1
    shift
    least_rate
    compute choose/search -v method="$method" -v compensated="$search_compensated" -v order="$order" -v least="$least" \
        -v evaluations="$evaluations" -v each="$each" -v ticks="$long_ticks" -v period="$period" -v rows="$rows" -v every="$every" \
        -v longest="$longest" "$@" >"$dir/found/$method-$search_compensated.search"
}

# found_in FILE: $found is the text behind `found` in it, empty for `none`; $next the ratio behind `next`, or `-`; and
# $method that behind `method`, if it is there.
found_in()
{
    found='' next=-
    while read -r word rest; do
        case $word in
        method) method=$rest ;;
        found) found=$rest ;;
        next) next=${rest#* * } && next=${next%% *} ;;
        esac
    done <"$1"
}

# unpriced FOLDER: why make cycles did not count what it made there, in its own words.
unpriced()
{
    awk '
        /^cycles: / { sub(/^cycles: /, ""); why = $0 }
        /region .* overflowed|will not fit/ && why == "" { why = "the program does not fit into the memory" }
        { last = $0 }
        END { print "none unpriced", (why != "" ? why : last) }' "$1/said"
}

# tick_of_adams N: $tick, cycles of the dearest tick of so many sub-steps, at the scene's step.
tick_of_adams()
{
    of=$dir/count-adams-$1
    cycles_at "$of" adams-1e-06 no 1 "$1" && tick=${counted% *}
}

# search_adams: the result of adams.awk. Only candidates below the cheapest that was found are tried.
search_adams()
{
    { tick_of_adams 1 && one=$tick && tick_of_adams 8 && eight=$tick; } || { unpriced "$of" && return; }
    least_rate
    compute choose/adams -v one="$one" -v more=$(((eight - one) / 7)) -v least="$least" -v ticks="$long_ticks" -v period="$period" -v rows="$rows" \
        -v every="$every" -v longest="$longest"
}

# count COMPENSATED: the line of the result of search, with its cycles.
count()
{
    compensated=$1
    found_in "$dir/found/$file-$compensated.search"
    # shellcheck disable=SC2086
    set -- $found
    if [ $# -eq 0 ]; then
        read -r text <"$dir/found/$file-$compensated.search"
        echo "$method $compensated $text"
        return
    fi
    k=$1 n=$2
    place=$3
    shift 3
    of=$dir/count-$file-$compensated
    cycles_at "$of" "$method" "$compensated" "$k" "$n" || {
        echo "$method $compensated $(unpriced "$of")"
        return
    }
    echo "$method $compensated $k $n $counted $next $*"
    # Cycles per second, of a candidate within the load.
    awk -v hz="$hz" -v most_load="$load" '$2 <= most_load { print $2 / 100 * hz }' "$of/counted" >"$dir/best-$file-$compensated"
}

if [ "$method" = adams ]; then
    search_adams >"$dir/found/adams-no.search"
    count no >"$dir/found/adams-no"
    : >"$dir/found/adams-yes"
else
    search no
    count no >"$dir/found/$method-no"
    # Compensated sums add instructions to each step: they pay if they allow a longer one.
    found_in "$dir/found/$method-no.search"
    # shellcheck disable=SC2086
    set -- $found
    if [ $# -gt 0 ]; then
        search yes -v from=$(($3 + 1)) -v only=coarser
    else
        search yes
    fi
    count yes >"$dir/found/$method-yes"
fi
book
compute choose/bound -f tools/measure/choose/told.awk -v what=progress -v period="$period" -v hz="$hz" \
    -v said="choose: $count of $total: $file" "$dir/columns" "$dir/found/$file-no" "$dir/found/$file-yes" >&2
