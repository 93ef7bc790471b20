#!/bin/sh
# The linear model of a scene about a point, with its modes, and a Bode plot that is checked on the plant. Called by
# `isochron linear`, with options of isoc, and with COMPILE, SCENE, NAME, FOLDER, AT, TRIM and BODE in the environment;
# AT is in ns. Everything stands in build/linear/NAME/: matrices.tsv, states.tsv, modes.tsv, linear_model.m,
# linear_model.py, and with BODE bode.tsv, bode.svg and bode.png.
WHAT="isochron linear"
. tools/measure/common.sh
dir=build/linear/$FOLDER
mkdir -p "$dir" || exit 1
rm -f "$dir"/*.tsv "$dir"/linear_model.* "$dir"/point.txt "$dir"/state.txt "$dir"/bode.*

# The plant in double with the program that runs and drives it, for AT and BODE.
if [ -n "$AT$BODE" ]; then
    build/isoc "$SCENE" -o "$dir" "$@" >"$dir/plant.txt" || exit 1
    # shellcheck disable=SC2086
    $COMPILE -DISO_REAL_DOUBLE -DISO_UNROLL= -I"$dir" tools/linear/*.c tools/file/file.c "$dir/plant.c" core/numbers/*.c -o "$dir/linear" -lm ||
        fail "$dir/linear cannot be built"
fi
if [ -n "$AT" ]; then
    "$dir/linear" reach "$AT" >"$dir/state.txt" || fail "the plant does not come so far"
    set -- "$@" --state "$dir/state.txt"
fi
if [ -n "$TRIM" ]; then
    set -- "$@" --trim "$TRIM"
fi
build/isoc "$SCENE" -o "$dir" --linear "$@" || exit 1
if [ -n "$BODE" ]; then
    "$dir/linear" bode "$dir/point.txt" "$BODE" >"$dir/bode.tsv" 2>"$dir/measured.txt" || { cat "$dir/measured.txt" >&2 && exit 1; }
    cat "$dir/measured.txt"
fi
for file in matrices.tsv states.tsv modes.tsv linear_model.m linear_model.py; do
    echo "$dir/$file"
done
if [ -n "$BODE" ]; then
    echo "$dir/bode.tsv"
    sh tools/plot/draw.sh "$dir/bode.gnuplot" bode "$NAME" "$BODE" "$dir/bode.tsv" || fail "gnuplot does not draw $dir/bode.gnuplot"
fi
