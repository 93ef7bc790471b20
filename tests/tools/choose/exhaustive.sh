#!/bin/sh
# exhaustive.sh FOLDER [PARTS]: whether what `isochron choose` took in FOLDER is the cheapest. Tries every method,
# without and with compensated sums, at every tick and with every number of steps in it, whose cost can be up to that of
# what it took; prints `kept METHOD COMPENSATED K N CYCLES LOAD RATIO SHARE` for each that keeps the bounds and costs so
# little, SHARE of what it took, and `tried N`. The cost of a method at one step in the scene's tick is counted;
# compensated sums only add to it, and each further step has at least the operations of its evaluations. A step of
# another length takes a cycle or two more or less, for which a hundredth is added. Of adams every number of sub-steps
# is tried at every tick, with each of three tolerances. With PARTS one place of so many is tried, and that which it
# took.
. "$1/settings"
. tools/measure/choose/parts.sh
parts=${2:-1}
took=$(awk '{ print $3, $4 }' "$dir/best")
most=$(awk '{ print 1.01 * $6 }' "$dir/best")

# cheaper CYCLES EVALUATIONS METHOD: `K N` of every place that can cost less, where one step in the scene's tick takes
# so many cycles.
cheaper()
{
    echo "$long_ticks" | awk -v period="$period" -v rows="$rows" -v every="$every" -v cycles="$1" -v evaluations="$2" -v each="$each" -v hz="$hz" \
        -v most="$most" -v parts="$parts" -v took="$took" -v method="$3" -v longest="$longest" '
        function load_of(k, n) { return (cycles + (n - 1) * evaluations * each) / hz / (period * k) * 1e11 }
        function place(k, n) { if (load_of(k, n) < most && (tried++ % parts == 0 || k " " n == took)) print k, n }
        {
            if (method == "adams") {
                for (n = 1; n <= 1024; n *= 2) place(1, n)
                for (i = 1; i <= NF; i++)
                    for (n = 1; n <= 64 && $i <= longest && $i * period <= 1e9 && $i * every * 8 <= rows; n *= 2) place($i, n)
                exit
            }
            place(1, 1)
            for (i = 1; i <= NF; i++) {
                if ($i <= longest && $i * period <= 1e9 && $i * every * 8 <= rows) place($i, 1)
                if (period % $i == 0 && period / $i >= 1000) place(1, $i)
            }
        }'
}

# count METHOD COMPENSATED K N: $counted is what `cycles` says.
count()
{
    of=$dir/exhaustive-$1-$2
    cycles_at "$of" "$1" "$2" "$3" "$4"
}

# of METHOD COMPENSATED
of()
{
    [ "$2" = yes ] || { count "$1" no 1 1 && once=$counted; } || return
    case $1 in
    adams-*) evaluations=2 ;;
    *) evaluations=$(awk -v method="$1" '$2 == method { print $6 }' "$dir/methods") ;;
    esac
    cheaper "${once% *}" "$evaluations" "${1%%-*}" >"$dir/places"
    while read -r k n; do
        sh tools/measure/choose/try.sh "$1" "$2" "$k" "$n" >"$dir/tried"
        read -r ratio rest <"$dir/tried"
        case $ratio in
        *e-*) ;;
        inf | 1.* | [2-9]* | [1-9][0-9]* | *e+*) continue ;;
        esac
        count "$1" "$2" "$k" "$n" && awk -v most="$most" -v ratio="$ratio" -v what="kept $1 $2 $k $n" \
            '$2 < most && ratio <= 1 { print what, $0, ratio, 1.01 * $2 / most }' "$of/counted"
    done <"$dir/places"
    echo "tried $(wc -l <"$dir/places")"
}

for method in $METHODS; do
    case $method in
    adams)
        for tolerance in 1e-04 1e-06 1e-08; do
            of adams-$tolerance no
        done
        ;;
    *)
        of "$method" no
        of "$method" yes
        ;;
    esac
done | awk '/^tried/ { tried += $2 } /^kept/ { print } END { print "tried", tried + 0 }'
