#!/bin/sh
# The tables of core/link/README.md name the fields of core/wire/protocol.h: the types of each payload, in their
# order.
. tests/host/test.sh
begin link_frames

# agrees README: whether its tables, of frames and of commands, are those of the header; $told is the first that
# differs.
agrees()
{
    awk -f tests/core/link/controllers/tables.awk core/wire/protocol.h "$1" >"$out/told"
    agrees_status=$?
    read -r told <"$out/told"
    return $agrees_status
}

agrees core/link/README.md
agreed=$?
[ "$told" = '10 11 u64 u8 u64' ]
result $? "the header has nine frames, one of them for both, and eleven commands"
result $agreed "the tables in core/link/README.md have their fields, what commands take, and how a plant is"

# found NAME WHAT EDIT: a table of which a line is changed so.
found()
{
    sed "$3" core/link/README.md >"$out/changed.md"
    ! cmp -s "$out/changed.md" core/link/README.md && ! agrees "$out/changed.md"
    found_status=$?
    case $told in
    "# $1: "*) ;;
    *) found_status=1 ;;
    esac
    result $found_status "found: $2"
}
found START 'another type' '/^| `s` start/s/u8 mode/u16 mode/'
found REFUSAL 'a field that is missing' '/^| `n` refusal/s/u8 reason, //'
found 'command WRITE' 'another type in a command' 's/u32 offset, 1 to/u16 offset, 1 to/'
found state 'a field that is missing of the state' 's/any other one with u8 state/any other one with state/'
finish
