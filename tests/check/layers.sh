#!/bin/sh
# The top of the project has its rooms alone. Includes go only downward: generated and hand-written plants -> core -> port's
# header; ports know the number type only; the target's code uses no header of a hosted C library; nothing includes tools or
# tests but themselves. The folders of core and of isoc stand in an order of their own: a file includes its own folder and
# those before it.
. tests/host/test.sh
begin check/layers

CORE="numbers methods runtime application link record xcp conform"
ISOC="base scene graph method formula mechanism effects tree closure dynamics implicit plant stability emit linear sweep"

# violations ROOT: prints file:line: include, for each one that its layer forbids.
violations()
{
    (
        cd "$1" && {
            find core port models tools -name '*.[ch]'
            find build -name 'plant.[ch]' ! -path 'build/tests/*' ! -path 'build/obj/*' ! -path '*/core/*'
        } 2>/dev/null | sort | xargs awk -v core="$CORE" -v isoc="$ISOC" '
            # The folders of the list up to this one, as alternatives of a pattern; all for a file that stands above them.
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
                if (file ~ /^port\/(sim|posix|host)\//) return "\"(port/[a-z0-9_/]+\\.h|core/numbers/real\\.h)\"|<[a-z0-9_/]+\\.h>"
                if (file ~ /^port\//) return "\"(port/[a-z0-9_/]+\\.h|core/numbers/real\\.h)\""
                # A controller, with the header that isoc writes for it.
                if (file ~ /^models\/hil\//) return "\"[a-z0-9_]+_link\\.h\"|<[a-z0-9_/]+\\.h>"
                if (file ~ /^models\//) return "\"core/(numbers|methods|runtime)/[a-z0-9_]+\\.h\""
                if (file ~ /^build\//) return "\"(core/(numbers|methods|runtime)/[a-z0-9_]+\\.h|plant\\.h)\""
                # What the compiler is made of at its top.
                if (file ~ /^tools\/isoc\/[a-z]+\.[ch]$/) return "\"(tools/isoc/([a-z]+/)?|core/(numbers|methods)/)[a-z0-9_]+\\.h\"|<[a-z0-9_/]+\\.h>"
                # What isoc writes for the other end of a wire.
                if (file ~ /^tools\/isoc\/emit\//) return "\"(tools/isoc/(" downto(folder, isoc) ")/[a-z0-9_]+|core/(numbers|methods)/[a-z0-9_]+|core/application/protocol|core/link/frame|port/channel)\\.h\"|<[a-z0-9_/]+\\.h>"
                if (file ~ /^tools\/isoc\//) return "\"(tools/isoc/(" downto(folder, isoc) ")|core/(numbers|methods))/[a-z0-9_]+\\.h\"|<[a-z0-9_/]+\\.h>"
                # A plant in lanes.
                if (file ~ /^tools\/(measure\/batch|python\/lanes)\.c$/) return "\"((core|tools/python)/[a-z0-9_/]+\\.h|plant\\.c)\"|<[a-z0-9_/]+\\.h>"
                # The library of a plant in Python is a platform too.
                if (file ~ /^tools\/python\//) return "\"(tools/python/[a-z0-9_]+|core/[a-z0-9_/]+|port/port)\\.h\""
                # Generated plants.
                if (file == "tools/measure/order.c") return "\"(tools/[a-z0-9_/]+|core/[a-z0-9_/]+|coarse|middle|fine)\\.h\"|<[a-z0-9_/]+\\.h>"
                return "\"(tools|core)/[a-z0-9_/]+\\.h\"|<[a-z0-9_/]+\\.h>"
            }
            FNR == 1 { allowed = "^(" own(FILENAME) "|<(stdint|stddef|stdbool|float|limits|string)\\.h>)$" }
            /^[ \t]*#[ \t]*include/ {
                sub(/^[ \t]*#[ \t]*include[ \t]*/, "")
                sub(/[ \t]*(\/\*.*)?$/, "")
                if ($0 !~ allowed) print FILENAME ":" FNR ": " $0
            }'
    )
}

# unlisted: folders that the orders above leave out.
unlisted()
{
    (cd "$1" && ls -d core/*/ tools/isoc/*/) | while read -r folder; do
        folder=${folder%/}
        case " $CORE $ISOC " in
        *" ${folder##*/} "*) ;;
        *) echo "$folder/" ;;
        esac
    done
}

# strange FOLDER: what stands at the top of the project and is none of its rooms. Hidden files, and what is built, aside.
strange()
{
    (cd "$1" && ls) | grep -vx 'core\|port\|models\|tests\|tools\|build\|Makefile\|README.md'
}
! strange . | sed 's/^/# /' | grep .
result $? "the top of the project has its rooms, the Makefile and README.md alone"
mkdir -p "$out/top/core" && : >"$out/top/step"
[ "$(strange "$out/top")" = step ]
result $? "found: a file at the top"

violations . >"$out/found"
sed 's/^/# /' "$out/found"
[ ! -s "$out/found" ]
result $? "every include of core, port, models, tools and generated code goes downward"
[ -z "$(unlisted .)" ]
result $? "every folder of core and of isoc has its place in the order"

# planted FILE INCLUDE: a tree with this one include in it is found guilty.
planted()
{
    rm -rf "$out/tree"
    mkdir -p "$out/tree/$(dirname "$1")"
    printf '#include <stdint.h>\n#include %s\n' "$2" >"$out/tree/$1"
    [ "$(violations "$out/tree")" = "$1:2: $2" ]
    result $? "found: $1 includes $2"
}

planted core/runtime/loop.c '"tools/isoc/graph/graph.h"'
planted core/runtime/loop.c '"port/sim/script.h"'
planted core/runtime/loop.c '"models/pendulum.h"'
planted core/runtime/loop.h '<stdio.h>'
planted core/runtime/loop.h '<math.h>'
planted port/sim/sim.c '"core/runtime/loop.h"'
planted port/mps2/start.c '<stdlib.h>'
planted port/port.h '"core/runtime/plant.h"'
planted models/oscillator.c '"port/port.h"'
planted models/oscillator.c '<math.h>'
planted models/hil/controller.c '"core/link/link.h"'
planted build/host/float/tree/plant.c '"port/port.h"'
planted tools/isoc/main.c '"tests/tap.h"'
planted tools/isoc/main.c '"port/port.h"'
planted core/methods/euler.h '"core/runtime/plant.h"'
planted core/runtime/loop.c '"core/application/stream.h"'
planted tools/isoc/graph/graph.c '"tools/isoc/mechanism/mechanism.h"'
planted tools/isoc/implicit/jacobian.c '"tools/isoc/emit/code.h"'
planted tools/isoc/plant/plant.c '"core/application/protocol.h"'
planted tools/isoc/emit/link.c '"core/application/stream.h"'

rm -rf "$out/tree"
mkdir -p "$out/tree/core/runtime" "$out/tree/port/sim" "$out/tree/build/host/float/tree"
echo '#include "port/port.h"' >"$out/tree/core/runtime/loop.c"
echo '#include <stdio.h>' >"$out/tree/port/sim/sim.c"
echo '#  include "plant.h" /* of the same folder */' >"$out/tree/build/host/float/tree/plant.c"
[ -z "$(violations "$out/tree")" ]
result $? "includes downward are let through"
mkdir -p "$out/tree/core/extra" "$out/tree/tools/isoc/base"
[ "$(unlisted "$out/tree")" = core/extra/ ]
result $? "found: a folder that has no place in the order"
finish
