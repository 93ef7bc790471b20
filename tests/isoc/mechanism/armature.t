#!/bin/sh
# An armature against a flywheel on the ground with a gear, by both formulations and both ways to the factors of an
# implicit method; and that the account of energy has it.
. tests/host/test.sh
. tests/host/project.sh
begin mechanism/armature
one_isoc
quick

# compiled NAME SCENE [OPTION...]: its plant, in $out/NAME.
plants=
EXTRA=
compiled()
{
    compiled_name=$1
    compiled_scene=$2
    shift 2
    isoc "$out/output" "$out/errors" "$compiled_scene" -o "$out/$compiled_name" --name "$compiled_name" --real double "$@" || return
    case $plants in
    *"/$compiled_name.c"*) ;;
    *) plants="$plants $out/$compiled_name/$compiled_name.c" EXTRA="$EXTRA -I$out/$compiled_name" ;;
    esac
}

# wheels: the scene with flywheels; that of the slide turns by 1 rad where it slides by 1 m.
wheels()
{
    sed 's/; armature [^;}]*//' tests/isoc/mechanism/armature.scene
    while read -r joint inertia ratio; do
        echo "body ${joint}_wheel { mass 0.1 kg; inertia ($inertia / 2, $inertia / 2, $inertia) }"
        echo "joint ${joint}_turn revolute { parent ground; child ${joint}_wheel; axis z; start 0 deg }"
        echo "close ${joint}_gear gear { first ${joint}_turn; second $joint; ratio $ratio }"
    done <<END
shoulder (0.2*kg*m^2) 1
elbow rotor 1
rail (0.3*kg*m^2) 1*rad/m
END
}

wheels | sed 's/(0\.\([23]\)\*kg\*m^2)/0.\1 kg*m^2/g; s/1\*rad/1 rad/' >"$out/wheels.scene"
compiled composite tests/isoc/mechanism/armature.scene --formulation composite &&
    compiled articulated tests/isoc/mechanism/armature.scene --formulation articulated && compiled wheels "$out/wheels.scene" &&
    compiled full tests/isoc/mechanism/armature.scene --method rosenbrock --factors full &&
    compiled thin tests/isoc/mechanism/armature.scene --method rosenbrock --factors sparse
expect $? "isoc compiles armatures, and flywheels in their place"
# shellcheck disable=SC2086
program armature tests/isoc/mechanism/armature.c tests/host/report.c $plants 2>"$out/errors"
expect $? "they are one program"
joined "an armature" "$out/armature"

sed 's/armature 0.2 kg/armature 0.2001 kg/' tests/isoc/mechanism/armature.scene >"$out/other.scene"
# shellcheck disable=SC2086
compiled composite "$out/other.scene" --formulation composite && program other tests/isoc/mechanism/armature.c tests/host/report.c $plants &&
    ! "$out/other" >"$out/tap" && grep -q '^not ok 1' "$out/tap" && grep -q '^not ok 3' "$out/tap"
expect $? "found: another armature"
finish
