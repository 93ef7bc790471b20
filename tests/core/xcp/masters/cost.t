#!/bin/sh
# What measurement and calibration cost a firmware: bytes, and instructions of a tick, on the Cortex-M4F in float.
. tests/host/test.sh
begin xcp/cost
port=$(of_port mps2 PORT_FLAGS)
link=$(awk '$1 == "PORT_LINK" { sub(/^[^=]*= /, ""); print }' port/mps2/board.mk)

# compiled FILE...: objects for the board in $out.
compiled()
{
    for file in "$@"; do
        # shellcheck disable=SC2086
        arm-none-eabi-gcc $FLAGS $port -c "$file" -o "$out/$(echo "$file" | tr / -).o" || return 1
    done
}

compiled $(ls core/xcp/*.c | grep -v example) &&
    arm-none-eabi-size "$out"/core-xcp-*.o | awk 'NR > 1 { flash += $1 + $2; ram += $2 + $3 } END { print "# flash " flash " bytes\n# ram " ram " bytes" }' >"$out/bytes"
cat "$out/bytes"
[ "$(sed -n 's/^# flash \(.*\) bytes/\1/p' "$out/bytes")" -le 7200 ] && [ "$(sed -n 's/^# ram \(.*\) bytes/\1/p' "$out/bytes")" -le 2000 ]
result $? "not more than 7200 bytes of flash and 2000 of RAM"

# Objects of a program that has it: what they need of outside.
arm-none-eabi-nm -u "$out"/core-xcp-*.o | awk '$1 == "U" { print $2 }' | sort -u |
    grep -vE '^(iso_[a-z0-9_]+|memcpy|memset|__aeabi_mem(cpy|set|clr)[48]?)$' >"$out/outside"
sed 's/^/# /' "$out/outside"
[ ! -s "$out/outside" ]
result $? "the slave calls nothing but Isochron, memcpy and memset"

mkdir -p "$out/plain" && build/isoc tests/core/xcp/masters/cart.scene -o "$out/plain" --link >"$out/summary" && ! grep -qi xcp "$out/plain/interface.c" &&
    build/isoc tests/core/xcp/masters/cart.scene -o "$out/with" --link --xcp open >"$out/summary" && grep -q xcp "$out/with/interface.c"
result $? "a plant with a link that was not asked for it names nothing of it"

compiled tests/core/xcp/masters/cost.c tests/tap.c tests/core/xcp/xcp/service.c port/mps2/port.c port/mps2/console.c port/mps2/semihosting.c port/mps2/start.c &&
    rm "$out/core-xcp-service.c.o" &&
    arm-none-eabi-gcc $port $link "$out"/*.o -o "$out/cost.elf"
result $? "a firmware that counts"
joined tick qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none -serial none \
    -semihosting-config enable=on,target=native -kernel "$out/cost.elf"
[ "$(sed -n 's/^# nothing connected //p' "$out/tap")" -le 140 ] && [ "$(sed -n 's/^# with a list of 8 values //p' "$out/tap")" -le 800 ]
result $? "not more than 140 instructions of a tick when nothing is connected, and 800 with a list of 8 values"
finish
