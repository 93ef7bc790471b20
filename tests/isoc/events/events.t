#!/bin/sh
# A scene of all that events can be: one hash on the host and on the Cortex-M4F, and there one number of instructions
# for every step, with an event and without, by each method that has events, by turns. (Memcheck watches it too:
# promises/poison.t; emit/lanes has it in lanes, core/runtime/snapshots/test_family.py puts it away.)
. tests/host/test.sh
. tests/host/project.sh
begin events
. tests/host/bits.sh

long=2000000000
length()
{
    length=$long
}
turn=$(turn_of 3 "${1-}")
case $turn in
0) methods='rk4 euler' ;;
1) methods='rk4 heun' ;;
2) methods='rk4 semi_implicit' ;;
all) methods='rk4 euler heun semi_implicit' ;;
esac
echo "# turn $turn of 3: $methods"
for place in "host host $CC -O0" "clang host clang -O2" \
    "Cortex-M4F mps2 arm-none-eabi-gcc $(of_port mps2 PORT_OPTIMISE)"; do
    # shellcheck disable=SC2086
    variant $place
    for method in $methods; do
        same tests/isoc/events/events.scene $method
        [ "$(value ticks) $(value late_events)" = '1000 ' ] && [ "$(value events)" -gt 40 ]
        expect $? "$variant, $method: it runs to the end, with $(value events) events"
    done
done

# A scene of all that holds can be, on the same places.
case $turn in
0 | all)
    for place in "host host $CC -O0" "clang host clang -O2" \
        "Cortex-M4F mps2 arm-none-eabi-gcc $(of_port mps2 PORT_OPTIMISE)"; do
        # shellcheck disable=SC2086
        variant $place
        same tests/isoc/events/holds.scene rk4
        [ "$(value ticks) $(value late_events)" = '1000 ' ] && [ "$(value events)" -gt 10 ]
        expect $? "$variant: holds run to the end, with $(value events) events"
    done
    ;;
esac

# Two events in a step of one slot: the second is late, and told.
cat >"$out/two.scene" <<'END'
step 10 ms
method rk4
body load { mass 1 kg }
joint rail prismatic { parent ground; child load; axis x; speed 1 m/s }
mode hits = 0
when position of rail > 22 mm { set hits = hits + 1 }
when position of rail > 27 mm { set hits = hits + 1 }
output hits = hits
END
{ cat "$out/two.scene" && echo 'events 2'; } >"$out/both.scene"
long=50000000
for both in 'two 2 1' 'both 2 '; do
    # shellcheck disable=SC2086
    set -- $both ''
    model "$out/$1.scene" rk4
    [ "$(value events) $(value late_events)" = "$2 $3" ]
    expect $? "$1: $(value events) events, late $(value late_events)"
done
finish
