# shellcheck shell=sh
# Instructions of a step, counted by callgrind; read after tests/host/test.sh and `begin`. Programs are linked with
# tests/handwritten/count.c.

# instructions PROGRAM STEPS: what the program executes in all.
instructions()
{
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$1" "$2" 2>&1 | sed -n 's/.*Collected : //p'
}

# per_step PROGRAM: instructions of a step, the loop around it included; fails unless every thousand steps cost the same.
per_step()
{
    a=$(instructions "$1" 1000)
    b=$(instructions "$1" 2000)
    c=$(instructions "$1" 3000)
    echo $(((b - a) / 1000))
    [ -n "$a" ] && [ $((c - b)) -eq $((b - a)) ] && [ $(((b - a) % 1000)) -eq 0 ]
}

# at_most_tenth_over GENERATED HAND: generated <= 1.1 x hand.
at_most_tenth_over()
{
    [ "$1" -gt 0 ] && [ $((10 * $1)) -le $((11 * $2)) ]
}
