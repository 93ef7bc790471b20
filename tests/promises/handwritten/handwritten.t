#!/bin/sh
# The cost of a generated plant: instructions of an rk4 step beside those of a plant written by hand with the same
# kernel, on the host in double (callgrind); operations of a derivative beside a published count; instructions of a step
# on the Cortex-M4F.
. tests/host/test.sh
. tests/host/project.sh
begin handwritten
one_isoc
. tests/host/callgrind.sh

for name in pendulum double_pendulum cart_pole; do
    scene "$name" &&
        program "$name.generated" tests/promises/handwritten/count.c "$out/$name/plant.c" &&
        program "$name.hand" tests/promises/handwritten/count.c "tests/promises/handwritten/$name.c"
    result $? "$name builds"
    generated=$(per_step "$out/$name.generated")
    result $? "$name, generated: $generated instructions on every step"
    hand=$(per_step "$out/$name.hand")
    result $? "$name, by hand: $hand instructions on every step"
    at_most_tenth_over "${generated:-0}" "${hand:-0}"
    result $? "$name: generated at most 1.1 x by hand"
    [ "$name" = double_pendulum ] && hand_double_pendulum=$hand
done

# Positive controls: a plant that does more than it must, and one whose steps differ.
EXTRA=-O0 program unoptimised tests/promises/handwritten/count.c "$out/double_pendulum/plant.c" &&
    slow=$(per_step "$out/unoptimised") && ! at_most_tenth_over "$slow" "$hand_double_pendulum"
result $? "control: $slow instructions are more than 1.1 x by hand"
program libm tests/promises/handwritten/count.c tests/promises/handwritten/pendulum_libm.c && ! per_step "$out/libm" >/dev/null
result $? "control: a sine that branches on its argument is seen"

# at_most_two STEP DERIVATIVE EVALUATIONS: of the sums and products that the method itself makes, $made, each costs at
# most two instructions of a step beyond its evaluations: one computes, one loads or stores. Sets overhead.
at_most_two()
{
    overhead=$(($1 - $3 * $2))
    [ "$1" -gt 0 ] && [ "$made" -gt 0 ] && [ $overhead -le $((2 * made)) ]
}

# by_method METHOD FILE: a plant by hand with a method.
by_method()
{
    EXTRA="-DISO_METHOD=ISO_$(echo "$1" | tr a-z A-Z) -DISO_METHOD_NAME=$1" program "$1.run" tests/promises/handwritten/count.c "$2"
}

# beyond METHOD EVALUATIONS: steps of the double pendulum by hand: what isoc saves in an evaluation is no cost of a
# method.
beyond()
{
    by_method "$1" tests/promises/handwritten/double_pendulum.c
    result $? "double_pendulum by hand with $1 builds"
    derivative=$(per_step "$out/$1.run" derivative derivative)
    step=$(per_step "$out/$1.run" step)
    made=$(build/isoc models/double_pendulum.scene -o "$out/counted" --method "$1" --real double |
        awk -v evaluations="$2" '$1 == "derivative" || $1 == "step" && $2 == "add" { n[$1] = $3 + $5 }
            END { print n["step"] - evaluations * n["derivative"] }')
    at_most_two "${step:-0}" "${derivative:-0}" "$2"
    result $? "$1: of $step instructions $overhead are beyond $2 evaluations of $derivative, for $made sums and products"
}

beyond rk4 4
beyond abm4 2
beyond ab4 1
# Positive control: a step that calls its derivative, and does not have it in itself.
sed 's/^static inline void derivative/static __attribute__((noinline)) void derivative/' tests/promises/handwritten/double_pendulum.c >"$out/called.c" &&
    by_method ab4 "$out/called.c" && step=$(per_step "$out/ab4.run" step) && ! at_most_two "$step" "$derivative" 1
result $? "control: with a call, of $step instructions $overhead are beyond one evaluation of $derivative"

# The operations of arm6's derivative, which isoc counts, beside those of the articulated-body algorithm for n joints in
# general position: 224 n - 259 multiplications and 205 n - 248 additions (McMillan and Orin 1995, as
# tabulated by Featherstone 2008, Rigid Body Dynamics Algorithms, table 10.1). isoc knows the geometry: 60 %.
n=6
scene arm6
result $? "arm6 builds"
# operations KIND: how many of a kind a derivative takes.
operations()
{
    awk -v kind="$1" '$1 == "derivative" { for (i = 2; i < NF; i += 2) if ($i == kind) print $(i + 1) }' "$out/arm6.summary"
}
mul=$(operations mul)
div=$(operations div)
add=$(operations add)
[ "${mul:-0}" -gt 0 ] && [ $((100 * (mul + div))) -le $((60 * (224 * n - 259))) ]
result $? "arm6: ${mul:-?} multiplications and ${div:-?} divisions at most 60 % of $((224 * n - 259))"
[ "${add:-0}" -gt 0 ] && [ $((100 * add)) -le $((60 * (205 * n - 248))) ]
result $? "arm6: ${add:-?} additions at most 60 % of $((205 * n - 248))"
# What isoc says must be there in the code: a multiplication is one sign, an addition or a subtraction one of two.
# What a step prepares for the next one stands in a function of its own.
derivative=$(sed -n '/^static void \(prepare\|complete\|derivative\)(/,/^}/p' "$out/arm6/plant.c" | sed 's|/\*.*\*/||')
[ "$(printf '%s\n' "$derivative" | grep -o ' \* ' | grep -c .)" -eq "${mul:-0}" ]
result $? "arm6: the multiplications are those in the code"
[ "$(printf '%s\n' "$derivative" | grep -o ' [+-] ' | grep -c .)" -eq "${add:-0}" ]
result $? "arm6: the additions are those in the code"

# On the Cortex-M4F, in float: a budget of 750.
limit=750
project
isochron run models/double_pendulum.scene --target cortex-m4f --seconds 1
expect $? "double_pendulum runs on the Cortex-M4F"
count=$(value instructions_per_step)
[ "${count:-0}" -gt 0 ] && [ "$count" -le $limit ]
expect $? "double_pendulum, Cortex-M4F: ${count:-?} instructions in a step, at most $limit"
# shellcheck disable=SC2046
set -- $(value execution)
[ "${1:-0}" -gt 0 ] && [ "$1" = "$3" ]
expect $? "double_pendulum, Cortex-M4F: the least and the most are the same, ${1:-?}"
# work_of METHOD: the work space of this method compiles in a file whose list is rk4 alone.
work_of()
{
    cat >"$out/only.c" <<EOF
#include "core/methods/rk4.h"
#define ISO_METHOD_LIST(X, r) X(r, ISO_RK4, rk4)
#include "core/methods/primed.h"
extern const size_t size;
const size_t size = sizeof(real[ISO_METHOD_WORK($1, 4)]) + sizeof(real[ISO_METHOD_PRIME_WORK($1, 4)]);
EOF
    program only.o -c "$out/only.c" 2>"$out/errors"
}
work_of ISO_RK4 && work_of 'ISO_RK4 | ISO_CHECKED' && ! work_of ISO_BDF4 && grep -q 'ISO_BDF4.* undeclared' "$out/errors"
result $? "found: a method that a file has no row of"
finish
