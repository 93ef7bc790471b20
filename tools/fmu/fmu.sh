#!/bin/sh
# A scene as an FMU. Called by `isochron fmu`, with options of isoc, and with COMPILE, SCENE, FOLDER and FMI, the
# version of the standard, in the environment; with EXCHANGE=yes an error where there is no model exchange. Everything
# stands in build/fmu/FOLDER/, for version 2 in build/fmu/FOLDER/2/: the files of isoc in sources/, a library for each
# platform whose compiler is there in binaries/, and NAME.fmu.
WHAT="isochron fmu"
. tools/measure/common.sh
dir=build/fmu/$FOLDER$([ "$FMI" = 3 ] || echo /2)
# A scene that is refused leaves the FMU of before as it was.
rm -rf "$dir/new"
mkdir -p "$dir/new" || exit 1
build/isoc "$SCENE" -o "$dir/new" --fmu --fmi "$FMI" ${EXCHANGE:+--exchange} "$@" >"$dir/plant.txt" || {
    rm -rf "$dir/new"
    exit 1
}
rm -rf "$dir/sources" "$dir/binaries"
mv "$dir/new" "$dir/sources" || exit 1
name=$(sed -n 's/.*<CoSimulation modelIdentifier="\([^"]*\)".*/\1/p' "$dir/sources/modelDescription.xml" | head -n 1)

# library PLATFORM ENDING COMMAND...: a library of this platform, by a path that is no part of it. Version 2.0 has names
# of its own for two platforms.
library()
{
    folder=$1
    [ "$FMI" = 3 ] || folder=$(echo "$1" | sed 's/^x86_64-linux$/linux64/; s/^x86_64-windows$/win64/')
    library_file=../binaries/$folder/$name.$2
    mkdir -p "$dir/binaries/$folder"
    shift 2
    (cd "$dir/sources" && "$@" "-DFMI${FMI}_OVERRIDE_FUNCTION_PREFIX" -fPIC -shared -fvisibility=hidden -s \
        ./*.c -o "$library_file") || fail "$dir/${library_file#../} cannot be built"
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
