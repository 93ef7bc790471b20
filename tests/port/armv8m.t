#!/bin/sh
# The Cortex-M33 and the Cortex-M55: faults are told, a stack that is too deep among them, which a limit of the stack
# pointer stops and no MPU; and the end of a loop is none.
. tests/host/test.sh
begin port/armv8m
real float

# share PORT: the objects of all its programs, with its start.
share()
{
    port=$1
    mkdir -p "$out/$port"
    flags="$FLAGS $(of_port cortex-$port PORT_FLAGS)" link=$(of_port cortex-$port PORT_LINK) machine=$(of_port cortex-$port PORT_MACHINE)
    for source in port/mps2/port.c port/mps2/console.c port/mps2/semihosting.c port/mps2/start.c; do
        # shellcheck disable=SC2086
        arm-none-eabi-gcc $flags -c "$source" -o "$out/$port/$(basename "$source" .c).o" || return
    done
}

# board TEXT STATEMENT [EDIT]: a program that executes the statement, with this edit of the start, ends with a message
# and status 1.
board()
{
    printf '#include "port/port.h"\nint main(void)\n{\n%s\nreturn 0;\n}\n' "$2" >"$out/fault.c"
    start=$out/$port/start.o
    [ -z "${3-}" ] || { start=$out/start.c && sed "$3" port/mps2/start.c >"$start"; }
    # shellcheck disable=SC2086
    arm-none-eabi-gcc $flags $link "$out/fault.c" "$start" "$out/$port/port.o" "$out/$port/console.o" "$out/$port/semihosting.o" \
        -o "$out/fault.elf" 2>"$out/errors" &&
        timeout 10 qemu-system-arm -M "$machine" -icount shift=10,align=off,sleep=off -display none -monitor none \
            -serial none -semihosting-config enable=on,target=native,arg=plant -kernel "$out/fault.elf" >"$out/output" 2>"$out/errors" </dev/null
    [ $? -eq 1 ] && grep -Eq "$1" "$out/output"
}

deep='for (;;) __asm__ volatile("push {r0-r7}" ::: "memory");'
for port in m33 m55; do
    share $port
    result $? "$port: what all programs share builds"
    board '^Bail out! fault 0x0000[89][23]00 at 0x' '*(volatile int *)0x0F000000 = 1;'
    result $? "$port: the board tells of an address without memory"
    board '^Bail out! fault 0x00010000 at 0x' '__asm__ volatile("udf #0");'
    result $? "$port: of an undefined instruction"
    board '^Bail out! fault 0x00100000$' "$deep"
    result $? "$port: of a stack that is too deep, by the limit"
    ! board '^Bail out! fault 0x00100000$' "$deep" '/msplim/d'
    result $? "$port: found: a stack without a limit"
done

# gcc ends loops of the Cortex-M55 by an instruction of Armv8.1-M, which refers to LTPSIZE.
loop='__asm__ volatile("dls lr, %0\n0: le lr, 0b" ::"r"(3) : "lr", "memory"); *(volatile int *)0x0F000000 = 1;'
board '^Bail out! fault 0x0000[89][23]00 at 0x' "$loop"
result $? "m55: a loop ends"
board '^Bail out! fault 0x00020000 at 0x' "$loop" 's/FPDSCR & FPDSCR_LTPSIZE/0/'
result $? "m55: found: a start that changes LTPSIZE"
finish
