#!/bin/sh
# isochron import: robots of URDF, MJCF. Files of the project, of which all is taken or named; files that are wrong;
# and random ones, whose accelerations are those of dynamics.py and, where Debian's libmujoco-dev is there, of
# libmujoco, to 1e-9. Ten of a hundred random robots by turns; `all` tries them all.
. tests/host/test.sh
. tests/host/project.sh
begin import
turn=$(turn_of 10 "${1-}")
count=10
[ "$turn" != all ] || turn=0 count=100

# flags: how the programs that compare are compiled. Kernels and steps are not run.
mujoco=
if echo '#include <mujoco/mujoco.h>' | $CC -E -x c - >/dev/null 2>&1; then
    mujoco='-DMUJOCO'
    library=-lmujoco
else
    library=
fi

# robots FOLDER FAMILY FIRST COUNT [PLANTED]: writes them, and the program that compares.
robots()
{
    python3 tests/tools/import/write_robots.py "$out/$@" >"$out/output" 2>"$out/errors" && comparison "$1"
}

comparison()
{
    # shellcheck disable=SC2086
    tcc $quick_flags -I. -DISO_UNROLL= $REAL_FLAG $mujoco -I"$out/$1" tests/tools/import/compare.c -o "$out/$1/compare" $library -lm \
        2>"$out/errors"
}

for family in usual odd; do
    robots $family $family $((turn * count)) $count && "$out/$family/compare" >"$out/output" 2>>"$out/errors"
    expect $? "the accelerations of $count random robots ($family) are right, from seed $((turn * count))"
    sed 's/^/# /' "$out/output"
    if [ -n "$mujoco" ]; then
        grep -q ' also by libmujoco' "$out/output" && ! grep -q '; 0 also' "$out/output"
        result $? "and those of libmujoco"
    else
        result 0 "and those of libmujoco # SKIP libmujoco-dev is not installed"
    fi
done

# Errors of an import that are just above the tolerance.
while IFS='|' read -r family what pattern; do
    robots planted "$family" $((turn * count)) 8 "$pattern" && "$out/planted/compare" 1 >"$out/output" 2>>"$out/errors"
    expect $? "found: $what"
done <<'END'
usual|gravity that is 1e-6 m/s^2 more|/gravity \(/gravity (1e-6 + /
usual|a body that is 1 um beside its place|/(?m)child (\w+)$/child \1 at (0, 0, 1e-6) m/
odd|an inertia that is 1e-6 kg*m^2 beside what is written|/inertia \(/inertia (1e-6 + /
odd|armatures of balls that are 10 ppm larger|/spin_armature /spin_armature 1.00001 * /
odd|springs of balls that are 10 ppm stiffer|/(?m)^( +)stiffness (?=\d)/\1stiffness 1.00001 * /
odd|a lift that is a millionth of a newton more|/lift \(/lift (1e-6 + /
odd|limits of all actuators that are 10 ppm larger|/most (?=\S+ N.m)/most 1.00001 * /
odd|dampings of servos that are 10 ppm larger|/bias_by_rate (?=-)/bias_by_rate 1.00001 * /
END

# Out to MJCF and back: scenes, and random ones with all that MJCF can say.
exported=$((count / 2))
python3 tests/tools/import/write_exports.py "$out/exports" $((turn * exported)) $exported tests/tools/import/export.scene models/double_pendulum.scene \
    models/arm6.scene models/tree.scene models/quadrotor.scene models/bricard.scene models/n_four_bar.scene >"$out/output" 2>"$out/errors" &&
    comparison exports && "$out/exports/compare" >"$out/output" 2>>"$out/errors"
expect $? "isoc --mjcf: the plant that comes back has the same accelerations, of $exported random scenes from seed $((turn * exported)) too"
sed 's/^/# /' "$out/output"
[ -z "$mujoco" ] || { grep -q ' also by libmujoco' "$out/output" && ! grep -q '; 0 also' "$out/output"; }
result $? "and libmujoco has them, where it is there"
# Limits act in no state of these: they are compared as they are written.
sed -n 's/^effect e_ends .*lower \([^ ]*\) .*upper \([^ ]*\) .*/\1 \2/p' "$out"/exports/seed*.scene | sort -g >"$out/limits"
sed -n 's/.* range="\([^"]*\)".*/\1/p' "$out"/exports/e*.xml | sort -g | paste -d ' ' "$out/limits" - >"$out/ranges"
awk '{ wrong += ($1 - $3)^2 + ($2 - $4)^2 > 1e-24 } END { exit wrong || NR == 0 }' "$out/ranges"
result $? "and the limits of stops"
! head -qn 1 "$out"/exports/e*.xml | grep -q '; the '
result $? "and all closures and effects are said"
sed -i 's/9\.81)/9.8100001)/' "$out/exports/e0_again/e0_again.c" &&
    sed -i '/#include "e[1-9]/d; s/robots\[\] = {\(ROBOT_E0\),.*/robots[] = {\1};/' "$out/exports/robots.h" && comparison exports &&
    "$out/exports/compare" 1 >"$out/output" 2>>"$out/errors"
expect $? "found: what comes back has other gravity"
! build/isoc tests/isoc/mechanism/lead_screw.scene --mjcf >"$out/output" 2>"$out/errors" && [ ! -s "$out/output" ] &&
    grep -q 'error: MuJoCo has no screw' "$out/errors"
expect $? "a screw is refused"
build/isoc models/pump.scene --mjcf 2>"$out/errors" | grep -q '^<!-- pump.scene.*; the closure motor'
expect $? "a closure that is not said is named"
build/isoc models/cart_pole_drive.scene --mjcf 2>"$out/errors" | grep '^<!-- cart_pole_drive.scene.*; the effect rub;' | grep -vq '; the effect ends'
expect $? "an effect that is not said is named, and one that is said is not"

python3 tests/tools/import/refused.py "$out" >"$out/output" 2>"$out/errors"
expect $? "files that are wrong are refused"
python3 tests/tools/import/named.py "$out" >"$out/output" 2>"$out/errors"
expect $? "small files: what is not taken has its reason"

python3 tests/tools/import/mutated.py "$out" "$turn" $((100 * count)) >"$out/output" 2>"$out/errors"
expect $? "of $((100 * count)) files with changes, from seed $turn, each is taken or refused"

# The project's own files: all that is not taken is named, and their scenes are compiled.
for file in arm.urdf rig.xml; do
    tools/isochron import "tests/tools/import/$file" -o "$out/$file.scene" >"$out/said" 2>"$out/errors" &&
        sed -n '/^Not taken/,$p' "$out/said" | diff - "tests/tools/import/${file%.*}.not_taken" >>"$out/errors" &&
        build/isoc "$out/$file.scene" -o "$out/plant" >"$out/output" 2>>"$out/errors"
    expect $? "$file: what is not taken is named, and its scene is compiled"
done
finish
