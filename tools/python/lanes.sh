#!/bin/sh
# Makes the library of plants side by side for tools/python/lanes.py, FOLDER/lanes.so, for this processor:
#
#     lanes.sh SCENE FOLDER LANES [OPTION...]
#
# LANES is 2, 4, 8, 16 or 32; the options are those of isoc, such as --method and --real. CC is the compiler.
# shellcheck disable=SC2086
set -eu
scene=$1 folder=$2 lanes=$3
shift 3
build/isoc "$scene" -o "$folder" --lanes "$@" >"$folder.txt"
[ "$(sed -n 's/^real //p' "$folder.txt")" = float ] && real= || real=-DISO_REAL_DOUBLE
without=
for array in INPUTS PARAMETERS; do
    grep -q "^ *PLANT_$array\$" "$folder/plant.h" || without="$without -DISO_SIDE_NO_$array"
done
${CC:-cc} -std=c11 -O2 -march=native $(cat tools/build/numerics) -Wno-psabi -fPIC -fvisibility=hidden -shared $real \
    -DISO_LANES="$lanes" $without -iquote "$folder" -I. tools/python/lanes.c core/numbers/self_check.c -o "$folder/lanes.so"
echo "library $folder/lanes.so"
