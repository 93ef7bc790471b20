#!/bin/sh
# How many steps of a plant a core makes in a second: of one alone, and of 8, 16 and 32 side by side (isoc --lanes),
# with all parts of a tick: checks of inputs, guard, outputs. Compiled for this processor, as the width of its vectors
# matters. Beside them those of MuJoCo, where its library is installed, with the mechanism that isoc --mjcf writes: RK4
# of the same step, in double, without contact. Each is measured three times, in turns, and the best counts: other work
# of the machine makes it slower, never faster.
#
# Called by `make batch`, with the scene in $SCENE, the folder in $FOLDER, the compiler with its flags in $COMPILE, and
# the options of isoc as arguments; each program runs for $EACH seconds.
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
# $other: why there is no row of MuJoCo.
other=
if ! echo '#include <mujoco/mujoco.h>' | $COMPILE -E -x c - >"$FOLDER/headers" 2>&1; then
    other="libmujoco is not installed (apt-get install libmujoco-dev)"
elif ! build/isoc "$SCENE" --mjcf "$@" >"$FOLDER/mujoco.xml" 2>"$FOLDER/errors"; then
    other=$(sed -n 's/.*error: //p' "$FOLDER/errors")
elif ! $COMPILE tools/measure/mujoco.c -o "$FOLDER/mujoco" -lmujoco 2>"$FOLDER/errors" ||
    ! "$FOLDER/mujoco" "$FOLDER/mujoco.xml" 0 >"$FOLDER/said" 2>"$FOLDER/errors"; then
    other=$(tail -n 1 "$FOLDER/errors")
fi
for time in 1 2 3; do
    for lanes in 1 8 16 32; do
        "$FOLDER/batch_$lanes" "${EACH:-0.2}" || fail "the guard ended $SCENE with $lanes lanes"
    done
    [ -n "$other" ] || "$FOLDER/mujoco" "$FOLDER/mujoco.xml" "${EACH:-0.2}" || fail "MuJoCo does not run $FOLDER/mujoco.xml"
done >"$FOLDER/measured"
awk '$2 > best[$1] { best[$1] = $2 }
    $1 == "mujoco" { version = $3; next }
    $3 != hash && hash != "" { other = 1 }
    { hash = $3 }
    function row(name, steps, times) {
        times = steps / best[1]
        printf "| %s | %.3g million | " (times < 1 ? "%.2g" : "%.1f") " |\n", name, steps / 1e6, times
    }
    END {
        print "| plants side by side | steps of a plant in a second | times one alone |\n|--:|--:|--:|"
        for (lanes = 1; lanes <= 32; lanes *= lanes == 1 ? 8 : 2) row(lanes, best[lanes])
        if (version != "") row("MuJoCo " version ", one in double, RK4", best["mujoco"])
        if (other) print "make batch: a lane has other bits than the plant alone" >"/dev/stderr"
        exit other
    }' "$FOLDER/measured"
status=$?
if [ -n "$other" ]; then
    echo "No row of MuJoCo: $other."
else
    sed -n '1s/<!-- [^;]*; \(.*\)\. -->/MuJoCo runs without \1./p' "$FOLDER/mujoco.xml"
fi
exit $status
