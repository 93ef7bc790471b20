#!/bin/sh
# The hash of so many ticks, and the least and the most that a step takes, of scenes with methods on targets: a line for
# each as it is measured, then a table of a row for a scene with a method and a column for a target, and all of it as
# tab-separated values in build/determinism/REAL.tsv. Status 1 if a hash is another than that of the host, or a step
# takes no single number.
#
# Called by `make determinism`, with the make to call in $MAKE, the scenes in $MODELS, the methods in $METHODS, the
# targets in $ON, where `clang` is the host by clang, the ticks in $TICKS and the number type in $REAL. Measurements of
# the same files are not repeated: a sweep goes on where it was ended. $EXTRA are further words for make.
WHAT='make determinism'
. tools/measure/common.sh
folder=build/determinism
mkdir -p $folder
kept=$folder/kept

# measured SCENE METHOD TARGET TICKS: hash, least, most and unit of a step, in $cell; a word in place of the hash where
# there is none.
measured()
{
    case $3 in
    clang) measured_on='host PORT_CC=clang' ;;
    *) measured_on="$3 PORT_CYCLE_NS=1" ;; # a tick of a board is long, so that most steps end before its interrupt comes
    esac
    seconds=$(awk -v ticks="$4" '$1 == "step" && $3 == "s" { printf "%.9f", ticks * $2 }' $folder/summary)
    hash='' execution='' longer=''
    # shellcheck disable=SC2086
    if "$MAKE" -s --no-print-directory run SCENE="$1" METHOD="$2" REAL="$REAL" SECONDS="$seconds" TARGET=$measured_on ${EXTRA-} \
        >$folder/output 2>$folder/errors </dev/null; then
        while read -r word text; do
            case $word-$text in
            hash-*) hash=$text ;;
            execution-*) execution=$text ;;
            margin--*) longer=longer ;;
            esac
        done <$folder/output
    elif grep -q 'REAL=double\|double is not IEEE' $folder/errors; then
        hash=refused
    elif grep -q 'will not fit\|overflowed by\|overflow in conversion\|larger than maximum' $folder/errors; then
        hash=too_large
    else
        tail -n 3 $folder/errors >&2
        hash=failed
    fi
    # shellcheck disable=SC2086
    set -- $execution
    case $hash-${4-} in
    *_* | refused-* | failed-* | *- | *-ns) cell="$hash - - -" ;;
    *) cell="$hash $1 $3 $4 $longer" ;;
    esac
}

# look SCENE METHOD TARGET TICKS: the same, kept, in $cell.
look()
{
    key="$state $1 $2 $3 $4 $REAL"
    cell=$(awk -v key="$key" 'index($0, key " ") == 1 { cell = substr($0, length(key) + 2) } END { print cell }' $kept)
    [ -n "$cell" ] || {
        measured "$@"
        echo "$key $cell" >>$kept
    }
}

for scene in $MODELS; do
    [ -f "$scene" ] || fail "there is no scene $scene"
done
# shellcheck disable=SC2086
state=$({ cat core/*/*.[ch] port/*/* Makefile build/isoc $MODELS && echo "${EXTRA-}"; } 2>/dev/null | cksum)
: >>$kept

# Each target with all scenes and methods, so that what they share is compiled once.
printf 'scene\tmethod\ttarget\tticks\thash\tright\tleast\tmost\tunit\ttick\n' >$folder/$REAL.tsv
for target in $ON; do
    # The simulator of the AVR takes a thousand times as long as the others: it makes a thousandth of the ticks, one at
    # least.
    ticks=$TICKS
    [ "$target" != atmega1284p ] || ticks=$((TICKS < 1000 ? 1 : TICKS / 1000))
    for scene in $MODELS; do
        name=${scene##*/}
        name=${name%.scene}
        for method in $METHODS; do
            build/isoc "$scene" -o $folder/plant --method "$method" --real "$REAL" >$folder/summary 2>$folder/errors || {
                echo "$name $method: isoc refuses it" >&2
                continue
            }
            look "$scene" "$method" host "$ticks"
            right=${cell%% *}
            look "$scene" "$method" "$target" "$ticks"
            printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$name" "$method" "$target" "$ticks" "${cell%% *}" "$right" ${cell#* } >>$folder/$REAL.tsv
            printf '%-12s %-16s %-12s %s\n' "$target" "$name" "$method" "$cell" >&2
        done
    done
done
compute determinism $folder/$REAL.tsv
