#!/bin/sh
# What the port of the board keeps for itself: a clock of 64 bits of a timer of 24, and what interrupts share.
. tests/host/test.sh
begin board
real float
m4f=$(of_port mps2 PORT_FLAGS)

# clock PORT: the program on the board, with this text of the port.
clock()
{
    # shellcheck disable=SC2086
    arm-none-eabi-gcc $FLAGS $m4f "-DCLOCK_OF=\"$1\"" -nostartfiles --specs=nosys.specs -T port/mps2/mps2.ld -Wl,--gc-sections \
        tests/port/board/clock.c tests/tap.c port/mps2/start.c port/mps2/console.c port/mps2/semihosting.c -lm -o "$out/m4f" 2>"$out/errors" &&
        timeout 60 qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none -serial none \
            -semihosting-config enable=on,target=native -kernel "$out/m4f"
}

# lines CHANNEL: whether this text of the channels, with the ring in $out/port if there is one, compiles with what it
# has to be.
lines()
{
    # shellcheck disable=SC2086
    arm-none-eabi-gcc -I"$out" $FLAGS $m4f "-DCHANNEL_OF=\"$1\"" -fsyntax-only tests/port/board/lines.c 2>"$out/errors"
}

joined "the clock" clock port/mps2/port.c
lines port/mps2/channel.c
result $? "what the interrupts of the lines share is volatile"

# planted FILE EDIT: another text of it.
planted()
{
    sed "$2" "$1" >"$out/planted.c"
    ! cmp -s "$1" "$out/planted.c"
}
planted port/mps2/port.c '/end_high += /d' && ! clock "$out/planted.c" >"$out/tap" && grep -q '^not ok 1 - the high word' "$out/tap"
result $? "found: a high word that never counts"
planted port/mps2/port.c 's/volatile uint32_t end, end_high/uint32_t end, end_high/' && ! clock "$out/planted.c" >"$out/tap" &&
    grep -q '^not ok 3' "$out/tap"
result $? "found: a time of the interrupt that is not volatile"
planted port/mps2/channel.c 's/^static volatile uart/static uart/; s/= (volatile uart/= (uart/' && ! lines "$out/planted.c" &&
    grep -q 'are volatile' "$out/errors"
result $? "found: registers of a line that are not volatile"
mkdir -p "$out/port"
for edit in 's/volatile uint32_t first/uint32_t first/' 's/volatile uint8_t bytes/uint8_t bytes/'; do
    planted port/ring.h "$edit" && mv "$out/planted.c" "$out/port/ring.h" && ! lines port/mps2/channel.c &&
        grep -q 'is volatile\|are volatile' "$out/errors"
    result $? "found: $edit"
done
finish
