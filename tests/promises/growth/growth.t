#!/bin/sh
# How plants grow with a chain's length: memory and instructions of isoc, the longest function, and the factors of an
# implicit method, which say the same in each way and take as many instructions on every step.
. tests/host/test.sh
. tests/isoc/dynamics/formulation/evaluation.sh
. tests/host/project.sh
begin growth
one_isoc

for n in 8 25 32 50 64 200; do
    python3 tools/lab/chain.py $n spatial >"$out/spatial_$n.scene"
    python3 tools/lab/chain.py $n planar >"$out/planar_$n.scene"
done

# within KILOBYTES NAME METHOD: isoc makes the plant with so much memory.
within()
{
    (ulimit -v "$1" && build/isoc "$out/$2.scene" -o "$out/$2.$3" --method "$3") >"$out/$2.$3.summary" 2>"$out/errors"
}

# It takes 91, 32 and 43 MB.
within 150000 spatial_200 rk4
result $? "isoc takes less than 150 MB for a chain of 200 with rk4"
within 75000 planar_64 bdf4
result $? "and less than 75 MB for a chain of 64 in the plane with bdf4"
within 75000 spatial_64 bdf4
result $? "and for one in space"
! within 20000 spatial_200 euler
result $? "control: 20 MB are not enough for a chain of 200"

# counted N: thousands of instructions of isoc, with the derivative and the factors.
counted()
{
    valgrind --tool=callgrind --callgrind-out-file=/dev/null build/isoc "$out/planar_$1.scene" -o "$out/counted" \
        --method bdf4 --factors looped 2>&1 | sed -n 's/.*Collected : \([0-9]*\)[0-9][0-9][0-9]$/\1/p'
}

# Twice the length takes between one and a half and four times as long; the third power of it would be eight. Both are
# beyond the size up to which isoc looks for the modes of a plant.
short=$(counted 32)
long=$(counted 64)
[ "${short:-0}" -gt 0 ] && [ "$long" -le $((4 * short)) ] && [ "$long" -gt $((3 * short / 2)) ]
result $? "isoc takes ${short}000 instructions for a chain of 32, ${long}000 for one of 64: at most four times"

# longest PLANT: lines of its longest function.
longest()
{
    awk '/^[A-Z_ ]*static / { n = 0 }
        { n++ }
        /^}$/ && n > most { most = n }
        END { print most }' "$1"
}

for name in spatial_200.rk4 spatial_64.bdf4; do
    lines=$(longest "$out/$name/plant.c") && [ "$lines" -gt 200 ] && [ "$lines" -le 1300 ]
    result $? "$name: no function is longer than 1300 lines: $lines"
done
grep -q 'iso_sparse_factor' "$out/spatial_64.bdf4/plant.c"
result $? "the factors of a chain of 64 in space are looped"

# operations NAME METHOD OPTION...: of its factors.
operations()
{
    name=$1
    method=$2
    shift 2
    build/isoc "$out/$name.scene" -o "$out/counted" --method "$method" "$@" | awk '$1 == "factor" { print $3 + $5 + $7 }'
}

looped=$(operations spatial_50 bdf4 --factors looped)
half=$(operations spatial_25 bdf4 --factors looped)
[ "$looped" -gt "$half" ] && [ $((10 * looped)) -le $((22 * half)) ]
result $? "looped factors of 25 links take $half operations, of 50 $looped: at most 2.2 times"
full=$(operations spatial_25 bdf4 --factors full)
[ "$full" -gt "$half" ]
result $? "control: of a full matrix those of 25 take $full"

! build/isoc "$out/planar_8.scene" -o "$out/none" --method bdf4 --factors half >"$out/summary" 2>&1 &&
    grep -q 'full, sparse or looped, not half' "$out/summary" && [ ! -e "$out/none" ]
result $? "a way that is none is refused"

# evaluation NAME FACTORS PLACE: the plant in the real of now; without optimisation, which changes no bit.
evaluation()
{
    made=$3_$real
    isoc "$out/$made.summary" '' "$out/$1.scene" -o "$out/$made" --real "$real" --method "$method" --factors "$2" &&
        as_evaluation "$made" -O0
}

# same NAME METHOD FACTORS: steps by a full matrix and in this way.
same()
{
    method=$2
    objects=
    for real in float double; do
        real $real
        evaluation "$1" full first && evaluation "$1" "$3" second || return 1
        for place in first second; do
            objects="$objects $out/${place}_$real.o"
        done
    done
    # shellcheck disable=SC2086
    program agree tests/promises/growth/agree.c tests/host/report.c $objects
}

while read -r name method factors; do
    same "$name" "$method" "$factors"
    result $? "$name with $method builds by a full matrix and $factors"
    joined "$name, $method, $factors" "$out/agree"
done <<'END'
spatial_8 bdf4 looped
planar_8 rosenbrock sparse
END

# The same bits, and one count, on the host and on the board.
. tests/host/bits.sh
for place in "host host $CC -O0" "Cortex-M4F mps2 arm-none-eabi-gcc $(of_port mps2 PORT_OPTIMISE)"; do
    # shellcheck disable=SC2086
    variant $place
    isoc "$out/summary" '' "$out/planar_8.scene" -o "$out/looped" --method bdf4 --step 10ms --factors looped &&
        runs "$out/looped/plant.c" 500000000 && value hash >"$out/$port.hash" && cmp -s "$out/$port.hash" "$out/host.hash" &&
        { [ "$port" = host ] || value instructions_per_step | grep -Eqx '[0-9]+'; }
    expect $? "planar_8 with bdf4, looped: $variant, $(value hash), $(value instructions_per_step) instructions"
done
finish
