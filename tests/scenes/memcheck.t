#!/bin/sh
# The same under memcheck: no error and no leak, whatever the scene; of the bad scenes a third each time.
. tests/host/test.sh
begin scenes/many
turn=$(turn_of 3 "${1-}" tools/isoc tests/scenes)
echo "# turn $turn of the bad scenes"

objects=$(isoc_parts o && for source in tools/isoc/*.c; do
    [ "$source" = tools/isoc/main.c ] || echo "build/obj/${source%.c}.o"
done)

FLAGS="$FLAGS -D_POSIX_C_SOURCE=200809L -g"
# shellcheck disable=SC2086
"$CC" $FLAGS $REAL_FLAG -Wno-missing-prototypes -Dmain=isoc_main -c tools/isoc/main.c -o "$out/main.o" &&
    program many tests/scenes/many.c "$out/main.o" $objects || exit

# What the cases have in common: good scenes, and one that is told much of.
{ sed 's/kg/kgg/; s/step .*/step 1 kg ?/' tests/scenes/good.scene && echo 'output y = position of nothing'; } >"$out/bad.scene"
exec perl tests/scenes/cases.pl memcheck "$turn" valgrind --quiet --error-exitcode=99 --leak-check=full --show-leak-kinds=all \
    --errors-for-leak-kinds=all "$out/many" "$out" \
    "$out/bad.scene" tests/scenes/good.scene tests/scenes/closed.scene tests/scenes/effect.scene tests/scenes/loop.scene
