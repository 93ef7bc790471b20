#!/bin/sh
# FMUs against the plants that they are of, by an importer of the project's own: rows of trace.csv to the last bit and hashes, in
# steps of one tick and of many, several instances, resets, FMU states as bytes; calls that are wrong; a tunable that is set is as
# if the scene set it. One of the plants has faults, memories and functions of time; another begins with sub-steps that vary.
. tests/host/test.sh
begin fmu
optimised -O0
real float

# plant NAME SCENE SECONDS [OPTION...]: its FMU, and a run of it outside; $list gets what check.py takes.
list=
plant()
{
    name=$1
    scene=$2
    seconds=$3
    shift 3
    build/isoc "$scene" -o "$out/$name" --real "$real" "$@" >"$out/summary" 2>"$out/said" &&
        build/isoc "$scene" -o "$out/$name/fmu/sources" --fmu --real "$real" "$@" >"$out/summary" 2>"$out/said" &&
        program "$name.run" "$out/$name/plant.c" core/runtime/loop.c core/application/*.c core/numbers/self_check.c \
            port/sim/*.c port/host/console.c &&
        build/trace -o "$out/$name" -- "$out/$name.run" "${seconds}000000000" >"$out/$name/told" || return
    identifier=$(sed -n 's/.* modelIdentifier="\([^"]*\)".*/\1/p' "$out/$name/fmu/sources/modelDescription.xml")
    mkdir -p "$out/$name/fmu/binaries/$(uname -m)-linux"
    # shellcheck disable=SC2046
    (cd "$out/$name/fmu/sources" && "$CC" ${FLAGS% -I.} -fPIC -shared -fvisibility=hidden $(find . -name '*.c') \
        -o "../binaries/$(uname -m)-linux/$identifier.so") &&
        python3 -B tools/fmu/pack.py "$out/$name/fmu" "$out/$name.fmu" &&
        list="$list $out/$name.fmu $out/$name/trace.csv $out/$name/told"
}

plant drive models/cart_pole_drive.scene 9 && plant adams models/double_pendulum.scene 1 --method adams --tolerance 1e-6 &&
    real double && plant loop models/four_bar.scene 1 --method ab4
result $? "plants and their FMUs are built, with all warnings"
# shellcheck disable=SC2086
joined importer python3 -B tests/fmu/check.py $list

# What the scene sets at its times, an importer sets at these.
real float
mkdir -p "$out/models"
cp -R models/parts "$out/models"
grep -v '^at ' models/cart_pole_drive.scene >"$out/models/cart_pole_drive.scene"
plant unset "$out/models/cart_pole_drive.scene" 1
joined tunables python3 -B tests/fmu/tunables.py "$out/unset.fmu" "$out/drive/trace.csv" "$out/drive/told" \
    6:reading_active:1 6.5:reading_active:0 8:drive_open:1

# Controls.
awk -F, -v OFS=, 'NR == 5000 { $3 += 0.001 } { print }' "$out/drive/trace.csv" >"$out/wrong.csv"
python3 -B tests/fmu/check.py "$out/drive.fmu" "$out/wrong.csv" "$out/drive/told" >"$out/found"
grep -q '^not ok .* rows and hash' "$out/found"
result $? "found: another row"
cp "$out/drive.fmu" "$out/first.fmu" && touch "$out/drive/fmu/sources/"*.c &&
    python3 -B tools/fmu/pack.py "$out/drive/fmu" "$out/drive.fmu" && cmp "$out/first.fmu" "$out/drive.fmu"
result $? "the same files at another time give the same archive"
finish
