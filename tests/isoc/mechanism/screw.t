#!/bin/sh
# A screw against a cylindrical joint with a gear, and as the screw of a nut on a guide.
. tests/host/test.sh
begin mechanism/screw
one_isoc
real double

# compiled NAME SCENE [OPTION...]: its plant, in $out/NAME.
compiled()
{
    compiled_name=$1
    compiled_scene=$2
    shift 2
    isoc "$out/summary" '' "$compiled_scene" -o "$out/$compiled_name" --name "$compiled_name" --real double "$@" || return
    case $plants in
    *"/$compiled_name.c"*) ;;
    *) plants="$plants $out/$compiled_name/$compiled_name.c" ;;
    esac
    EXTRA="$EXTRA -I$out/$compiled_name"
}

# The pair in the place of the screw.
sed -e 's/^joint thread screw/joint thread cylindrical/; s/^    damping 0.02/    spin_damping 0.02/' \
    -e 's/^    pitch 300 mm/    start at 33.333333333333336 mm rotate 40 deg/; /^    start 40 deg/d' \
    -e 's|^    speed 2 rad/s|    speed 95.49296585513721 mm/s; spin 2 rad/s|' \
    -e 's/\(position\|speed\) of thread$/\1 of thread_turn/' tests/isoc/mechanism/screw.scene >"$out/gear.scene"
echo "close pair gear { first thread_slide; second thread_turn; ratio 47.74648292756861 mm/rad }" >>"$out/gear.scene"

EXTRA=
plants=
compiled gear "$out/gear.scene" && compiled lead_rk4 tests/isoc/mechanism/lead_screw.scene --method rk4 &&
    compiled lead_rosenbrock tests/isoc/mechanism/lead_screw.scene --method rosenbrock &&
    compiled composite tests/isoc/mechanism/screw.scene --formulation composite &&
    compiled articulated tests/isoc/mechanism/screw.scene --formulation articulated
result $? "isoc compiles a screw by both formulations, and in a loop"
# shellcheck disable=SC2086
program screw tests/isoc/mechanism/screw.c tests/host/report.c $plants
result $? "they are one program"
joined "a screw" "$out/screw"

sed 's/pitch 300 mm/pitch 301 mm/' tests/isoc/mechanism/screw.scene >"$out/other.scene"
# shellcheck disable=SC2086
compiled composite "$out/other.scene" --formulation composite && program other tests/isoc/mechanism/screw.c tests/host/report.c $plants &&
    ! "$out/other" >"$out/tap" && grep -q '^not ok 2' "$out/tap" && grep -q '^not ok 3' "$out/tap"
result $? "found: another pitch"
finish
