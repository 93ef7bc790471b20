# shellcheck shell=sh
# What scripts share that call make for many plants; read by them from the root of the project, with the make to call in $MAKE.

# make_alone TARGET/REAL FOLDER GOALS VARIABLE=VALUE...: make of these goals, which work in a folder that is the script's alone. The
# first call on a target makes what programs share; the others have it, and wait for no other make.
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
