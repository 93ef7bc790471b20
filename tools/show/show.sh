#!/bin/sh
# The page of a scene in motion. Called by `make show`, with the make to call in $MAKE and in the environment:
#
#     SCENE NAME FOLDER NANOSECONDS         the scene, and where all stands; FOLDER.html is the page
#     METHOD STEP TOLERANCE INPUTS SET WITHOUT REAL
#     AGAINST                               further runs, with | between: their changed variables, such as
#                                           'REAL=double | WITHOUT=rub', or the name of a run that make keeps
#     STILL                                 a time in seconds: FOLDER.svg is a picture of it, in place of the page
#     COMPILE LINK OBJECTS                  how a plant becomes a program, in the number type REAL
. tools/measure/common.sh
set -e

say()
{
    printf '  %-5s %s\n' "$1" "$2"
}

# made NUMBER: $dir/program, of the plant with the present variables, and the files that a picture of it needs. Without
# optimisation a run has the same bits, and the compiler is done ten times sooner.
made()
{
    dir=$FOLDER/$1
    folders "$dir"
    with_choices build/isoc "$SCENE" --shape ${SET:+--set "$SET"} >"$dir/shape"
    build/show scene "$(realpath --relative-to="$dir" "$SCENE")" "$dir/shape" >"$dir/$NAME.scene"
    with_choices build/isoc "$dir/$NAME.scene" -o "$dir" ${SET:+--set "$SET"} >"$dir/plant.txt"
    real_flag=
    [ "$REAL" = float ] || real_flag=-DISO_REAL_DOUBLE
    compile=$COMPILE objects=$OBJECTS
    case $COMPILE in
    *' -DISO_REAL_DOUBLE'*) compile=${COMPILE%%' -DISO_REAL_DOUBLE'*}${COMPILE#*' -DISO_REAL_DOUBLE'} ;;
    esac
    if [ "$REAL" != "$FIRST_REAL" ]; then
        objects=$(echo "$OBJECTS" | sed "s,/host/[a-z]*/,/host/$REAL/,g")
        flock build/lock "${MAKE:-make}" --no-print-directory shared SHARED="$objects" REAL="$REAL"
    fi
    # shellcheck disable=SC2086
    { $compile $real_flag -O0 -c "$dir/plant.c" -o "$dir/plant.o" &&
        $LINK "$dir/plant.o" $objects -o "$dir/program"; }
}

# changed WORD...: sets the changed variables; a word that is no assignment continues the value before it.
changed()
{
    name=
    value=
    for word; do
        case $word in
        METHOD=* | STEP=* | TOLERANCE=* | INPUTS=* | SET=* | WITHOUT=* | REAL=*)
            name=${word%%=*}
            value=${word#*=}
            ;;
        *)
            [ -n "$name" ] || fail "AGAINST: '$word' is no variable of a run, and no run is kept as that; it could be \
AGAINST='REAL=double | WITHOUT=rub', or AGAINST=$word after make run KEEP=$word"
            value="$value $word"
            ;;
        esac
        export "$name=$value"
    done
}

FIRST_REAL=$REAL
say ISOC "$SCENE"
made 1
if [ -n "$STILL" ]; then
    say SHOW "$FOLDER.svg"
    build/show still "$STILL" "$FOLDER/1/shape" "$FOLDER/1/program $NANOSECONDS" >"$FOLDER/still.new"
    exec mv "$FOLDER/still.new" "$FOLDER.svg"
fi
set -- "$NAME" "$FOLDER/1/shape" "$FOLDER/1/program $NANOSECONDS"
number=1
rest=$AGAINST
while [ -n "$rest" ]; do
    one=${rest%%|*}
    case $rest in
    *'|'*) rest=${rest#*|} ;;
    *) rest= ;;
    esac
    one=$(echo "$one" | sed 's/^ *//; s/ *$//')
    if [ -n "$one" ] && [ -e "build/runs/$one/trace.csv" ]; then
        set -- "$@" "$one" - "build/runs/$one"
        continue
    fi
    number=$((number + 1))
    say ISOC "$SCENE $one"
    # shellcheck disable=SC2086
    (set -f && changed $one && made $number)
    set -- "$@" "$one" "$FOLDER/$number/shape" "$FOLDER/$number/program $NANOSECONDS"
done
say SHOW "$FOLDER.html"
build/show page tools/show "$@" >"$FOLDER/show.new"
exec mv "$FOLDER/show.new" "$FOLDER.html"
