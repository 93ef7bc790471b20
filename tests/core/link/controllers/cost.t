#!/bin/sh
# What the link takes of a tick beside the loop, on the Cortex-M4F in float: instructions, with one input and six
# outputs.
. tests/host/test.sh
begin link/cost
. tests/host/bits.sh
real float
# shellcheck disable=SC2046
board="$FLAGS $(of_port mps2 PORT_FLAGS)"
for file in tests/core/link/controllers/cost.c tests/tap.c core/link/command.c core/link/frame.c core/runtime/loop.c core/runtime/control.c \
    core/runtime/snapshot.c port/mps2/port.c port/mps2/console.c port/mps2/semihosting.c port/mps2/start.c; do
    # shellcheck disable=SC2086
    arm-none-eabi-gcc $board -c "$file" -o "$out/$(echo "$file" | tr / -).o" || break
done
result $? "what all firmwares share"

# measured NAME OUTPUTS: runs the firmware of a plant with so many outputs, all of the same speed.
measured()
{
    { grep -v ^output tests/promises/ticks/one.scene && for i in $(seq "$2"); do echo "output y_$i = speed of pivot"; done; } >"$out/$1.scene"
    # shellcheck disable=SC2046,SC2086
    build/isoc "$out/$1.scene" -o "$out/$1" --link >"$out/summary" &&
        arm-none-eabi-gcc $board $(of_port mps2 PORT_LINK) "$out/$1"/*.c "$out"/*.o -o "$out/$1.elf"
    result $? "a firmware that counts, with $2 outputs"
    joined "$1" qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none -serial none \
        -semihosting-config enable=on,target=native -kernel "$out/$1.elf"
    beside=$(sed -n 's/^# the link beside it //p' "$out/tap")
}
measured six 6
[ "$beside" -gt 0 ] && [ "$beside" -le 2200 ]
result $? "the link takes at most 2200 instructions of a tick: $beside"
six=$beside
measured fourteen 14
[ "$beside" -gt 2200 ]
result $? "found: eight outputs more: $beside"
byte=$(((beside - six + 16) / 32))
stated core/link/README.md "So a byte of outputs takes $byte. The second plant has eight outputs more."
result $? "a byte of outputs takes $byte, as core/link/README.md says"
finish
