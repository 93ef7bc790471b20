#!/bin/sh
# FMUs of both versions against the plants that they are of, by an importer of the project's own: rows of trace.csv to
# the last bit and hashes, in steps of one tick and of many, several instances, resets, FMU states as bytes; messages;
# calls that are wrong; a tunable that is set is as if the scene set it. One of the plants has faults, memories and
# functions of time; another begins with sub-steps that vary; a third has an input with limits. Every call in every
# state of the standard: those that are wrong change nothing. What outputs depend on is what moves them.
. tests/host/test.sh
begin fmu
one_isoc
optimised -O0
real float

machine=$(uname -m)-linux
list=

# plant NAME VERSIONS SCENE SECONDS [OPTION...]: a run of it outside, and its FMU of each version, NAME2.fmu and
# NAME3.fmu; $list gets what check.py takes.
plant()
{
    name=$1
    versions=$2
    scene=$3
    seconds=$4
    shift 4
    isoc "$out/summary" "$out/said" "$scene" -o "$out/$name" --real "$real" "$@" &&
        program "$name.run" "$out/$name/plant.c" core/runtime/loop.c core/application/*.c core/numbers/self_check.c \
            port/host/*.c port/unix/console.c &&
        build/trace -o "$out/$name" -- "$out/$name.run" "${seconds}000000000" >"$out/$name/told" || return
    for version in $versions; do
        export_fmu "$name$version" "$@" || return
        list="$list $out/$name$version.fmu $out/$name/trace.csv $out/$name/told"
    done
}

# export_fmu NAME [OPTION...]: the FMU of $scene and $version.
export_fmu()
{
    fmu=$1
    shift
    folder=$machine
    [ "$version$machine" != 2x86_64-linux ] || folder=linux64
    isoc "$out/summary" "$out/said" "$scene" -o "$out/$fmu/sources" --fmu --fmi "$version" --real "$real" "$@" || return
    identifier=$(sed -n 's/.*<CoSimulation modelIdentifier="\([^"]*\)".*/\1/p' \
        "$out/$fmu/sources/modelDescription.xml")
    mkdir -p "$out/$fmu/binaries/$folder"
    build_fmu
}

# build_fmu: the library of its sources, and the archive.
build_fmu()
{
    # shellcheck disable=SC2046
    (cd "$out/$fmu/sources" && "$host_compiler" ${FLAGS% -I.} "-DFMI${version}_OVERRIDE_FUNCTION_PREFIX" -fPIC -shared \
        -fvisibility=hidden $(find . -name '*.c') -o "../binaries/$folder/$identifier.so") &&
        python3 -B tools/fmu/pack.py "$out/$fmu" "$out/$fmu.fmu"
}

mkdir -p "$out/models"
cp -R models/parts "$out/models"
sed 's/^input motor$/input motor in -1 N*m to 1 N*m/' models/four_bar.scene >"$out/models/four_bar.scene"
plant drive '2 3' models/cart_pole_drive.scene 9 &&
    plant adams 3 models/double_pendulum.scene 1 --method adams --tolerance 1e-6 &&
    real double && plant loop '2 3' "$out/models/four_bar.scene" 1 --method ab4
result $? "plants and their FMUs are built, with all warnings"
# shellcheck disable=SC2086
joined importer python3 -B tests/tools/fmu/check.py $list
joined states python3 -B tests/tools/fmu/states.py "$out/drive2.fmu" "$out/drive/told" "$out/drive3.fmu" "$out/drive/told" \
    "$out/loop2.fmu" "$out/loop/told" "$out/loop3.fmu" "$out/loop/told"
joined dependencies python3 -B tests/tools/fmu/dependencies.py "$out/drive2.fmu" "$out/drive3.fmu" "$out/adams3.fmu" \
    "$out/loop3.fmu"

# What the scene sets at its times, an importer sets at these.
real float
grep -v '^at ' models/cart_pole_drive.scene >"$out/models/cart_pole_drive.scene"
scene=$out/models/cart_pole_drive.scene version=2
export_fmu unset
joined tunables python3 -B tests/tools/fmu/tunables.py "$out/unset.fmu" "$out/drive/trace.csv" "$out/drive/told" \
    6:reading_active:1 6.5:reading_active:0 8:drive_open:1

# Controls.
awk -F, -v OFS=, 'NR == 5000 { $3 += 0.001 } { print }' "$out/drive/trace.csv" >"$out/wrong.csv"
python3 -B tests/tools/fmu/check.py "$out/drive2.fmu" "$out/wrong.csv" "$out/drive/told" >"$out/found"
grep -q '^not ok .* rows and hash' "$out/found"
result $? "found: another row"
sed 's/fmu_may(instance, "fmi2DoStep", FMU_STEPPING)/fmu_may(instance, "fmi2DoStep", FMU_STEPPING | FMU_TERMINATED)/' \
    "$out/drive2/sources/fmi2.c" >"$out/unset/sources/fmi2.c"
sed 's/^    if (!(start == 0.0)) {$/    f->now.stop = DBL_MAX;\n&/' "$out/drive2/sources/fmu_instance.h" \
    >"$out/unset/sources/fmu_instance.h"
build_fmu && python3 -B tests/tools/fmu/states.py --find "$out/unset.fmu" "$out/drive/told" >"$out/found"
grep -q '^DoStep in E: not refused$' "$out/found" &&
    grep -q '^wrong arguments of SetupExperiment in N: changes something$' "$out/found"
result $? "found: a step after the end, and a refused call that sets the end of the run"
# In sources that a program links every name begins with that of the model, in 2.0 by itself.
"$CC" -std=c11 -O0 $NUMERICS -c "$out/drive2/sources/fmi2.c" -o "$out/linked.o" &&
    nm --defined-only --extern-only "$out/linked.o" >"$out/names" &&
    grep -q ' T cart_pole_drive_fmi2DoStep$' "$out/names" &&
    ! grep -v ' T cart_pole_drive_fmi2' "$out/names"
result $? "sources of 2.0 have no name that is not of the model"
cp "$out/drive3.fmu" "$out/first.fmu" && touch "$out/drive3/sources/"*.c &&
    python3 -B tools/fmu/pack.py "$out/drive3" "$out/drive3.fmu" && cmp "$out/first.fmu" "$out/drive3.fmu"
result $? "the same files at another time give the same archive"

# A scene that is refused.
before=$out/refused
rm -rf "$before"
mkdir -p "$before/sources" && echo kept >"$before/sources/kept" && cp "$before/sources/kept" "$before/kept.fmu"
! tools/isochron fmu models/four_bar.scene --exchange --out "$before" >"$out/summary" 2>"$out/told" &&
    grep -q 'error: no model exchange' "$out/told" && cmp -s "$before/sources/kept" "$before/kept.fmu" && [ ! -e "$before/new" ]
result $? "isochron fmu: a scene that is refused leaves the FMU of before"
finish
