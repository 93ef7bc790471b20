#!/bin/sh
# A hash of all that the tests of the folder follow from: its files but for what is built, the tools, and the variables
# that the tests know. What passed with this hash is not run again (tests/exec.sh).
{
    find . \( -path ./build -o -path ./.git -o -path ./tests/times \) -prune -o \( -type f -o -type l \) -print | LC_ALL=C sort |
        tar -cf - --mtime=@0 --owner=0 --group=0 --numeric-owner --no-recursion -T -
    # shellcheck disable=SC2046
    stat -L -c '%n %s %Y' $(for tool in "${CC:-cc}" gcc g++ clang arm-none-eabi-gcc riscv64-unknown-elf-gcc avr-gcc ld as arm-none-eabi-ld qemu-system-arm qemu-system-riscv32 simavr valgrind clang-format cppcheck \
        gnuplot dot make sh awk sed perl patch; do
        command -v "$tool" || echo "$tool"
    done) 2>&1
    uname -srm
    echo "CC=${CC-} CFLAGS=${CFLAGS-} TEST_STRIDE=${TEST_STRIDE-} TEST_WHOLE=${TEST_WHOLE-}"
} | sha256sum | cut -d ' ' -f 1
