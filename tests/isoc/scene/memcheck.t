#!/bin/sh
# The same as tests/isoc/scene/scenes.t under memcheck: no error and no leak, whatever the scene; of the bad scenes a
# third each time.
. tests/host/test.sh
turn=$(turn_of 3 "${1-}")
echo "# turn $turn of the bad scenes"
exec perl tests/isoc/scene/cases.pl memcheck "$turn" valgrind --quiet --leak-check=full --show-leak-kinds=all --errors-for-leak-kinds=all \
    build/tests/requests
