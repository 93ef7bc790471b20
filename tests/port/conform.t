#!/bin/sh
# isochron conform: the ports keep their duties, also one made from port/template; and one that is broken in a duty is
# found, for each. A sixth of the boards and of the duties has its turn; all of them with the argument `all`.
. tests/host/test.sh
. tests/host/project.sh
begin port/conform
project
turn=$(turn_of 6 "${1-}")
echo "# turn $turn of the boards and of the duties that are broken"

# conforms TARGET: isochron conform says of no duty that it failed, and of all of them something.
duties='arithmetic duration inputs stack start clock wrap tick jitter catching_up console channel exit bits count'
conforms()
{
    isochron conform --target "$1" || return
    kept=' '
    while read -r duty verdict; do
        case $verdict in
        *FAILED*) return 1 ;;
        'ok: '* | 'has none'*) kept="$kept$duty " ;;
        esac
    done <"$out/output"
    for duty in $duties; do
        case $kept in
        *" $duty "*) ;;
        *) return 1 ;;
        esac
    done
}

# shown DUTY...: what the last call said of these.
shown()
{
    between=
    for duty; do
        while read -r of verdict; do
            [ "$of" != "$duty" ] || { printf '%s' "$between$of $verdict" && between='; '; }
        done <"$out/output"
    done
}

while read -r target none; do
    [ "$target" = host ] || next_turn 6 || continue
    conforms "$target"
    expect $? "$target: $(shown jitter stack)"
    without=
    while read -r duty verdict; do
        case $verdict in
        'has none'*) without="$without $duty" ;;
        esac
    done <"$out/output"
    [ "$without" = " $none" ]
    expect $? "$target has no: $none"
done <<END
host inputs catching_up count
cortex-m4f inputs
cortex-m33 inputs
cortex-m55 inputs
cortex-m0 inputs
rv32imafc inputs
END

# A port made from the template, for a board in QEMU.
mine=$out/project/port/mine
mkdir "$mine"
for file in port.c platform.c port.mk; do
    sed 's#port/template#port/mine#g; s#mine/template.ld#mps2/mps2.ld#' "port/template/$file"* >"$mine/$file"
done
cp tests/port/hardware.h port/mps2/channel.c "$mine"
cat >>"$mine/port.mk" <<'END'
PORT_SHARED = port/mps2/start.c port/mps2/semihosting.c
PORT_CHANNEL = port/mine/channel.c
PORT_SERIAL = -serial none
PORT_SERIAL_LINKED = -chardev socket,id=controller,fd=3 -serial chardev:controller
PORT_EXEC = qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none $(PORT_SERIAL) \
    -semihosting-config enable=on,target=native,arg=plant,arg=$(NANOSECONDS) -kernel $(PROGRAM)
END
conforms mine
expect $? "a port made from the template: $(shown jitter stack)"
sed -i "/^    ('/d" "$out/project/tools/lab/conform.py"

# broken DUTY FILE EDIT: with this edit of a file of that port, isochron conform says that the duty failed, and ends
# with a status other than 0.
broken()
{
    next_turn 6 || return 0
    cp "$mine/$2" "$out/whole"
    sed -i "$3" "$mine/$2"
    ! cmp -s "$mine/$2" "$out/whole" && ! isochron conform --target mine && grep -q "^$1 FAILED: " "$out/output"
    expect $? "found: $(shown "$1")"
    cp "$out/whole" "$mine/$2"
}

broken arithmetic platform.c 's/^    (void)max;/&\n    __asm__ volatile("vmsr fpscr, %0" ::"r"(1 << 24));/'
broken duration port.c 's/return hardware_duration()/return (uint32_t)hardware_duration()/'
broken inputs port.c '/^void iso_port_read/,/^}/s/^    (void)inputs;/    u[inputs] = 0;/'
broken stack port.mk 's/^PORT_STACK =/PORT_STACK = -O2/; s/^PORT_OPTIMISE = .*/PORT_OPTIMISE = -O0/'
broken start port.c 's/^    board.clock = 0;/    board.clock = 100000;/'
broken clock port.c '/^uint64_t iso_port_clock/,/^}/s/return clock/return board.reported % 50 == 49 ? clock - 20000 : clock/'
broken wrap port.c '/^uint64_t iso_port_clock/,/^}/s/return clock/return (uint32_t)clock/'
broken tick port.c 's/^    board.ticks++;/    board.ticks += board.ticks % 50 == 49 ? 2 : 1;/'
broken jitter port.c '/^uint64_t iso_port_wait/,/^}/s/^    board.reported += ticks;/&\n    for (volatile int i = 0; board.reported % 50 == 49 \&\& i < 5000; i++) {\n    }/'
broken catching_up port.c 's/^    board.reported += ticks;/    board.reported++;/'
broken interrupts port.c 's/^    board.ticks++;/&\n    __asm__ volatile("vmov.f32 s0, #1.0\\n vmov s1, s0\\n vmov s13, s0\\n vmov s14, s0\\n vmov s15, s0");/
    s/^    board.reported = 0;/&\n    *(volatile uint32_t *)0xE000EF34U = 0;\n    __asm__ volatile("msr control, %0\\n isb" ::"r"(0));/'
broken console port.c '/^void iso_port_write/,/^}/s/^        hardware_put/        if (i % 100 != 99) hardware_put/'
broken channel channel.c 's/^        ring_put(&lines\[channel\].in, .*/        static unsigned n;\n        if (n++ % 1000 != 999) {\n&\n        } else {\n            (void)uarts[channel]->data;\n        }/'
broken exit port.c 's/^    hardware_end(status);/    hardware_end(status + 2);/'

# A root that is rounded wrongly to the bits, and what the compiler's own functions of float do to the count: of two of
# the plants.
sed "/^    ('/{/'double_pendulum'\|'cart_pole_drive'/!d}" tools/lab/conform.py >"$out/project/tools/lab/conform.py"
sed -i 's/soft_root(bits)/soft_root(bits) ^ 1/' "$out/project/port/soft/root.c"
! isochron conform --target cortex-m3 && grep -q '^bits FAILED: .* cart_pole_drive' "$out/output"
expect $? "found: $(shown bits)"
sed -i 's/ port\/soft\/[a-z]*\.c//g' "$out/project/port/cortex-m3/port.mk"
! isochron conform --target cortex-m3 && grep -q '^count FAILED: .*double_pendulum [0-9]* to [0-9]*' "$out/output" && grep -q '^bits ok' "$out/output"
expect $? "found: $(shown count)"
finish
