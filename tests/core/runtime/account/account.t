#!/bin/sh
# The account of the loop against one made by other code, with seeded faults of tick and step, beyond tick 2^32 too.
. tests/host/test.sh
. tests/host/project.sh
begin account
one_isoc
near=4294467296 # 2^32 less 500000

program account tests/core/runtime/account/account.c core/runtime/loop.c
result $? "the loop builds, on a port with faults"
# agrees NAME COMMAND...: the program's account is the model's.
agrees()
{
    agrees_name=$1
    shift
    "$@" >"$out/output" 2>"$out/errors"
    expect $? "$agrees_name: $(tr -d '#\n' <"$out/output")"
}
agrees "a million ticks" "$out/account" 1000000 1 0
agrees "beyond 2^32" "$out/account" 1000000 2 $near
agrees "valgrind" valgrind -q --error-exitcode=9 "$out/account" 20000 3 4294957296

# controlled NAME FROM TO: the loop with that much changed has another account.
controlled()
{
    sed "s/$2/$3/" core/runtime/loop.c >"$out/planted.c"
    ! cmp -s "$out/planted.c" core/runtime/loop.c && program planted tests/core/runtime/account/account.c "$out/planted.c" &&
        ! "$out/planted" 100000 4 0 >"$out/output"
    expect $? "found: $1"
}
optimised -O1
controlled "time in 32 bits" 'return (int64_t)(b - a)' 'return (int32_t)(b - a)'
controlled "a wake-up taken for a tick" 'while (behind(loop) == 0)' 'if (behind(loop) == 0)'
controlled "inputs and tunables that nothing checks" 'iso_plant_admit(plant);' '0;'
controlled "outputs that are not counted" '.*outputs_held++.*' ''
controlled "a margin that is not the least" '(uint32_t)used > loop->used' 'used == 1'
controlled "a stall beyond 2^32 counts" '= t->end - loop->due' '= (uint32_t)(t->end - loop->due)'

# A generated plant with limits: what it computes with numbers within them is what it computes without.
sed 's/ in .*//' tests/core/runtime/account/hostile.scene >"$out/open.scene"
for real in float double; do
    real $real
    rm -rf "$out/two"
    isoc /dev/null '' tests/core/runtime/account/hostile.scene --name limited --real $real -o "$out/two" &&
        isoc /dev/null '' "$out/open.scene" --name open --real $real -o "$out/two" &&
        EXTRA="-I$out/two" program "hostile_$real" tests/core/runtime/account/hostile.c "$out/two/limited.c" "$out/two/open.c" &&
        "$out/hostile_$real" >"$out/output"
    expect $? "$real: what comes into a generated plant is checked: $(tr '\n' ' ' <"$out/output")"
done

# refused SET: isoc says that a value is none, and writes nothing.
refused()
{
    rm -rf "$out/refused"
    ! isoc "$out/output" "$out/errors" tests/core/runtime/account/hostile.scene -o "$out/refused" --set "$1" &&
        grep -q '^--set:1:[0-9]*: error: the default of .* is not within its limits' "$out/errors" && [ ! -e "$out/refused" ]
    expect $? "--set '$1' is refused"
}
refused 'weight = 0 kg'
refused 'drag = 1e30 N*s/m'

# Late: the tick behind the lost one, the late one, and 20 behind the stall, which lasts to the end. Lost: of these all
# but the late one. Overruns: the stall, and the 20 behind it.
cat >"$out/script" <<'S'
lose 4294967297
late 4294967302 100us
slow 4294967306 4295ms
S
for real in float double; do
    real $real
    isoc /dev/null '' tests/core/runtime/account/long.scene --real $real -o "$out/$real" &&
        EXTRA="-I$out/$real" program "long_$real" tests/core/runtime/account/long.c "$out/$real/plant.c" core/runtime/loop.c port/host/script.c port/unix/console.c &&
        "$out/long_$real" "$out/script" >"$out/output" &&
        grep -qx 'late 22 lost 21 overruns 21 margin -4294000000 wave 1 climb 1 grain 1' "$out/output"
    expect $? "$real: the simulated port and functions of time go on beyond tick 2^32"
done
finish
