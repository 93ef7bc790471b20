#!/bin/sh
# Float on the AVR (port/soft/avr_sum.S, avr_product.S and what is compiled for it): over all classes of operands the
# bits of the host's floating-point unit, and one number of cycles for each operation, as simavr counts them.
. tests/host/test.sh
begin soft_avr
real float

# hashes PAIRS [FLAG...]: on the host, into $out/host.
hashes()
{
    pairs=$1
    shift
    # shellcheck disable=SC2086
    "$CC" "$@" $FLAGS tests/port/soft/classes.c tests/port/soft/timer_none.c tests/tap.c port/host/*.c port/unix/console.c -o "$out/host.run" -lm &&
        "$out/host.run" "$pairs" | grep '^# hash' >"$out/host" && [ "$(wc -l <"$out/host")" -eq 6 ]
}

# on_avr PAIRS SOURCE|FLAG...: the same in simavr, with this arithmetic, into $out/avr.
on_avr()
{
    pairs=$1
    shift
    # shellcheck disable=SC2046,SC2086
    avr-gcc "$@" $FLAGS -w $avr_flags tests/port/soft/classes.c tests/port/soft/timer_avr.c tests/tap.c port/atmega1284p/port.c \
        -Wl,--gc-sections -lm -o "$out/avr.elf" && sh port/atmega1284p/run.sh "$out/avr.elf" "$pairs" >"$out/avr"
}

# same_bits: the hashes of both.
same_bits()
{
    grep '^# hash' "$out/avr" | cmp -s - "$out/host"
}

# cycles OPERATION: sets least and most, without the call and two looks at the timer.
cycles()
{
    least=$(($(sed -n "s/^# least $1 //p" "$out/avr") - $(sed -n 's/^# least nothing //p' "$out/avr")))
    most=$(($(sed -n "s/^# most $1 //p" "$out/avr") - $(sed -n 's/^# most nothing //p' "$out/avr")))
}

# constant OPERATION
constant()
{
    cycles "$1" && [ "$least" -gt 0 ] && [ "$least" -eq "$most" ]
}

# planted FILE EDIT: the sources with this edit of one are in $out/planted.
planted()
{
    rm -rf "$out/planted"
    mkdir -p "$out/planted/port"
    cp -r port/soft "$out/planted/port"
    sed "$2" "port/soft/$1" >"$out/planted/port/soft/$1"
    ! cmp -s "port/soft/$1" "$out/planted/port/soft/$1"
}

# of_planted: the arithmetic of $out/planted.
of_planted()
{
    # shellcheck disable=SC2046,SC2059,SC2086
    on_avr 100 -DSTRIDE=5 "-I$out/planted" $(printf "$out/planted/%s\n" $shared)
}

avr_flags=$(sed -n '/^PORT_FLAGS = /,/[^\\]$/p' port/atmega1284p/port.mk | sed 's/^PORT_FLAGS = //; s/\\$//' | tr '\n' ' ')
shared=$(of_port atmega1284p PORT_SHARED)

hashes 20000
result $? "the host computes all classes"
# shellcheck disable=SC2086
on_avr 20000 $shared && same_bits
result $? "the AVR has the same bits"
while read -r operation budget; do
    constant "$operation" && [ "$least" -le "$budget" ]
    result $? "$operation: $least cycles, at most $most, and $budget by its budget"
done <<END
sum 275
difference 276
product 340
quotient 2840
root 2039
END

cycles sum && [ "$(tr '\n' ' ' <port/README.md | grep -c "a sum (\[.avr_sum.S.\](soft/avr_sum.S)) takes $least cycles")" -eq 1 ] && cycles product &&
    grep -q "a product (\[.avr_product.S.\](soft/avr_product.S)) $least\." port/README.md
result $? "port/README.md says so"

# Of the classes a twenty-fifth.
hashes 100 -DSTRIDE=5
planted avr_parts.inc 's/^    neg \\lost$/    clr \\lost/' && of_planted && ! same_bits
result $? "found: sums and products that forget what was shifted out"
planted avr_product.S 's/^    sub r28, r27$/    sub r28, r1/' && of_planted && ! same_bits
result $? "found: products of numbers below the least normal one with a wrong exponent"
planted avr_sum.S 's/^    bst r25, 7$/    sbrc r25, 7\n    nop\n&/' && of_planted && same_bits && constant sum
result $? "a skip over one instruction takes as long as that"
planted avr_sum.S 's/^    bst r25, 7$/    sbrc r25, 7\n    rjmp .\n&/' && of_planted && same_bits && ! constant sum
result $? "found: a sum with a branch, from $least to $most cycles"
planted binary32.h 's/soft_left(significand >> 7, exponent & 1)/(significand >> 7) << (exponent \& 1)/' && of_planted && same_bits && ! constant root
result $? "found: a root with a shift in a loop, from $least to $most cycles"
on_avr 100 -DSTRIDE=5 port/soft/root.c && ! constant sum && ! constant product
result $? "found: sums and products of libgcc, of $least to $most cycles"
finish
