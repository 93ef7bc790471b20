#!/bin/sh
# Measurement and calibration by a master that is written from the standard, over a socket of the host and over a serial
# line of the board in QEMU; by the addresses of the A2L. With the argument `all` the board is measured for 10 s, else
# for 1 s.
. tests/host/test.sh
. tests/host/project.sh
begin xcp/xcp
seconds=1
[ "${1-}" != all ] && [ -z "${TEST_WHOLE-}" ] || seconds=10
plant=
trap '[ -z "$plant" ] || kill "$plant" 2>/dev/null' EXIT
project
unoptimised clang

# made NAME TARGET LOCK REAL [SCENE]: the plant with its A2L, in $out/NAME.
made()
{
    isochron a2l "${5-tests/core/xcp/masters/cart.scene}" --target "$2" --xcp "$3" --real "$4"
    status=$?
    read_value a2l && a2l=$out/project/$value && read_value program && linked=$out/project/${value%/*} &&
        mkdir -p "$out/$1" && cp "$a2l" "$linked/cart_link.py" "$out/$1" && cp "$out/project/$value" "$out/$1/cart"
    expect $status "$1: the plant with its A2L is built"
}

# session NAME KIND SECONDS CALIBRATION: what the master finds at the plant that was started.
session()
{
    waited "$plant" test -S "$out/$1/controller"
    joined "$1" python3 -B tests/core/xcp/masters/session.py "$out/$1/cart.a2l" "$out/$1" "unix:$out/$1/controller" "$4" "$2" "$3"
    kill "$plant"
    wait "$plant" 2>/dev/null
    plant=
}

# heard KIND: $port is that of this kind which the plant has said that it waits at; fails where it has not.
heard()
{
    while IFS= read -r line; do
        case $line in
        *" waiting at $1:"*) port=${line##* waiting at } && return ;;
        esac
    done <"$out/said"
    return 1
}

# host NAME [KIND]: starts the plant on the host, its calibration at a port that is free: $port.
host()
{
    : >"$out/said"
    rm -f "$out/$1/controller"
    ISOCHRON_CONTROLLER=unix:$out/$1/controller ISOCHRON_CALIBRATION=${2-tcp}:0 "$out/$1/cart" 2>"$out/said" &
    plant=$!
    waited "$plant" heard "${2-tcp}"
}

made host host open float
host host
session host socket 10 "$port"
host host udp
session host datagram 1 "$port"
grep -A1 'begin XCP_ON_UDP_IP' "$out/host/cart.a2l" | grep -q '0x0100 5555 ADDRESS "127.0.0.1"'
result $? "the A2L has it too"
for bad in ISOCHRON_CONTROLLER=udp:0 ISOCHRON_CALIBRATION=udp:x ISOCHRON_CALIBRATION=udp:1.2.3:5; do
    ! env "$bad" timeout 60 "$out/host/cart" 2>"$out/errors" && grep -q "^$bad: \(udp is for ISOCHRON_CALIBRATION\|expected udp:PORT or udp:ADDRESS:PORT\)" "$out/errors"
    result $? "refused: $bad"
done

host host
joined 'idle client' python3 -B tests/core/xcp/masters/idle.py "$port" "$(sed -n 's/.*IDLE_SECONDS = \([0-9]*\).*/\1/p' port/unix/channel.c)"
kill "$plant"
wait "$plant" 2>/dev/null
plant=

host host udp
build/monitor "$out/host/cart.a2l" "$port" --once >"$out/table" && grep -q '^p.rod_mass  *0.2 kg ' "$out/table"
result $? "the monitor connects to ${port%%:*}"
kill "$plant"
wait "$plant" 2>/dev/null
plant=

mkdir -p "$out/project/scenes"
(cat tests/core/xcp/masters/cart.scene && echo 'grace 10 ticks; publish next_tick; histogram') >"$out/project/scenes/cart.scene"
made locked host iso_xcp_example_lock double scenes/cart.scene
host locked
session locked locked 0 "$port"

made board cortex-m4f open float
qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none \
    -serial "unix:$out/board/controller,server=on,wait=off" -serial "unix:$out/board/calibration,server=on,wait=off" \
    -semihosting-config enable=on,target=native,arg=plant -kernel "$out/board/cart" >"$out/said" 2>&1 &
plant=$!
waited "$plant" test -S "$out/board/calibration"
session board serial "$seconds" "unix:$out/board/calibration"

# A slave with three defects: limits are not looked at, a tick has the time stamp of another, and a stimulus is held too
# long.
sed 's/x <= limits->most/x <= x/' core/xcp/access.c >"$out/project/core/xcp/access.c" &&
    sed 's/(uint32_t)loop->tick)/(uint32_t)loop->tick - (loop->tick == 500))/' core/xcp/service.c >"$out/project/core/xcp/service.c" &&
    sed 's/age < s->patience/age <= s->patience/' core/xcp/stimulation.c >"$out/project/core/xcp/stimulation.c" &&
    made defects host open float && host defects
python3 -B tests/core/xcp/masters/session.py "$out/defects/cart.a2l" "$out/defects" "unix:$out/defects/controller" "$port" socket 1 >"$out/tap"
kill "$plant"
for name in 'one number beyond its limits' 'every tick has its own' '360 ticks with a random stimulation'; do
    grep -q "^not ok .*$name" "$out/tap"
    result $? "found by the master: not $name"
done

# bad WHAT SCRIPT: the A2L with this change is none.
bad()
{
    sed "$2" "$out/host/cart.a2l" >"$out/bad.a2l"
    ! python3 -B tests/core/xcp/masters/a2l.py "$out/bad.a2l" >/dev/null 2>&1
    result $? "found: $1"
}

grep -q ' statistics.histogram_31 ' "$out/locked/cart.a2l" && ! grep -qE 'statistics.(latency|histogram)' "$out/host/cart.a2l"
result $? "a scene with policies has their counts in its A2L, another has none of them"
python3 -B tests/core/xcp/masters/a2l.py "$out/host/cart.a2l"
result $? "the A2L keeps to the grammar"
bad "a measurement without an address" '/ECU_ADDRESS/d'
bad "a block without an end" '/end GROUP/d'
bad "a unit that there is not" 's/IEEE unit_1 /IEEE unit_99 /'
bad "two of one name" 's/x\.hinge/x.rail/'
bad "an address that was left open" 's/0x[0-9A-F]*$/@memory+0@/'

# refused OPTION MESSAGE: isoc says so, and writes nothing.
refused()
{
    # shellcheck disable=SC2086
    ! build/isoc tests/core/xcp/masters/cart.scene -o "$out/refused" $1 >/dev/null 2>"$out/errors" && says "$2" &&
        [ ! -e "$out/refused" ]
    result $? "refused: $1"
}
refused "--xcp open" "--xcp is for a plant with a link: add --link to --xcp open"
refused "--link --xcp a-lock" "--xcp is open, or the name of an iso_xcp_lock in C; not a-lock"

finish
