# shellcheck shell=sh
# Instructions of a step, counted by callgrind; read after tests/host/test.sh and `begin`. Programs are linked with
# tests/promises/handwritten/count.c.

# per_step PROGRAM [FUNCTION [derivative]]: instructions of a step, the loop around it included, or of a call of that
# function, all that it calls included; fails unless every thousand cost the same. Callgrind writes what it counts in
# each call of count_steps, of two, three and four thousand steps; the first call has what comes before it.
per_step()
{
    rm -f "$out"/callgrind.*
    valgrind --quiet --tool=callgrind --callgrind-out-file="$out/callgrind" --dump-after=count_steps ${2+"--toggle-collect=$2"} \
        "$1" ${3+"$3"} &&
        sed -s -n 's/^totals: //p' "$out/callgrind.2" "$out/callgrind.3" "$out/callgrind.4" | awk '
            { count[NR] = $1 }
            END {
                step = (count[2] - count[1]) / 1000
                print int(step)
                exit !(NR == 3 && step > 0 && step == int(step) && count[3] - count[2] == 1000 * step)
            }'
}

# at_most_tenth_over GENERATED HAND: generated <= 1.1 x hand.
at_most_tenth_over()
{
    [ "$1" -gt 0 ] && [ $((10 * $1)) -le $((11 * $2)) ]
}
