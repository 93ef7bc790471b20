#!/bin/sh
# Every method keeps its order on closed loops, with the stabilisation that a scene has by itself.
. tests/host/test.sh
begin order_loops
one_isoc
. tests/core/methods/order/settled.sh
EXTRA=-O0 # compiled once and run shortly
program loops.o -c tests/core/methods/order/loops.c
result $? "tests/core/methods/order/loops.c compiles"

# looped SCENE ARGUMENT...: the orders of all methods on it.
looped()
{
    name=$(basename "$1" .scene)
    sed '/^stabilisation/d' "$1" >"$out/$name.scene"
    shift
    build/isoc "$out/$name.scene" -o "$out/$name" --real double --method bdf4 >"$out/$name.summary" 2>&1 &&
        settled "$name" "$out/$name/plant.c" "$out/loops.o"
    result $? "$name builds"
    joined "$name" "$out/$name.run" "$@"
}

looped models/four_bar.scene 0.25 12
looped tests/core/methods/order/governor.scene 1 11
looped tests/core/methods/order/three_free.scene 0.25 10
# The crank, its speed, the slider and its speed after 0.5 s, of the motion with one freedom that the energy gives,
# integrated to 24 digits by two methods; the mechanism is that of the IFToMM library of multibody problems (Haug 1989).
looped tests/core/methods/order/spatial.scene 0.5 13 0 5.58376255330730439827198 1 14.4081608102003757545 \
    2 0.184952629777802628835 3 -0.00456029063251560051612

# order STABILISATION: of rk4 on the four-bar linkage, as isochron drift measures it.
order()
{
    { cat models/four_bar.scene && echo "stabilisation $1"; } >"$out/held.scene"
    for part in coarse:1ms middle:500us fine:250us; do
        isoc "$out/summary" '' "$out/held.scene" -o "$out/order" --real double --name "${part%:*}" --step "${part#*:}" || return 1
    done
    EXTRA="-O0 -I$out/order" program order.run tools/measure/order.c "$out/order/coarse.c" "$out/order/middle.c" \
        "$out/order/fine.c" && "$out/order.run" 0.25 | sed -n 's/^order //p'
}

for stabilisation in projection lagrangian; do
    found=$(order $stabilisation) && awk -v order="$found" 'BEGIN { exit !(order > 3.9 && order < 4.1) }'
    result $? "rk4 with $stabilisation: order $found"
done
found=$(order baumgarte) && awk -v order="$found" 'BEGIN { exit !(order != "" && order < 3) }'
result $? "control: rk4 with gains that follow the step: order $found"
finish
