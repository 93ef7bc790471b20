# shellcheck shell=sh
# Programs of other targets that write to the console, without build/trace; read after tests/host/test.sh.

# machine_of TARGET: the board of QEMU that it runs on.
machine_of()
{
    { echo PORT_MACHINE = && cat port/mps2/board.mk "port/$1/port.mk"; } | sed -n 's/^PORT_MACHINE = //p' | tail -n 1
}

# emulated TARGET PROGRAM: runs it; within a minute.
emulated()
{
    case $1 in
    cortex-*)
        timeout 60 qemu-system-arm -M "$(machine_of "$1")" -icount shift=10,align=off,sleep=off -display none -monitor none \
            -serial none -semihosting-config enable=on,target=native -kernel "$2"
        ;;
    rv32*)
        timeout 60 qemu-system-riscv32 -M virt -bios none -icount shift=10,align=off,sleep=off -display none -monitor none \
            -serial none -semihosting-config enable=on,target=native -kernel "$2"
        ;;
    atmega1284p) sh port/atmega1284p/run.sh "$2" 1 ;;
    host | clang) timeout 60 "$2" ;;
    *) timeout 60 "qemu-$1" "$2" ;;
    esac
}
