#!/bin/sh
# Installs what the tests need and this machine lacks. Without the right to install, names the command and fails.

PATH=$PATH:/usr/sbin

have()
{
    command -v "$1" >/dev/null 2>&1
}

# A file of the C library for the Cortex-M4F: the compiler alone does not bring it.
have_newlib()
{
    have arm-none-eabi-gcc && [ -f "$(arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -print-file-name=libc.a)" ]
}

# The C library for RISC-V.
have_picolibc()
{
    echo '#include <string.h>' | riscv64-unknown-elf-gcc --specs=picolibc.specs -fsyntax-only -x c - 2>/dev/null
}

# The C library for AVR.
have_avr_libc()
{
    echo '#include <string.h>' | avr-gcc -fsyntax-only -x c - 2>/dev/null
}

# Of the Python that Debian's pytest runs in.
have_numpy()
{
    /usr/bin/python3 -c 'import numpy' 2>/dev/null
}

have_sanitizers()
{
    echo 'int main(void) { return 0; }' | ${CC:-cc} -fsanitize=address,undefined -x c - -o /dev/null 2>/dev/null
}

have_fuzzer()
{
    echo 'int LLVMFuzzerTestOneInput(void); int LLVMFuzzerTestOneInput(void) { return 0; }' |
        clang -fsanitize=fuzzer,address,undefined -x c - -o /dev/null 2>/dev/null
}

missing()
{
    have ${CC:-cc} || echo gcc libc6-dev
    have arm-none-eabi-gcc || echo gcc-arm-none-eabi
    have_newlib || echo libnewlib-arm-none-eabi
    have qemu-system-arm || echo qemu-system-arm
    have riscv64-unknown-elf-gcc || echo gcc-riscv64-unknown-elf
    have_picolibc || echo picolibc-riscv64-unknown-elf
    have qemu-system-riscv32 || echo qemu-system-misc
    have avr-gcc || echo gcc-avr
    have_avr_libc || echo avr-libc
    have aarch64-linux-gnu-gcc || echo gcc-aarch64-linux-gnu libc6-dev-arm64-cross
    have s390x-linux-gnu-gcc || echo gcc-s390x-linux-gnu libc6-dev-s390x-cross
    have mips-linux-gnu-gcc || echo gcc-mips-linux-gnu libc6-dev-mips-cross
    have i686-linux-gnu-gcc || echo gcc-i686-linux-gnu libc6-dev-i386-cross
    have qemu-aarch64 || echo qemu-user
    have cmake || echo cmake
    [ -d /usr/share/arduino/hardware/arduino/avr ] || echo arduino-core-avr
    have simavr || echo simavr
    [ -f /usr/include/simavr/sim_avr.h ] || echo libsimavr-dev
    have valgrind || echo valgrind
    have pytest-3 || echo python3-pytest
    /usr/bin/python3 -c "import xdist" 2>/dev/null || echo python3-pytest-xdist
    have ccache || echo ccache
    have_numpy || echo python3-numpy
    have clang || echo clang
    have tcc || echo tcc
    have_fuzzer || echo libclang-rt-dev
    have clang-format || echo clang-format
    have cppcheck || echo cppcheck
    have gnuplot || echo gnuplot-nox
    have dot || echo graphviz
    have g++ || echo g++
    have patch || echo patch
    have parallel || echo parallel
    have rsync || echo rsync
    have sshd || echo openssh-server
    have slurmctld || echo slurmctld
    have slurmd || echo slurmd
    have sbatch || echo slurm-client
    have munged || echo munge
    have python3 || echo python3
    have node || echo nodejs
    have npm || echo npm
    ! apt-cache show libmujoco-dev 2>/dev/null | grep -q . || [ -f /usr/include/mujoco/mujoco.h ] || echo libmujoco-dev
    have chromium-headless-shell || have chromium || have google-chrome || echo chromium-headless-shell
    if have ${CC:-cc} && ! have_sanitizers; then
        case $(${CC:-cc} --version) in
        *clang*) echo "libclang-rt-$(${CC:-cc} -dumpversion | cut -d. -f1)-dev" ;;
        *) echo libgcc-$(${CC:-cc} -dumpversion | cut -d. -f1)-dev ;;
        esac
    fi
}

packages=$(missing | tr '\n' ' ')
[ -n "$packages" ] || exit 0
install="apt-get install -y --no-install-recommends $packages"

if ! have apt-get; then
    echo "tests: these Debian packages, or what they hold, are missing: $packages" >&2
    exit 1
fi
if [ "$(id -u)" -eq 0 ]; then
    root=
elif have sudo && sudo -n true 2>/dev/null; then
    root=sudo
else
    echo "tests: something is missing; install it with: sudo $install" >&2
    exit 1
fi
echo "tests: installs what is missing, which takes some minutes; all of it would be 900 MB to download and 4.7 GB on the disk:"
echo "tests: ${root:+$root }$install"
log=build/tests/install.log
mkdir -p build/tests
if ! { $root apt-get update && $root env DEBIAN_FRONTEND=noninteractive $install; } >$log 2>&1; then
    tail -n 20 $log >&2
    echo "tests: the installation failed: ${root:+$root }$install" >&2
    exit 1
fi
left=$(missing | tr '\n' ' ')
if [ -n "$left" ]; then
    echo "tests: still missing after the installation: $left" >&2
    exit 1
fi
