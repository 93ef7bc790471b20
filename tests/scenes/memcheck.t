#!/bin/sh
# The same under memcheck: no error and no leak, whatever the scene.
. tests/host/test.sh
begin scenes/many

# The compiler's objects: of its files and of its folders, and of what it has in it. That of a source that is gone is no part.
objects=$(for source in tools/isoc/*.c tools/isoc/*/*.c; do
    case $source in
    */main.c) ;;
    tools/isoc/*/*) echo "build/obj/${source%/*}.o" ;;
    *) echo "build/obj/${source%.c}.o" ;;
    esac
done | sort -u && ls build/obj/tools/isoc/*_files.o)

FLAGS="$FLAGS -D_POSIX_C_SOURCE=200809L -g"
# shellcheck disable=SC2086
"$CC" $FLAGS $REAL_FLAG -Wno-missing-prototypes -Dmain=isoc_main -c tools/isoc/main.c -o "$out/main.o" &&
    program many tests/scenes/many.c "$out/main.o" $objects || exit
exec perl tests/scenes/cases.pl memcheck valgrind --quiet --error-exitcode=99 --leak-check=full --show-leak-kinds=all \
    --errors-for-leak-kinds=all "$out/many" tests/scenes/good.scene -o "$out"
