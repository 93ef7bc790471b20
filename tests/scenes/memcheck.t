#!/bin/sh
# The same under memcheck: no error and no leak, whatever the scene.
exec perl tests/scenes/cases.pl valgrind --quiet --error-exitcode=99 --leak-check=full --show-leak-kinds=all \
    --errors-for-leak-kinds=all build/isoc
