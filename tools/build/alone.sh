# shellcheck shell=sh
# Functions shared by scripts that call make for many plants; read from the root of the project, with make in $MAKE.

# make_alone TARGET/REAL FOLDER GOALS VARIABLE=VALUE...: make of these goals in a folder of the script. The first call
# on a target makes the objects that programs share; the others use them, and wait for no other make.
make_alone()
{
    alone_on=$1 alone_in=$2 alone_goals=$3
    shift 3
    # shellcheck disable=SC2086
    set -- --no-print-directory $alone_goals "$@" TARGET="${alone_on%/*}" REAL="${alone_on#*/}" OUT="$alone_in"
    case " ${ISOCHRON_MADE-} " in
    *" $alone_on "*) ISOCHRON_LOCKED="$alone_goals $alone_in" "${MAKE:-make}" "$@" ;;
    *) "${MAKE:-make}" "$@" && export ISOCHRON_MADE="${ISOCHRON_MADE-} $alone_on" ;;
    esac
}
