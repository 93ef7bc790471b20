#!/bin/sh
# The tables of core/link/README.md name the fields of core/application/protocol.h: the types of each payload, in their order.
. tests/host/test.sh
begin link_frames
protocol=core/application/protocol.h

# fields NAME: the types of a list of the header, in words of the README.
fields()
{
    awk -v name="#define $1(X)" 'index($0, name) == 1 { on = 1 } on { print } on && !/\\$/ { exit }' $protocol |
        grep -o 'X([a-z_]*, [A-Z0-9]*, [A-Z0-9]*)' |
        sed 's/.*, \([A-Z0-9]*\), \([A-Z0-9]*\))/\1 \2/; s/REAL MANY/reals/; s/U64 MANY/64 bits/; s/U8 MANY/bytes/; s/ 1$//' | tr 'A-Z\n' 'a-z ' | sed 's/ $//'
}

# said README LETTER SENDER: the types in the row of a frame.
said()
{
    awk -F ' *[|] *' -v letter="\`$2\`" -v sender="$3" 'index($2, letter) == 1 && $3 == sender { print $4 }' "$1" |
        grep -o 'u[0-9][0-9]* \|reals\|64 bits' | sed 's/ $//; s/^64$/64 bits/' | tr '\n' ' ' | sed 's/ $//'
}

# agrees README: whether each row is that of the header.
agrees()
{
    while read -r name letter sender; do
        [ "$(said "$1" "$letter" "$sender")" = "$([ "$name $sender" = "END controller" ] || fields "ISO_LINK_${name}_FIELDS")" ] || {
            echo "# $name: '$(said "$1" "$letter" "$sender")', in the header '$(fields "ISO_LINK_${name}_FIELDS")'"
            return 1
        }
    done <"$out/frames"
}
sed -n "s/^    X(\([A-Z]*\), '\([a-zA-Z]\)').*/\1 \2/p" $protocol | awk '{ print $0, $2 ~ /[hsuec]/ ? "controller" : "plant" } $1 == "END" { print $0, "plant" }' >"$out/frames"
[ "$(grep -c . "$out/frames")" -eq 10 ] && [ "$(fields ISO_LINK_START_FIELDS)" = "u64 u8 u64" ]
result $? "the header has nine frames, one of them for both"
agrees core/link/README.md
result $? "the table of frames in core/link/README.md has their fields"
sed '/^| `s` start/s/u8 mode/u16 mode/' core/link/README.md >"$out/changed.md"
! cmp -s "$out/changed.md" core/link/README.md && ! agrees "$out/changed.md" >"$out/told"
result $? "found: another type"
sed '/^| `n` refusal/s/u8 reason, //' core/link/README.md >"$out/changed.md"
! cmp -s "$out/changed.md" core/link/README.md && ! agrees "$out/changed.md" >"$out/told"
result $? "found: a field that is missing"

# taken README: the types that the commands take, by number, and of the state in an answer.
taken()
{
    awk -F ' *[|] *' '$3 ~ /^[0-9]+$/ { print $3, $4 }' "$1" | sed 's/, 0 without an end//; s/\(u[0-9]*\) [^,]*/\1/g; s/, [0-9]* to [0-9]* bytes/ bytes/; s/, real/ reals/'
    tr '\n' ' ' <"$1" | grep -o 'any other one with [^.]*' | grep -o 'u[0-9][0-9]* ' | tr -d '\n'
    echo
}
{
    sed -n 's/^    X(\([A-Z]*\), \([0-9]*\)) .*/\1 \2/p' $protocol | while read -r name number; do
        case $name in
        WRITE) list=ISO_COMMAND_PIECE_FIELDS ;;
        SET) list=ISO_COMMAND_VALUE_FIELDS ;;
        *) list=ISO_COMMAND_${name}_TAKES ;;
        esac
        echo "$number $(fields $list)"
    done
    echo "$(fields ISO_COMMAND_STATE_FIELDS) "
} >"$out/commands"
[ "$(grep -c . "$out/commands")" -eq 12 ] && taken core/link/README.md | diff - "$out/commands" >"$out/told"
result $? "the table of commands has what they take, and the text how a plant is"
sed 's/u32 offset, 1 to/u16 offset, 1 to/' core/link/README.md >"$out/changed.md"
! taken "$out/changed.md" | cmp -s - "$out/commands"
result $? "found: another type"
finish
