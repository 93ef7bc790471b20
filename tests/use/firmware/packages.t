#!/bin/sh
# The folder of --standalone as a package: built by CMake as a whole and as a part, configured as a module of Zephyr by
# stand-ins of its functions, compiled as a library of Arduino with its headers in C++, its descriptions read.
. tests/host/test.sh
begin firmware_packages
arduino=/usr/share/arduino/hardware/arduino/avr

# folder [OPTION...]: the plant in $out/swing.
folder()
{
    rm -rf "$out/swing"
    build/isoc models/pendulum.scene -o "$out/swing" --name swing --standalone "$@" >"$out/summary" 2>"$out/errors"
}

# configured DIR [OPTION...]: by CMake, into $out/made. What it finds out of the compiler the first time, it keeps in a
# folder named as its version; it finds it there the next time.
configured()
{
    configured_dir=$1
    shift
    rm -rf "$out/first"
    known=
    if [ -e "$out/made" ]; then
        mv "$out/made" "$out/first"
        mkdir -p "$out/made/CMakeFiles"
        mv "$out"/first/CMakeFiles/[0-9]* "$out/made/CMakeFiles"
        known=-DCMAKE_PLATFORM_INFO_INITIALIZED=1
    fi
    # shellcheck disable=SC2086
    cmake -S "$configured_dir" -B "$out/made" -DCMAKE_BUILD_TYPE=Release -DCMAKE_RULE_MESSAGES=OFF $known "$@" >"$out/said" 2>&1
}

folder
# A program beside the folder, with an optimisation that CMake chooses.
mkdir -p "$out/user"
cp tests/use/firmware/alone.c core/runtime/hash.h "$out/user"
cat >"$out/user/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.13)
project(user C)
add_subdirectory(../swing swing)
add_executable(user alone.c)
target_compile_definitions(user PRIVATE NAMED)
target_include_directories(user PRIVATE .)
target_link_libraries(user swing)
END
configured "$out/user" && cmake --build "$out/made" >"$out/said" 2>&1 && "$out/made/user" >"$out/hashes"
result $? "CMake: a program with the plant as a part"
gcc -std=c11 -O2 -ffp-contract=off -DNAMED -I"$out/swing" -I"$out/user" "$out/user/alone.c" "$out/swing/swing.c" -o "$out/alone" &&
    "$out/alone" | cmp -s - "$out/hashes" && [ "$(wc -l <"$out/hashes")" -eq 2 ]
result $? "it moves as when it is compiled by hand: $(head -n 1 "$out/hashes")"
configured "$out/swing" && cmake --build "$out/made" >"$out/said" 2>&1 && [ -f "$out/made/libswing.a" ]
result $? "CMake: the folder by itself"

# Zephyr's functions, as far as a module calls them, on a library of CMake.
mkdir -p "$out/zephyr"
cat >"$out/zephyr/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.13)
project(zephyr C)
set(ZEPHYR_BASE ${CMAKE_CURRENT_SOURCE_DIR})
macro(zephyr_library_named name)
  set(ZEPHYR_CURRENT_LIBRARY ${name})
  add_library(${name} STATIC "")
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
endmacro()
function(zephyr_library_sources)
  target_sources(${ZEPHYR_CURRENT_LIBRARY} PRIVATE ${ARGN})
endfunction()
function(zephyr_library_compile_options)
  target_compile_options(${ZEPHYR_CURRENT_LIBRARY} PRIVATE ${ARGN})
endfunction()
function(zephyr_include_directories)
endfunction()
add_subdirectory(../swing swing)
END
configured "$out/zephyr" -DCONFIG_ISOCHRON_SWING=y && cmake --build "$out/made" >"$out/said" 2>&1 && [ -f "$out/made/swing/libswing.a" ]
result $? "Zephyr: the module is a library"
configured "$out/zephyr" && cmake --build "$out/made" >"$out/said" 2>&1 && [ ! -e "$out/made/swing/libswing.a" ]
result $? "Zephyr: it is left out where its option is off"
# What the module names is there, under the names that the build asks for.
awk '$1 == "name:" { name = $2 } $1 == "cmake:" { cmake = $2 } $1 == "kconfig:" { kconfig = $2 } END { print name, cmake, kconfig }' \
    "$out/swing/zephyr/module.yml" >"$out/module" && read -r name cmake kconfig <"$out/module" && [ "$name" = swing ] &&
    [ -f "$out/swing/$cmake/CMakeLists.txt" ] && [ "$(sed -n 's/^config //p' "$out/swing/$kconfig")" = ISOCHRON_SWING ]
result $? "Zephyr: the module names its files and its option"

# A sketch, in C++ as the Arduino compiles it: the files at the top of a library, with that folder alone among the
# paths.
cat >"$out/sketch.cpp" <<'END'
#include <Arduino.h>
#include <swing.h>
#include <core/runtime/tick.h>
static swing_memory memory;
static const iso_plant swing = swing_plant(&memory);
static uint32_t tick_number;
void setup()
{
    pinMode(LED_BUILTIN, OUTPUT);
    digitalWrite(LED_BUILTIN, iso_plant_start(&swing) ? HIGH : LOW);
}
void loop()
{
    (void)iso_plant_tick(&swing, tick_number++);
}
END
avr="-mmcu=atmega1284p -Os -w -ffunction-sections -DF_CPU=16000000L -DARDUINO=10819 -DLED_BUILTIN=13 -I$arduino/cores/arduino
    -I$arduino/variants/standard -I$out/swing"

# sketched: the sketch and the top of the library compile, and one has what the other wants.
sketched()
{
    rm -f "$out"/*.o
    # shellcheck disable=SC2086
    avr-g++ -std=gnu++11 -fno-exceptions -fno-threadsafe-statics -mmcu=atmega1284p ${avr#* } -c "$out/sketch.cpp" -o "$out/sketch.o" 2>"$out/errors" &&
        for sketched_source in "$out"/swing/*.c; do
            avr-gcc -std=gnu11 -mmcu=atmega1284p ${avr#* } -c "$sketched_source" -o "$out/${sketched_source##*/}.o" || return
        done 2>"$out/errors" && avr-nm -g --defined-only "$out/swing.c.o" "$out/sketch.o" | awk 'NF == 3 { print $3 }' | sort -u >"$out/given" &&
        avr-nm -u "$out/sketch.o" "$out/swing.c.o" | awk '$1 == "U" { print $2 }' | sort -u | comm -23 - "$out/given" >"$out/wanted" &&
        grep -qx digitalWrite "$out/wanted" && grep -qx swing_model "$out/given" && ! grep -E 'swing|iso_' "$out/wanted"
}

sketched
result $? "Arduino: a sketch in C++ and the library"
awk -F = '$1 == "name" && $2 == "swing" { n++ } $1 == "includes" && $2 == "swing.h" { n++ }
    $1 ~ /^(version|author|maintainer|sentence|paragraph|category|url|architectures)$/ { n++ } END { exit n != 10 }' "$out/swing/library.properties"
result $? "Arduino: library.properties has what it must"
python3 - "$out/swing" <<'END'
import json, os, sys
library = json.load(open(sys.argv[1] + "/library.json"))
files = [part[2:-1] for part in library["build"]["srcFilter"].split() if part.startswith("+")]
assert library["name"] == "swing" and "swing.c" in files and all(os.path.exists(sys.argv[1] + "/" + f) for f in files)
assert os.path.exists(sys.argv[1] + "/" + library["headers"])
END
result $? "PlatformIO: library.json names files that are there"

# Controls.
printf 'static inline int *bad(void) { void *p = 0; return p; }\n' >>"$out/swing/swing.h" && ! sketched && grep -q 'invalid conversion' "$out/errors"
result $? "found: a header that is C alone"
folder && sed -i 's/STATIC swing\.c/STATIC swinging.c/' "$out/swing/CMakeLists.txt" &&
    ! { configured "$out/user" && cmake --build "$out/made" >"$out/said" 2>&1; } && grep -q swinging.c "$out/said"
result $? "found: a library of a file that is not there"
finish
