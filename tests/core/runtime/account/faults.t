#!/bin/sh
# The account of a plant with a link, with some 20 faults in a thousand ticks, of tick, stream, input and snapshot,
# against one made by other code: 10^7 ticks, a fifth of them each time, and 10^5 under valgrind.
. tests/host/test.sh
. tests/host/project.sh
begin account_faults
real float
files="tests/core/runtime/account/faults.c core/link/frame.c core/application/stream.c core/runtime/loop.c core/runtime/snapshot.c
    core/runtime/control.c core/link/link.c core/link/command.c"

# object FILE [SOURCE]: compiled, from another text where there is one.
object()
{
    # shellcheck disable=SC2086
    "$CC" $FLAGS -c "${2:-$1}" -o "$out/$(echo "$1" | tr / -).o"
}

# shellcheck disable=SC2086
for file in $files; do
    object "$file" || break
done && program faults "$out"/*.o
result $? "a plant with a link builds, on a port and a wire with faults"
# agrees NAME COMMAND...: the program's account is the model's.
agrees()
{
    agrees_name=$1
    shift
    "$@" >"$out/output" 2>"$out/errors"
    expect $? "$agrees_name: $(tr -d '#\n' <"$out/output")"
}
turn=$(turn_of 5 "${1-}")
echo "# turn $turn of the ticks"
case $turn in
all) ticks=10000000 seed=1 ;;
*) ticks=2000000 seed=$((turn + 1)) ;;
esac
agrees "$ticks ticks" "$out/faults" $ticks $seed
[ "$(sed -n 's/.* faults \([0-9]*\) .*/\1/p' "$out/output")" -ge $((ticks / 100)) ]
expect $? "with more than one fault in a hundred ticks"
agrees "valgrind, 10^5 ticks" valgrind -q --error-exitcode=9 "$out/faults" 100000 2

# controlled NAME FILE FROM TO: that much changed in a file has another account.
controlled()
{
    sed "s/$3/$4/" "$2" >"$out/planted.c"
    ! cmp -s "$out/planted.c" "$2" && object "$2" "$out/planted.c" && program planted "$out"/*.o &&
        ! "$out/planted" 100000 3 >"$out/output"
    expect $? "found: $1"
    object "$2"
}
optimised -O0
controlled "a jump that forgets the ticks to be caught up" core/runtime/loop.c 'loop->reported += tick - loop->tick;' ''
controlled "ticks at rest that count" core/runtime/loop.c 'loop->rested += ticks;' ''
controlled "a damaged snapshot that is taken" core/runtime/snapshot.c 'return check ==' 'return bytes > 0 || check =='
controlled "a snapshot that is taken in part" core/runtime/snapshot.c \
    'memcpy(plant->memory, snapshot + sizeof head, head.memory_bytes)' 'memcpy(plant->memory, snapshot + sizeof head, 4)'
controlled "a command that is done twice" core/link/command.c 'number == payload\[1\]' 'number == payload[1] + 1'
controlled "inputs that stay fresh after a restore" core/link/link.c 'link->answered = link->loop->tick;' ''
finish
