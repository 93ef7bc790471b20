#!/bin/sh
# The folder of a plant under a stranger's compilers and flags: what core/numbers/README.md says of each row, in float
# and in double. One that moves with other bits than `make run`, and was not refused, is never right.
. tests/host/test.sh
. tests/host/emulators.sh
begin firmware_flags
table=core/numbers/README.md
rv32="-march=rv32imafc -mabi=ilp32f -misa-spec=2.2 -mcmodel=medany -msmall-data-limit=0 --specs=picolibc.specs"

# Of the rows a tenth each time, in either number type by turns; with the argument `all` all.
turn=$(turn_of 10 "${1-}")
echo "# turn $turn of the rows"

# A brake with a root: every row has one.
{
    cat models/double_pendulum.scene
    echo 'effect brake { joint along; let v = speed of along / (1 rad/s); effort on along = -(0.1 N*m) * v * sqrt(1 + v^2) }'
    echo "effect slow brake { along $(sed -n 's/^joint \([a-z_]*\) .*/\1/p' models/double_pendulum.scene | head -n 1) }"
} >"$out/rods.scene"
for real in float double; do
    for plant in heavy=tests/core/methods/order/top.scene "rods=$out/rods.scene"; do
        build/isoc "${plant#*=}" -o "$out/$real" --name "${plant%=*}" --step 5ms --real $real --standalone >"$out/summary" || exit 1
    done
    cp tests/use/firmware/strangers.c core/runtime/hash.h "$out/$real"
done

# port NAME COMPILER...: the objects of a port, by the flags of the project, once. What writes and ends is the same in
# double.
port()
{
    objects=$out/port/$1
    [ -d "$objects" ] && return
    case $1 in
    cortex-*) port_sources="port/mps2/*.c" ;;
    rv32imafc) port_sources="port/virt/*.c port/mps2/semihosting.c port/mps2/console.c" ;;
    atmega1284p) port_sources="port/atmega1284p/*.c" ;;
    *) port_sources="port/host/*.c port/unix/console.c" ;;
    esac
    mkdir -p "$objects"
    shift
    for port_source in $port_sources; do
        # shellcheck disable=SC2086
        "$@" -std=c11 -O2 -fno-math-errno -ffunction-sections -I. -c "$port_source" -o "$objects/${port_source##*/}.o" || exit 1
    done
}

# of_processor NAME: the flags that its port has beside those of all.
of_processor()
{
    grep -l "^PORT_MACHINE = $1\$" port/*/port.mk | xargs sed -n 's/^PORT_FLAGS += //p'
}

# place_of COMPILER FLAG...: where its programs run: $where; what makes the port there: $builder; how a program is
# linked beside the row's own command: $link.
place_of()
{
    link=
    case "$*" in
    arm-none-eabi-gcc*)
        script=port/mps2/mps2.ld
        case "$*" in
        *=soft*)
            where=cortex-m3
            builder="arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb -mfloat-abi=soft"
            ;;
        *=cortex-m55*)
            where=cortex-m55
            builder="arm-none-eabi-gcc $(of_port cortex-m55 PORT_FLAGS)"
            script=port/cortex-m55/an547.ld
            ;;
        *)
            where=cortex-m7
            builder="arm-none-eabi-gcc $(of_port mps2 PORT_FLAGS)"
            ;;
        esac
        link="-nostartfiles --specs=nano.specs -T $script -Wl,--gc-sections -lm"
        ;;
    riscv64-unknown-elf-gcc*)
        where=rv32imafc
        builder="riscv64-unknown-elf-gcc $rv32"
        link="-nostartfiles -T port/virt/virt.ld -Wl,--gc-sections -Wl,--no-warn-rwx-segments -lm"
        ;;
    avr-gcc*)
        where=atmega1284p
        builder="avr-gcc -mmcu=atmega1284p -w"
        link="-Wl,--gc-sections -lm"
        ;;
    *-linux-gnu-gcc*)
        where=${1%-linux-gnu-gcc}
        builder="$1 $(of_processor "$where")"
        [ "$where" != i686 ] || where=i386
        link=-static
        ;;
    *--target=aarch64-linux-gnu*)
        where=aarch64
        builder=aarch64-linux-gnu-gcc
        link=-static
        ;;
    *)
        where=host
        builder=gcc
        ;;
    esac
}

# happens REAL COMPILER FLAG...: what comes of it, in the words of the table: $answer. A row that speaks of a link has
# the flags of the link behind LINK.
happens()
{
    happens_real=$1
    shift
    command=${*%%LINK*}
    linker="${command%% *} ${*#*LINK}"
    [ "$command" != "$*" ] || linker=$command
    # shellcheck disable=SC2086
    place_of $command
    # shellcheck disable=SC2086
    port "$where" $builder
    case $command in
    clang*--target=*) linker=$builder ;;
    esac
    # shellcheck disable=SC2086
    (cd "$out/$happens_real" && exec $command ${IGNORES-} -I. -c heavy.c rods.c strangers.c) 2>"$out/errors" || {
        grep -q 'error.*Isochron: .*; compile with\|error.*Isochron: .*; use -m\|compile_without' "$out/errors" && answer="does not compile" || answer="fails without advice"
        return
    }
    # shellcheck disable=SC2086
    $linker "$out/$happens_real"/heavy.o "$out/$happens_real"/rods.o "$out/$happens_real"/strangers.o "$objects"/*.o $link -o "$out/program" 2>"$out/errors" || {
        answer="does not link"
        return
    }
    emulated "$where" "$out/program" >"$out/output" 2>"$out/errors" </dev/null
    { IFS= read -r happens_said && ! IFS= read -r happens_more; } <"$out/output" || happens_said="no line, or more"
    read -r happens_right <"$out/$happens_real.hash"
    case $happens_said in
    "$happens_right") answer="same bits" ;;
    refused) answer="does not start" ;;
    *) answer="other bits: $(tail -c 100 "$out/output")" ;;
    esac
}

# What is right: the flags of the project.
for real in float double; do
    echo none >"$out/$real.hash"
    happens $real gcc -std=c11 -O2 -ffp-contract=off -fno-math-errno -fno-tree-vectorize -fno-tree-slp-vectorize
    hash=${answer#other bits: }
    case $hash in
    *[!0-9a-f]*) false ;;
    ????????????????) echo "$hash" >"$out/$real.hash" ;;
    *) false ;;
    esac
    result $? "$real, by the flags of the project: $hash"
done

# agrees REAL WORDS COMPILER FLAG...: it happens as the table says, and not in silence.
agrees()
{
    agrees_real=$1
    agrees_words=$2
    shift 2
    happens "$agrees_real" "$@" && [ "$answer" = "$agrees_words" ]
    agrees_status=$?
    [ $agrees_status -eq 0 ] || { echo "# $answer" && sed 's/^/# /' "$out/errors" | head -n 5; }
    return $agrees_status
}

# can COMPILER FLAG...: whether this machine can run what it makes.
machine=$(uname -m)
grep -qw fma /proc/cpuinfo
has_fma=$?
can()
{
    case "$machine $*" in
    *-linux-gnu* | *-elf-gcc* | *-eabi-gcc* | *avr-gcc*) return 0 ;;
    x86_64*-m*) return $has_fma ;;
    x86_64*) return 0 ;;
    *) return 1 ;;
    esac
}

sed -n 's/^| `\([^`]*\)` | \([a-z -]*\) | \([a-z -]*\) |$/\1|\2|\3/p' $table >"$out/rows"
[ "$(wc -l <"$out/rows")" -ge 20 ]
result $? "the table has $(wc -l <"$out/rows") rows"
number=0
while IFS='|' read -r row in_float in_double; do
    for real in float double; do
        number=$((number + 1))
        [ "$turn" = all ] || [ $((number % 10)) -eq "$turn" ] || continue
        # shellcheck disable=SC2086
        can $row || continue
        expected=$in_float
        [ $real = float ] || expected=$in_double
        # shellcheck disable=SC2086
        [ "$expected" = '-' ] || agrees $real "$expected" $row
        result $? "$real: $row: $expected"
    done
done <"$out/rows"

m7="arm-none-eabi-gcc -O2 -mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16"
# shellcheck disable=SC2086
agrees float "does not start" $m7 -DFLUSHES
result $? "a Cortex-M7 that sets denormals to zero: does not start"

# gcc up to version 11 undefines the macros for its flags at the pragma: nevertheless a root compiles, and fast math
# does not.
mkdir -p "$out/undefining/core/numbers"
awk '{ print }
    /^#pragma GCC optimize/ {
        print "#undef __NO_MATH_ERRNO__\n#undef __FAST_MATH__\n#undef __ASSOCIATIVE_MATH__\n#undef __RECIPROCAL_MATH__"
        print "#undef __NO_SIGNED_ZEROS__\n#undef __FINITE_MATH_ONLY__"
    }' core/numbers/real.h >"$out/undefining/core/numbers/real.h"
echo '#include "core/numbers/sqrt.h"' >"$out/root.c"
compiles_root()
{
    "$@" -I. -c "$out/root.c" -o "$out/root.o" 2>"$out/errors"
}
grep -q '^#undef' "$out/undefining/core/numbers/real.h" && compiles_root gcc -O2 -fno-math-errno -I"$out/undefining"
result $? "a root, by a gcc that undefines the macros for its flags at the pragma"
! compiles_root gcc -O2 -ffast-math -I"$out/undefining" && grep -q 'Isochron: -ffast-math' "$out/errors"
result $? "fast math, by a gcc that undefines the macros for its flags at the pragma: does not compile"

# The advice for a root is enough.
compiles_root gcc -O2 && ! compiles_root gcc -O2 -ffreestanding && grep -q 'compile with -fno-math-errno"' "$out/errors" &&
    compiles_root gcc -O2 -ffreestanding -fno-math-errno
result $? "a root by gcc: with -ffreestanding by -fno-math-errno"
! compiles_root tcc && grep -q 'compile with -fno-math-errno -D__NO_MATH_ERRNO__"' "$out/errors" &&
    compiles_root tcc -fno-math-errno -D__NO_MATH_ERRNO__
result $? "a root by a compiler that does not say whether it sets errno: with the macro too"

# A row that says another thing is found, and so is a plant that changes its bits in silence, even where nobody looks at
# the answer of its start.
! agrees float "does not start" gcc -O0 >"$out/said" && grep -q '# same bits' "$out/said"
result $? "found: a row that is not what happens"
if can -mfma; then
    agrees float "does not start" clang -O2 -mfma -ffp-contract=fast
    result $? "a plant that fuses does not start"
    IGNORES=-DIGNORES agrees float "does not start" clang -O2 -mfma -ffp-contract=fast
    result $? "nor does it move where nobody looks at that"
    sed -i '/iso_if_bits_are_kept/d' "$out/float/heavy.c" "$out/float/rods.c"
    ! agrees float "does not start" clang -O2 -mfma -ffp-contract=fast >"$out/said" && grep -q '# other bits' "$out/said"
    result $? "found: a plant without the check, which changes its bits"
    sed -i '/^#pragma GCC optimize/d' "$out/float/core/numbers/real.h"
    ! agrees float "same bits" gcc -O2 -mfma >"$out/said" && grep -q '# other bits' "$out/said"
    result $? "found: gcc's defaults without the pragma"
fi
finish
