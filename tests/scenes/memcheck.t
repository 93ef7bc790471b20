#!/bin/sh
# The same under memcheck: no error and no leak, whatever the scene.
. tests/host/test.sh
begin scenes/many

FLAGS="$FLAGS -D_POSIX_C_SOURCE=200809L -g"
# shellcheck disable=SC2046,SC2086
"$CC" $FLAGS $REAL_FLAG -Wno-missing-prototypes -Dmain=isoc_main -c tools/isoc/main.c -o "$out/main.o" &&
    program many tests/scenes/many.c "$out/main.o" $(find build/obj/tools/isoc -maxdepth 1 -name '*.o' ! -name main.o) || exit
exec perl tests/scenes/cases.pl memcheck valgrind --quiet --error-exitcode=99 --leak-check=full --show-leak-kinds=all \
    --errors-for-leak-kinds=all "$out/many" tests/scenes/good.scene -o "$out"
