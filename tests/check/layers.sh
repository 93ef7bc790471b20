#!/bin/sh
# Includes go only downward: generated and hand-written plants -> core -> port's header; ports know the number type only;
# the target's code uses no header of a hosted C library; nothing includes tools or tests but themselves.
. tests/host/test.sh
begin check/layers

# violations ROOT: prints file:line: include, for each one that its layer forbids.
violations()
{
    (cd "$1" && find core port models tools build -name '*.[ch]' 2>/dev/null | grep -v '^build/tests/' | sort) |
        while read -r file; do
            case $file in
            core/*) own='"(core/[a-z0-9_]+\.h|port/port\.h)"' ;;
            port/sim/* | port/linux/*) own='"(port/[a-z0-9_/]+\.h|core/real\.h)"|<[a-z0-9_/]+\.h>' ;;
            port/*) own='"(port/[a-z0-9_/]+\.h|core/real\.h)"' ;;
            models/*) own='"core/[a-z0-9_]+\.h"' ;;
            build/*) own='"(core/[a-z0-9_]+\.h|plant\.h)"' ;;
            tools/*) own='"(tools|core)/[a-z0-9_/]+\.h"|<[a-z0-9_/]+\.h>' ;;
            esac
            awk -v file="$file" -v own="^($own|<(stdint|stddef|stdbool|float|limits|string)\\.h>)\$" '
                /^[ \t]*#[ \t]*include/ {
                    sub(/^[ \t]*#[ \t]*include[ \t]*/, "")
                    sub(/[ \t]*(\/\*.*)?$/, "")
                    if ($0 !~ own) print file ":" FNR ": " $0
                }' "$1/$file"
        done
}

violations . >"$out/found"
sed 's/^/# /' "$out/found"
[ ! -s "$out/found" ]
result $? "every include of core, port, models, tools and generated code goes downward"

# planted FILE INCLUDE: a tree with this one include in it is found guilty.
planted()
{
    rm -rf "$out/tree"
    mkdir -p "$out/tree/$(dirname "$1")"
    printf '#include <stdint.h>\n#include %s\n' "$2" >"$out/tree/$1"
    [ "$(violations "$out/tree")" = "$1:2: $2" ]
    result $? "found: $1 includes $2"
}

planted core/loop.c '"tools/isoc/graph.h"'
planted core/loop.c '"port/sim/script.h"'
planted core/loop.c '"models/pendulum.h"'
planted core/loop.h '<stdio.h>'
planted core/loop.h '<math.h>'
planted port/sim/sim.c '"core/loop.h"'
planted port/mps2/start.c '<stdlib.h>'
planted port/port.h '"core/plant.h"'
planted models/oscillator.c '"port/port.h"'
planted models/oscillator.c '<math.h>'
planted build/host/float/tree/plant.c '"port/port.h"'
planted tools/isoc/main.c '"tests/tap.h"'
planted tools/isoc/main.c '"port/port.h"'

rm -rf "$out/tree"
mkdir -p "$out/tree/core" "$out/tree/port/sim" "$out/tree/build/host/float/tree"
echo '#include "port/port.h"' >"$out/tree/core/loop.c"
echo '#include <stdio.h>' >"$out/tree/port/sim/sim.c"
echo '#  include "plant.h" /* of the same folder */' >"$out/tree/build/host/float/tree/plant.c"
[ -z "$(violations "$out/tree")" ]
result $? "includes downward are let through"
finish
