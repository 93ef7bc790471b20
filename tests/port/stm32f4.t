#!/bin/sh
# The STM32F4: addresses and bits by a second source, the clock tree, tables of pins, and the firmware in QEMU's board
# with that chip, as far as it goes: without its oscillators, converters and cycle counter. The runs of a plant, and the
# duties, are tried on one of two targets each time.
. tests/host/test.sh
. tests/host/project.sh
begin port/stm32f4
project
optimised -O0
turn=$(turn_of 2 "${1-}")
echo "# turn $turn of the targets"
flags="$(sed -n 's/^PORT_FLAGS = //p' port/stm32f4/board.mk | sed 's/$(PORT_BOARD)//')"

# facts OPTION...: whether the registers of the port are where the second source has them. What the compiler says is in
# $said.
facts()
{
    # shellcheck disable=SC2086
    said=$(arm-none-eabi-gcc $FLAGS $flags "$@" -fsyntax-only tests/port/stm32f4_facts.c 2>&1)
}
facts
result $? "addresses and bits are those of the second source"
# A header that is read first is not read again.
while read -r file edit; do
    sed "$edit" "port/stm32f4/$file" >"$out/planted.h"
    ! facts -include "$out/planted.h" && case $said in *'static assertion failed'*) ;; *) false ;; esac
    result $? "found: $file $edit"
done <<'END'
clock.h s/0x40023800/0x40023804/
clock.h s/PLL_P_AT = 16/PLL_P_AT = 17/
gpio.h s/idr, odr/odr/
usart.h s/USART_EMPTY = 1 << 7/USART_EMPTY = 1 << 6/
timer.h s/arr, reserved/arr/
adc.h s/ADC_START = 1 << 30/ADC_START = 1 << 22/
dac.h s/left_12, right_8/left_12/
END

# clock BOARD EDIT: the test of the clock tree for a board, with this edit of the tree.
clock()
{
    sed "$2" port/stm32f4/clock.h >"$out/clock.h"
    sed "$2" port/stm32f4/clock.c >"$out/clock.c"
    # shellcheck disable=SC2086
    "$CC" -I"$out" $FLAGS $1 tests/port/stm32f4_clock.c tests/host/report.c -o "$out/clock" && "$out/clock"
}
joined "F407" clock "" ""
joined "F446" clock -DBOARD_NUCLEO_F446RE ""
for edit in 's/compared = 2000000/compared = 1000000/' 's/hz - 1) \/ 30000000/hz) \/ 30000000/' 's/hz \/ 4/hz \/ 2/' 's/!overdrive()/(overdrive(), false)/' \
    's/from_hse ? HSE_HZ : HSI_HZ/HSE_HZ/' 's/if (is_locked \&\& run_from_pll/if (run_from_pll/'; do
    ! clock -DBOARD_NUCLEO_F446RE "$edit" >"$out/tap" && grep -q '^not ok' "$out/tap"
    result $? "found: $edit"
done

# pins CFLAGS: the test of tables, with the table of these flags, which the two sources see that know of a table.
others=
for source in port/stm32f4/*.c; do
    [ "$source" = port/stm32f4/pins.c ] || others="$others $source"
done
pins()
{
    for source in tests/port/stm32f4_pins.c port/stm32f4/pins.c; do
        # shellcheck disable=SC2086
        arm-none-eabi-gcc $FLAGS $flags $1 -c $source -o "$out/${source##*/}.o" 2>"$out/errors" || return
    done
    # shellcheck disable=SC2086
    arm-none-eabi-gcc $FLAGS $flags -nostartfiles --specs=nano.specs -T port/stm32f4/stm32f4.ld -Wl,--gc-sections \
        -Wl,--defsym=run_ns_high=0,--defsym=run_ns_low=0 "$out/stm32f4_pins.c.o" "$out/pins.c.o" tests/tap.c $others \
        port/mps2/semihosting.c port/mps2/start.c -lm -o "$out/pins.elf" 2>"$out/errors" &&
        timeout 60 qemu-system-arm -M netduinoplus2 -icount shift=10,align=off,sleep=off -display none -monitor none -serial null \
            -chardev stdio,id=console,signal=off -serial chardev:console -semihosting-config enable=on,target=native \
            -kernel "$out/pins.elf" </dev/null
}
joined "no table" pins ""
joined "a table" pins "-include port/stm32f4/pins_example.h"

for target in stm32f407 stm32f446; do
    next_turn 2 || continue
    tried=$target
    for scene in double_pendulum cart_pole_drive; do
        isochron run models/$scene.scene --seconds 1 && read_value hash && hash=$value &&
            isochron run models/$scene.scene --seconds 1 --target $target && printed hash "$hash" && printed overruns 0 &&
            read_value instructions_per_step && [ "$value" -gt 0 ]
        expect $? "$scene on the $target: the bits of the host, $value instructions on every step"
    done
    isochron conform --target $target && jitter=$(awk '
        /FAILED/ { failed = 1 }
        /^(channel|wrap) ok/ { kept++ }
        /^jitter/
        END { exit failed || kept != 2 }' "$out/output")
    expect $? "$target: $jitter"
done

isochron hil --target host --seconds 1.2 && read_value hash && hash=$value && isochron hil --target $tried --seconds 1.2 && printed hash "$hash"
expect $? "a controller on its serial line: the hash of the host"
cp port/stm32f4/pins_example.h "$out/project/pins.h"
CFLAGS='-O0 -include pins.h' isochron run models/double_pendulum.scene --target $tried --seconds 0.1 && printed ticks 100
expect $? "with a table of pins, and no converter that answers, it ends"
# By their dates other objects need not be compiled again, which have no part of the table.
sed -i 's/.pin = 6/.pin = 9/' "$out/project/pins.h"
touch -r port/stm32f4/pins_example.h "$out/project/pins.h"
rm "$out/project/build/obj/$tried/float/port/stm32f4/pins.o"
! CFLAGS='-O0 -include pins.h' isochron run models/double_pendulum.scene --target $tried --seconds 0.1 &&
    grep -q 'the table of pins: an output is on a pin that cannot show it' "$out/output" "$out/errors"
expect $? "a table that is wrong is told, and nothing runs"

# What the README says of the board in QEMU.
printf 'info mtree -f\nquit\n' | qemu-system-arm -M netduinoplus2 -display none -serial none -monitor stdio -S 2>"$out/errors" | sort -u >"$out/devices"
has=$(awk '/stm32f2xx_timer/ { timers++ } /stm32f2xx-adc/ { adcs++ } /stm32f2xx-spi/ { spis++ } /-1000, i\/o\): DAC/ { dac = "no DAC" }
    END { print timers, adcs, spis, dac }' "$out/devices")
[ "$has" = "4 6 6 no DAC" ] && grep -q 'TIM2 to TIM5, six ADCs and six SPIs' port/stm32f4/README.md
result $? "QEMU's board has the timers, converters and SPIs that the README says: $has"

# How long to run, on silicon by two symbols; a real board is not asked where there is none.
mkdir -p "$out/bin" && printf '#!/bin/sh\nprintf "%%s\\n" "$*"\n' >"$out/bin/openocd" && chmod +x "$out/bin/openocd"
program=build/stm32f446/float/double_pendulum/program.elf
PATH=$PWD/$out/bin:$PATH isochron flash models/double_pendulum.scene --target stm32f446 --seconds 10 &&
    arm-none-eabi-nm "$out/project/$program" >"$out/symbols" && grep -q '^00000002 A run_ns_high$' "$out/symbols" &&
    grep -q '^540be400 A run_ns_low$' "$out/symbols" && grep -q "^-f board/st_nucleo_f4.cfg -c program .*/$program verify reset exit" "$out/output"
expect $? "isochron flash: what openocd is told"
! isochron flash models/double_pendulum.scene --target host && grep -q -- '--target host is no real board' "$out/errors"
expect $? "isochron flash without a board is told"
finish
