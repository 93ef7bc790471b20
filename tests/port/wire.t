#!/bin/sh
# A controller over the serial line of the boards that same_bits and core/link/controllers/test_isochron_link.py leave
# out: the hash of the host; and what a port without a line says.
. tests/host/test.sh
. tests/host/project.sh
begin port/wire
project
unoptimised clang

isochron hil --target host --seconds 1.2 && read_value hash && hash=$value && [ -n "$hash" ]
expect $? "the host: $hash"
for target in cortex-m33 cortex-m55 rv32imac; do
    isochron hil --target $target --seconds 1.2 && printed hash "$hash" && read_value exchanges &&
        case $value in '1200, '*' missed 0') ;; *) false ;; esac
    expect $? "$target has the same hash: exchanges $value"
done

# A line of which a byte in a hundred is lost: the run takes a frame again, or does not end as it should.
sed -i 's/^        ring_put(in, UART.DATA.);/        static unsigned n;\n        const uint8_t byte = UART[DATA];\n        if (n++ % 100 != 99) {\n            ring_put(in, byte);\n        }/' \
    "$out/project/port/virt/channel.c"
sed -i "/^    ('/d" "$out/project/tools/lab/conform.py"
isochron conform --target rv32imac
read_value channel && case $value in 'FAILED: '*) ;; *) false ;; esac
expect $? "found: channel $value"

! isochron link models/double_pendulum.scene --target atmega1284p && says 'link needs channels *, and --target atmega1284p has none'
result $? "the AVR says that it has none"
for command in 'link --xcp open' a2l; do
    # shellcheck disable=SC2086
    ! isochron $command models/cart_pole.scene --target rv32imac && says 'rv32imac has one channel, * none for measurement and calibration'
    result $? "rv32imac says that it has none for calibration: $command"
done
finish
