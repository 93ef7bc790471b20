#!/bin/sh
# A scene as an FMU. Called by `make fmu`, with options of isoc, and with COMPILE, SCENE and FOLDER in the environment.
# Everything stands in build/fmu/FOLDER/: what isoc writes in sources/, a library for each platform whose compiler is
# there in binaries/, and NAME.fmu.
WHAT="make fmu"
. tools/measure/common.sh
dir=build/fmu/$FOLDER
rm -rf "$dir/sources" "$dir/binaries"
mkdir -p "$dir/sources" || exit 1
build/isoc "$SCENE" -o "$dir/sources" --fmu "$@" >"$dir/plant.txt" || exit 1
name=$(sed -n 's/.* modelIdentifier="\([^"]*\)".*/\1/p' "$dir/sources/modelDescription.xml" | head -n 1)

# library PLATFORM ENDING COMMAND...: a library of this platform, by a path that is no part of it.
library()
{
    library_file=../binaries/$1/$name.$2
    mkdir -p "$dir/binaries/$1"
    shift 2
    (cd "$dir/sources" && "$@" -fPIC -shared -fvisibility=hidden -s ./*.c core/*/*.c -o "$library_file") ||
        fail "$dir/${library_file#../} cannot be built"
}

# other COMPILER PLATFORM ENDING: the same by another compiler, where that is there.
other()
{
    if command -v "$1" >/dev/null; then
        # shellcheck disable=SC2086
        library "$2" "$3" "$1" ${COMPILE#* }
    fi
}

host=$(uname -m)-linux
# shellcheck disable=SC2086
library "$host" so $COMPILE -Wl,--build-id=none
[ "$host" = aarch64-linux ] || other aarch64-linux-gnu-gcc aarch64-linux so
other x86_64-w64-mingw32-gcc x86_64-windows dll
python3 -B tools/fmu/pack.py "$dir" "$dir/$name.fmu" || exit 1
echo "fmu $dir/$name.fmu"
