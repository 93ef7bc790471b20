#!/bin/sh
# The top of the project has its rooms alone. Includes go only downward: generated and hand-written plants -> core ->
# port's header; ports know the number type only; the target's code uses no header of a hosted C library; nothing
# includes tools or tests but themselves. The folders of core and of isoc stand in an order of their own: a file
# includes its own folder and those before it, and of isoc it calls no others either.
. tests/host/test.sh
begin check/layers

CORE="numbers methods runtime wire application link snapshots xcp conform"
ISOC="base scene graph method formula mechanism effects tree closure dynamics implicit plant stability emit export linear sweep"
TOP="request products pipeline main"

# violations FOLDER [TREE/...]: prints file:line: include, for each one that its layer forbids, of the project in that
# folder or of these trees there, which are each as the project.
violations()
{
    (
        cd "$1" || exit
        shift
        [ $# -gt 0 ] || set -- ''
        folders=
        for tree; do
            folders="$folders ${tree}core ${tree}port ${tree}models ${tree}tools ${tree}build"
        done
        # shellcheck disable=SC2038,SC2086
        find $folders -regex '\([0-9]+/\)?build/.*' \( \( -path '*build/tests' -o -path '*build/obj' -o -path '*/core' \) -prune \
            -o ! -name 'plant.[ch]' -o -print \) -o -name '*.[ch]' -print 2>/dev/null | xargs awk -v core="$CORE" -v isoc="$ISOC" '
            # The folders of the list up to this one, as alternatives of a pattern; all for a file that stands above
            # them.
            function downto(last, list, i, n, name, text) {
                n = split(list, name, " ")
                for (i = 1; i <= n; i++) {
                    text = text (i > 1 ? "|" : "") name[i]
                    if (name[i] == last) break
                }
                return text
            }
            # A pattern of what a file may include.
            function own(file, folder) {
                folder = file
                sub(/\/[^\/]*$/, "", folder)
                sub(/^(core|tools\/isoc)\//, "", folder)
                if (file ~ /^core\//) return "\"(core/(" downto(folder, core) ")/[a-z0-9_]+\\.h|port/(port|channel)\\.h)\""
                if (file ~ /^port\/(host|posix|unix)\//) return "\"(port/[a-z0-9_/]+\\.h|core/numbers/real\\.h)\"|<[a-z0-9_/]+\\.h>"
                if (file ~ /^port\//) return "\"(port/[a-z0-9_/]+\\.h|core/numbers/real\\.h)\""
                # A controller, with the header that isoc writes for it.
                if (file ~ /^models\/hil\//) return "\"[a-z0-9_]+_link\\.h\"|<[a-z0-9_/]+\\.h>"
                if (file ~ /^models\//) return "\"core/(numbers|methods|runtime)/[a-z0-9_]+\\.h\""
                if (file ~ /^build\//) return "\"(core/(numbers|methods|runtime)/[a-z0-9_]+\\.h|plant\\.h|.*\\.c)\""
                # What the compiler is made of at its top.
                if (file ~ /^tools\/isoc\/[a-z]+\.[ch]$/) return "\"(tools/isoc/([a-z]+/)?|core/(numbers|methods)/)[a-z0-9_]+\\.h\"|<[a-z0-9_/]+\\.h>"
                # What isoc writes for the other end of a wire.
                if (file ~ /^tools\/isoc\/export\//) return "\"(tools/isoc/(" downto(folder, isoc) ")/[a-z0-9_]+|core/(numbers|methods)/[a-z0-9_]+|core/wire/protocol|core/link/frame|port/channel)\\.h\"|<[a-z0-9_/]+\\.h>"
                if (file ~ /^tools\/isoc\//) return "\"(tools/isoc/(" downto(folder, isoc) ")|core/(numbers|methods))/[a-z0-9_]+\\.h\"|<[a-z0-9_/]+\\.h>"
                # A plant in lanes.
                if (file ~ /^tools\/(measure\/batch|python\/lanes|lab\/rig)\.c$/) return "\"((core|tools/python)/[a-z0-9_/]+\\.h|plant\\.c)\"|<[a-z0-9_/]+\\.h>"
                # The library of a plant in Python is a platform too.
                if (file ~ /^tools\/python\//) return "\"(tools/python/[a-z0-9_]+|core/[a-z0-9_/]+|port/port)\\.h\""
                # Generated plants.
                if (file == "tools/measure/order.c") return "\"(tools/[a-z0-9_/]+|core/[a-z0-9_/]+|coarse|middle|fine)\\.h\"|<[a-z0-9_/]+\\.h>"
                return "\"(tools|core)/[a-z0-9_/]+\\.h\"|<[a-z0-9_/]+\\.h>"
            }
            FNR == 1 { file = FILENAME; sub(/^[0-9]+\//, "", file); allowed = "^(" own(file) "|<(stdint|stddef|stdbool|float|limits|string)\\.h>)$" }
            /^[ \t]*#[ \t]*include/ {
                sub(/^[ \t]*#[ \t]*include[ \t]*/, "")
                sub(/[ \t]*(\/\*.*)?$/, "")
                if ($0 !~ allowed) print FILENAME ":" FNR ": " $0
            }'
    )
}

# unlisted: folders, and files at the top of isoc, that the orders above leave out.
unlisted()
{
    (cd "$1" && ls -d core/*/ tools/isoc/*/ tools/isoc/*.c 2>/dev/null) | while read -r path; do
        room=${path%/}
        room=${room##*/}
        case " $CORE $ISOC $TOP " in
        *" ${room%.c} "*) ;;
        *) echo "$path" ;;
        esac
    done
}

# strange FOLDER: what stands at the top of the project and is none of its rooms. Hidden files, and what is built,
# aside.
strange()
{
    (cd "$1" && ls) | grep -vx 'core\|port\|models\|tests\|tools\|build\|Makefile\|README.md'
}
[ -z "$(strange .)" ] || ! strange . | sed 's/^/# /'
result $? "the top of the project has its rooms, the Makefile and README.md alone"
mkdir -p "$out/top/core" && : >"$out/top/step"
[ "$(strange "$out/top")" = step ]
result $? "found: a file at the top"

violations . >"$out/found"
[ ! -s "$out/found" ] || ! sed 's/^/# /' "$out/found"
result $? "every include of core, port, models, tools and generated code goes downward"
[ -z "$(unlisted .)" ]
result $? "every folder of core and of isoc has its place in the order, and every file at the top of isoc"

# Trees with one include in them are found guilty: a file, and what it includes. The last has includes that go downward.
cat >"$out/planted" <<'END'
core/runtime/loop.c "tools/isoc/graph/graph.h"
core/runtime/loop.c "port/host/script.h"
core/runtime/loop.c "models/pendulum.h"
core/runtime/loop.h <stdio.h>
core/runtime/loop.h <math.h>
port/host/sim.c "core/runtime/loop.h"
port/mps2/start.c <stdlib.h>
port/port.h "core/runtime/plant.h"
models/oscillator.c "port/port.h"
models/oscillator.c <math.h>
models/hil/controller.c "core/link/link.h"
build/host/float/tree/plant.c "port/port.h"
tools/isoc/main.c "tests/tap.h"
tools/isoc/main.c "port/port.h"
core/methods/euler.h "core/runtime/plant.h"
core/runtime/loop.c "core/application/stream.h"
tools/isoc/graph/graph.c "tools/isoc/mechanism/mechanism.h"
tools/isoc/implicit/jacobian.c "tools/isoc/emit/code.h"
tools/isoc/plant/plant.c "core/wire/protocol.h"
tools/isoc/export/link.c "core/application/stream.h"
END
set --
while read -r file include; do
    set -- "$@" "$out/trees/$(($# + 1))/${file%/*}"
done <"$out/planted"
mkdir -p "$@" "$out/trees/0/core/runtime" "$out/trees/0/port/host" "$out/trees/0/build/host/float/tree"
set -- 0/
while read -r file include; do
    printf '#include <stdint.h>\n#include %s\n' "$include" >"$out/trees/$#/$file"
    set -- "$@" "$#/"
done <"$out/planted"
echo '#include "port/port.h"' >"$out/trees/0/core/runtime/loop.c"
echo '#include <stdio.h>' >"$out/trees/0/port/host/sim.c"
echo '#  include "plant.h" /* of the same folder */' >"$out/trees/0/build/host/float/tree/plant.c"
echo '#include "port/port.h"' >"$out/trees/0/build/host/float/tree/interface.c"
violations "$out/trees" "$@" >"$out/found"

# of_tree NUMBER: $found is what was found in it.
of_tree()
{
    found=
    while IFS= read -r line; do
        [ "${line%%/*}" != "$1" ] || found="$found${line#*/};"
    done <"$out/found"
}
number=0
while read -r file include; do
    number=$((number + 1))
    of_tree $number
    [ "$found" = "$file:2: $include;" ]
    result $? "found: $file includes $include"
done <"$out/planted"
of_tree 0
[ -z "$found" ]
result $? "includes downward are let through, and so is what is built and is no plant"

# calls FOLDER: "ROOM NAME ROOM" for each name of a room that another one refers to, by the objects there: one for each
# folder of isoc, and for each file at its top.
calls()
{
    # shellcheck disable=SC2046,SC2086
    (cd "$1" && nm -A -P $(ls $(printf '%s.o ' $ISOC $TOP) 2>/dev/null)) | awk '
        { room = $1; sub(/\.o:$/, "", room) }
        $3 == "U" { refers[room, $2] }
        $3 ~ /^[BCDRT]$/ { of[$2] = room }
        END {
            for (pair in refers) {
                split(pair, part, SUBSEP)
                if (part[2] in of) print part[1], part[2], of[part[2]]
            }
        }'
}

# upward CALLS: those of them that a room has of one behind it.
upward()
{
    awk -v order="$ISOC $TOP" '
        BEGIN { n = split(order, room, " "); for (i = 1; i <= n; i++) place[room[i]] = i }
        place[$1] < place[$3]' "$1"
}
calls build/obj/tools/isoc >"$out/calls"
upward "$out/calls" | tee "$out/found" | sed 's/^/# /'
[ ! -s "$out/found" ] && [ "$(wc -l <"$out/calls")" -gt 500 ]
result $? "every call from a room of isoc to another goes downward: $(wc -l <"$out/calls") names"
mkdir -p "$out/objects" && cp build/obj/tools/isoc/plant.o "$out/objects" &&
    echo 'int plant_build(void), planted(void); int planted(void) { return plant_build(); }' >"$out/graph.c" &&
    "$CC" -c "$out/graph.c" -o "$out/objects/graph.o" && calls "$out/objects" >"$out/calls" && [ "$(upward "$out/calls")" = 'graph plant_build plant' ]
result $? "found: a call from a room to one behind it"

# rooms FILE: those of its table, in its order.
rooms()
{
    awk '/^## / { on = $0 == "## The rooms" } on && match($0, /^[|] `[a-z]*`/) { print substr($0, 4, RLENGTH - 4) }' "$1" | paste -sd ' '
}
[ "$(rooms tools/isoc/DESIGN.md)" = "$ISOC" ]
result $? "tools/isoc/DESIGN.md has the rooms of isoc in their order"
grep -v '^| `tree` ' tools/isoc/DESIGN.md >"$out/design.md"
[ "$(rooms "$out/design.md")" != "$ISOC" ]
result $? "found: a room without a line there"
mkdir -p "$out/trees/0/core/extra" "$out/trees/0/tools/isoc/base"
[ "$(unlisted "$out/trees/0")" = core/extra/ ]
result $? "found: a folder that has no place in the order"
finish
