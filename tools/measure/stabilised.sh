# shellcheck shell=sh
# Functions of make drift and its tests. They set SCENE, COMPILE, STEP (or nothing, for the scene's), and `dir`, the
# folder of all that is made.
WHAT="make drift"
. tools/measure/common.sh
STABILISATIONS="none baumgarte projection lagrangian"

# stabilised WORDS: the scene with this stabilisation in place of its own, and with the outputs that drift.c needs.
stabilised()
{
    elsewhere "$SCENE" | awk '/^ *stabilisation / { on = 1 }
        !on
        on && (/}/ || !/{/) { on = 0 }'
    printf '\nstabilisation %s\noutput drift_violation = violation\n' "$1"
    echo "output drift_rate = violation_rate"
    echo "output drift_energy = energy"
}

# measure NAME SECONDS PARTS [WORDS]: $dir/NAME.measured, the output of drift.c in float for $dir/NAME.scene, the scene
# with the stabilisation WORDS; the truncation is its violation in double. Fails if the scene is refused.
measure()
{
    stabilised "${4-$1}" >"$dir/$1.scene"
    [ ! -e "$dir/$1.measured" ] || rm -f "$dir/$1.measured"
    truncation=0
    for real in double float; do
        [ $real = double ] && real_flag=-DISO_REAL_DOUBLE || real_flag=
        build/isoc "$dir/$1.scene" -o "$dir/$1-$real" --real $real ${STEP:+--step "$STEP"} >"$dir/$1.said" 2>&1 || return 1
        # shellcheck disable=SC2086
        $COMPILE $real_flag tools/measure/drift.c "$dir/$1-$real/plant.c" -o "$dir/$1-$real/drift" -lm ||
            fail "$dir/$1-$real/drift cannot be built"
        "$dir/$1-$real/drift" "$2" "$3" "${1%%-*}" "$truncation" >"$dir/$1-$real/measured" || exit 1
        while read -r measured_word measured_value _; do
            [ "$measured_word" != violation ] || truncation=$measured_value
        done <"$dir/$1-$real/measured"
    done
    mv "$dir/$1-float/measured" "$dir/$1.measured"
}
