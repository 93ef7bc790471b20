#!/bin/sh
# How many steps of a plant a core makes in a second: of one alone, and of 8, 16 and 32 side by side (isoc --lanes), with all
# that a tick has: checks of inputs, guard, outputs. Compiled for this processor, whose vectors decide. Each is measured three
# times, in turns, and the best counts: what else the machine does makes it slower, never faster.
#
# Called by `make batch`, with the scene in $SCENE, the folder in $FOLDER, the compiler with its flags in $COMPILE, and the
# options of isoc as arguments; each program runs for $EACH seconds.
WHAT="make batch"
. tools/measure/common.sh
mkdir -p "$FOLDER"
build/isoc "$SCENE" -o "$FOLDER" --lanes "$@" >"$FOLDER/summary" || exit 1
for lanes in 1 8 16 32; do
    width=
    [ $lanes -eq 1 ] || width=-DISO_LANES=$lanes
    $COMPILE -march=native -Wno-psabi $width -iquote "$FOLDER" tools/measure/batch.c -o "$FOLDER/batch_$lanes" ||
        fail "$SCENE with $lanes lanes is not compiled"
done
for time in 1 2 3; do
    for lanes in 1 8 16 32; do
        "$FOLDER/batch_$lanes" "${EACH:-0.2}" || fail "the guard ended $SCENE with $lanes lanes"
    done
done >"$FOLDER/measured"
awk '$2 > best[$1] { best[$1] = $2 }
    $3 != hash && hash != "" { other = 1 }
    { hash = $3 }
    END {
        print "| plants side by side | steps of a plant in a second | times one alone |\n|--:|--:|--:|"
        for (lanes = 1; lanes <= 32; lanes *= lanes == 1 ? 8 : 2)
            printf "| %d | %.3g million | %.1f |\n", lanes, best[lanes] / 1e6, best[lanes] / best[1]
        if (other) print "make batch: a lane has other bits than the plant alone" >"/dev/stderr"
        exit other
    }' "$FOLDER/measured"
