# shellcheck shell=sh
# Functions of make report and make bench; read by the scripts beside it. From the Makefile they have in the environment
#
#     MAKE COMPILE          make, and the compiler with all flags but those of a plant
#     SCENE NAME FOLDER     the scene or plant, its name, and its folder
#     STEP METHODS          the step if it is not the scene's, and the methods
#     NANOSECONDS           how long, in the plant's time
#
# and from the first script WHAT, the name of the command, and `dir`, the folder of all files that are made.
#
# Every method is built in four kinds: float; compensated, in float with compensated sums; double; and reference, in
# double with compensated sums. There the inputs are held. For a loop of a scene with inputs they are smooth in
# smooth_float, smooth and smooth_reference. A program of a kind and method stands in $dir/KIND-METHOD/.
. tools/measure/common.sh
TOLERANCE= # of adams; empty for the methods of a fixed step

case $SCENE in
*.c) language=c ;;
*) language=scene ;;
esac

# prepare: the scene once for each kind, in $dir/KIND/NAME.scene; a plant in C takes its method from
# core/runtime/choice.h. Values of effects that follow from the method and its step are in all those of the scene's own:
# else each method would have other equations, and none of them a reference.
prepare()
{
    [ -f "$SCENE" ] || fail "there is no scene $SCENE"
    rm -rf "$dir/told" || exit 1
    set -- "$dir/told" "$dir/own"
    for method in $REFERENCE_METHODS; do
        set -- "$@" "$dir/reference-$method"
    done
    for kind in $KINDS; do
        set -- "$@" "$dir/$kind"
    done
    folders "$@" || exit 1
    : >"$dir/own/plant.txt"
    case $language in
    c) write_plants ;;
    scene) write_scenes ;;
    esac || exit 1
}

# The kinds that a program may be of.
KINDS="float compensated double reference smooth_float smooth smooth_reference"

write_plants()
{
    set --
    for kind in $KINDS; do
        set -- "$@" "$dir/$kind/$NAME.c"
    done
    tee "$@" <"$SCENE" >/dev/null
}

write_scenes()
{
    build/isoc "$SCENE" -o "$dir/own" ${STEP:+--step "$STEP"} >"$dir/own/plant.txt" 2>/dev/null
    plain=$(elsewhere "$SCENE" | sed '/^ *compensated /d' | compute same "$dir/own/plant.txt" -) || return
    for kind in $KINDS; do
        case $kind in
        compensated | *reference) compensated=yes ;;
        *) compensated=no ;;
        esac
        printf '%s\n\ncompensated %s\n' "$plain" $compensated >"$dir/$kind/$NAME.scene" || return
    done
}

# Functions that are called for each kind and method start no process for work that the shell can do itself.

# reading_of KIND: $inputs_read is the reading of the inputs of a scene.
reading_of()
{
    [ "${1#smooth}" != "$1" ] && inputs_read=smooth || inputs_read=held
}

# learn_macros METHOD...: their constants, in $MACROS, also for processes of `each`.
learn_macros()
{
    MACROS="${MACROS-} $(awk 'BEGIN { for (i = 1; i < ARGC; i++) printf "%s ISO_%s ", ARGV[i], toupper(ARGV[i]) }' "$@")"
    export MACROS
}

# macro_of METHOD: $macro is its constant.
macro_of()
{
    case ${MACROS-} in
    *" $1 "*) ;;
    *) learn_macros "$1" ;;
    esac
    macro=${MACROS#*" $1 "}
    macro=${macro%% *}
}

# tell FILE SOURCE: prints on stderr the messages of isoc about the source, each warning once, with the place in SCENE:
# of many processes at once by the first that makes its folder.
tell()
{
    [ -s "$1" ] || return 0
    sed "s|^$2:|$SCENE:|" "$1" | awk '/^[^ ]*:[0-9]+:[0-9]+: / && NR > 1 { print "" } { printf "%s\001", $0 } END { print "" }' | while IFS= read -r text; do
        said=$(printf '%s' "$text" | cksum | tr ' ' -)
        [ -z "$text" ] || ! mkdir "$dir/told/$said" 2>/dev/null || printf '%s' "$text" | tr '\001' '\n' >&2
    done
}

# build KIND METHOD FOLDER [FLAG...]: the program FOLDER/drive, its plant compiled with these flags as well.
build()
{
    build_kind=$1
    build_method=$2
    folder=$3
    shift 3
    source=$dir/$build_kind/$NAME.$language
    reading_of "$build_kind"
    folders "$folder" || return
    case $build_kind in
    *float | compensated) real=float && real_flag= ;;
    *) real=double && real_flag=-DISO_REAL_DOUBLE ;;
    esac
    case $language in
    c)
        macro_of "$build_method"
        set -- "$@" "-DISO_METHOD=$macro" "-DISO_METHOD_NAME=$build_method" ${STEP:+-DISO_STEP="$STEP"}
        case $build_kind in
        compensated | reference) set -- "$@" -DISO_COMPENSATE ;;
        esac
        ;;
    *)
        build/isoc "$source" -o "$folder" --method "$build_method" --inputs $inputs_read --real $real ${STEP:+--step "$STEP"} \
            ${TOLERANCE:+--tolerance "$TOLERANCE"} >"$folder/plant.txt" 2>"$folder/told"
        built=$?
        tell "$folder/told" "$source"
        [ $built -eq 0 ] || return 1
        source=$folder/plant.c
        ;;
    esac
    # shellcheck disable=SC2086
    $COMPILE $real_flag "$@" "$source" "$dir/drive_$real.o" build/obj/tools/file/file.o -o "$folder/drive" -lm
}

# variable KIND METHOD: the program $dir/KIND-METHOD/drive, which takes any step, or any tolerance. Step.h includes the
# methods before the plant can say that it has one alone.
variable()
{
    macro_of "$2"
    build "$1" "$2" "$dir/$1-$2" -include "core/methods/$2.h" "-DISO_METHOD_LIST(X,r)=X(r,$macro,$2)" -include tools/measure/step.h
}

# take METHOD: before it is built or measured. Adams chooses its steps itself, by TOLERANCE, within STEP, its tick.
take()
{
    [ "$1" != adams ] || STEP=$tick TOLERANCE=1e-6
}

# The methods that the reference is computed by.
REFERENCE_METHODS="rk4 abm4_pecece"

# start: prepares the plant, and computes the reference at the end of the time; sets step in s, inputs, their number in
# a loop, and by plan.awk coarsest, the number of steps four times as long that make the time nearest to NANOSECONDS,
# time, the tick of adams, so long that the method chooses its steps, and fifty, the time of so many steps; and fixed,
# the methods of a fixed step.
start()
{
    prepare
    # shellcheck disable=SC2086
    { $COMPILE -c tools/measure/drive.c -o "$dir/drive_float.o" &&
        $COMPILE -DISO_REAL_DOUBLE -c tools/measure/drive.c -o "$dir/drive_double.o"; } || exit 1
    # shellcheck disable=SC2086
    learn_macros $METHODS $REFERENCE_METHODS
    for method in $REFERENCE_METHODS; do
        variable reference $method || fail "the reference cannot be built for $SCENE"
    done
    "$dir/reference-rk4/drive" about >"$dir/about" || exit 1
    read -r step _ inputs <"$dir/about"
    [ $language = scene ] || inputs=0
    compute plan -v nanoseconds="$NANOSECONDS" -v step="$step" >"$dir/plan"
    read -r coarsest time tick fifty <"$dir/plan"
    fixed=
    for method in $METHODS; do
        [ "$method" = adams ] || fixed="$fixed $method"
    done
    : >"$dir/reference.txt"
    rest
    reference "$time"
    # A program for the board, so that those that are made at once find the objects that they share.
    instructions_m4f float rk4 || exit 1
}

# rest: sets and exports STEADY, of signals_start: `yes` where the scene rests with the inputs that it has at its start,
# and with others has a motion that the reference can follow; and `resting`, the reason, for a reader of the result,
# without a number.
rest()
{
    export STEADY=
    resting=
    : >"$dir/unsteady"
    [ "$("$dir/reference-rk4/drive" rests "$time" $((4 * coarsest)))" = yes ] || return 0
    resting="The scene rests, and no method errs."
    [ "$inputs" -gt 0 ] || return 0
    STEADY=yes
    if [ "$("$dir/reference-rk4/drive" rests "$time" $((4 * coarsest)))" = yes ]; then
        STEADY=
        resting="The scene rests with the inputs that it has at its start, and with the largest of their functions: no method errs."
    elif (reference "$time") 2>"$dir/unsteady"; then
        resting="With the inputs that it has at its start the scene rests: each keeps the largest value of its function of time, or one SI unit."
    else
        STEADY=
        resting="The scene rests with the inputs that it has at its start, and no method errs; with the largest of their functions two methods do not agree on what is right."
    fi
    : >"$dir/reference.txt"
    echo "$WHAT: $resting" >&2
    [ ! -s "$dir/unsteady" ] || cat "$dir/unsteady" >&2
}

# reference 'TIME...' [KIND MODE]: adds to $dir/reference.txt for each of the times a line: the time, how much the two
# methods differ there, and the state; of a loop, at one time, to $dir/MODE.txt, by programs of the KIND in a mode of
# drive.c. The step begins with 1/64 of the coarsest and is halved until they agree to 1e-12, at most five times; then
# 1e-9 will do.
#
# A reference that was computed is kept in build/report/references, by a checksum of the programs that compute it and
# their arguments.
reference()
{
    if [ "${summed_kind-}" != "${2:-reference}" ]; then
        summed_kind=${2:-reference}
        cat "$dir/$summed_kind-rk4/drive" "$dir/$summed_kind-abm4_pecece/drive" ${RECORDED:+"$RECORDED"} | cksum >"$dir/sum"
        read -r summed summed_bytes <"$dir/sum"
    fi
    kept_reference=build/report/references/$summed-$summed_bytes${3+-$3}-$coarsest${STEADY:+-steady}
    if [ ! -e "$kept_reference" ]; then
        folders "${kept_reference%/*}" || exit 1
        : >"$kept_reference"
    fi
    kept_lines "$1"
    if [ -s "$dir/unknown" ]; then
        compute_reference "$@"
        cat "$kept_reference" "$dir/agreed" >"$kept_reference.$$" && mv "$kept_reference.$$" "$kept_reference" || exit 1
        kept_lines "$1"
    fi
    cat "$dir/known" >>"$dir/${3:-reference}.txt"
}

# kept_lines 'TIME...': $dir/known has the lines that are kept, $dir/unknown the times that have none.
kept_lines()
{
    : >"$dir/known"
    awk -v times="$1" -v known="$dir/known" '
        { line[$1] = $0 }
        END {
            count = split(times, time, " ")
            for (i = 1; i <= count; i++) if (time[i] in line) print line[time[i]] >known; else print time[i]
        }' "$kept_reference" >"$dir/unknown"
}

# references FILE: adds those of the times in its sixth column.
references()
{
    cut -d ' ' -f 6 "$1" | sort -u >"$dir/times"
    read_times "$dir/times"
    reference "$times"
}

# compute_reference 'TIME...' [KIND MODE]: the lines of $dir/unknown, in $dir/agreed.
compute_reference()
{
    : >"$dir/agreed"
    steps=$((64 * coarsest))
    for _ in 0 1 2 3 4 5; do
        read_times "$dir/unknown"
        pairs=
        for at in $times; do
            pairs="$pairs $steps $at"
        done
        for method in $REFERENCE_METHODS; do
            # shellcheck disable=SC2086
            case ${3-} in
            '') "$dir/reference-$method/drive" pairs $pairs ;;
            *) "$dir/$2-$method/drive" "$3" $times $steps ;;
            esac || exit 1
        done >"$dir/references"
        agreement 1e-12 && return
        steps=$((2 * steps))
    done
    # Where an effort has a kink, no method of order four comes so far.
    read_times "$dir/unknown"
    ! agreement 1e-9 || return 0
    read -r at apart <"$dir/unknown"
    fail "there is no reference for $NAME after $at s: at steps of $(awk -v time="$at" -v n=$((steps / 2)) \
        'BEGIN { printf "%.3g", time / n }') s rk4 and abm4_pecece still differ by $apart.
A motion that is chaotic, or stiff, is known for a short time only: try SECONDS=$(awk -v time="$at" \
        'BEGIN { print time / 4 }')"
}

# read_times FILE: $times are the first words of its lines.
read_times()
{
    times=
    while read -r at apart; do
        times="$times $at"
    done <"$1"
}

# agreement TOLERANCE: whether the methods agree at all of $times; those where they do not stay in $dir/unknown.
agreement()
{
    : >"$dir/unknown"
    compute agree -v times="$times" -v tolerance="$1" -v unlike="$dir/unknown" "$dir/references" >>"$dir/agreed"
}

# loop_references: $dir/restarted.txt and $dir/smooth.txt, of the two readings of inputs that change at every tick.
# Where inputs are recorded there is no continuous signal.
loop_references()
{
    : >"$dir/restarted.txt"
    : >"$dir/smooth.txt"
    reference "$time" reference restarted
    [ -z "$RECORDED" ] || return 0
    for method in $REFERENCE_METHODS; do
        variable smooth_reference $method || fail "the reference of smooth inputs cannot be built"
    done
    reference "$time" smooth_reference smooth
}

# instructions_m4f KIND METHOD: $cost is that of a step on the Cortex-M4F. Where steps differ, as the first ones of bdf4
# do, that which is nearer to the mean of fifty; of adams the mean of all sub-steps, with those that were repeated.
instructions_m4f()
{
    m4f=$dir/$1-$2/m4f$TOLERANCE
    source=$dir/$1/$NAME.$language
    inputs_read=
    [ "${inputs:-0}" -eq 0 ] || reading_of "$1"
    seconds=${TOLERANCE:+$time}
    on_board "$m4f" "$source" "$2" "${seconds:-$fifty}" run INPUTS="$inputs_read" TOLERANCE="$TOLERANCE"
    ran=$?
    tell "$m4f/said" "$source"
    [ $ran -eq 0 ] || complain "$2 does not run on the Cortex-M4F; see $m4f/measured" || return
    awk '
        $1 == "ticks" { ticks = $2 }
        $1 == "execution" { least = $2; mean = $3; most = $4; n++ }
        $1 == "substeps" { substeps = $2 }
        END {
            printf "%.0f\n", (substeps ? mean * ticks / substeps : mean - least < most - mean ? least : most)
            exit n != 1
        }' "$m4f/measured" >"$m4f/cost" || complain "$m4f/measured has not one execution" || return
    read -r cost <"$m4f/cost"
}

# instructions_host KIND METHOD: $cost is that of a step on this machine, in a kind of double; of adams the mean of all
# in the time.
instructions_host()
{
    method=$2
    count=$dir/count-$1-$method$TOLERANCE
    build "$1" "$method" "$count" || return
    if [ -n "$TOLERANCE" ]; then
        set -- "$time" "$TOLERANCE"
    else
        set -- count 100
    fi
    collected "$count/counted" steps "$count/drive" "$@" &&
        awk -v all="$collected" '/^[0-9]/ { steps = $1 } END { if (!steps) exit 1; printf "%.0f\n", all / steps }' \
            "$count/counted" >"$count/cost" || complain "callgrind does not count $method; see $count/counted" || return
    read -r cost <"$count/cost"
}

# each COMMAND KINDS METHOD...: runs `sh tools/measure/method.sh COMMAND KIND METHOD` for all of them, a few at once.
# Their kinds and methods are the lines of $dir/each.
each()
{
    each_command=$1 each_kinds=$2
    shift 2
    total=0
    each_folders=
    for kind in $each_kinds; do
        for method; do
            echo "$kind $method"
            each_folders="$each_folders $dir/$kind-$method/m4f $dir/count-$kind-$method"
            total=$((total + 1))
        done
    done >"$dir/each"
    # shellcheck disable=SC2086
    rm -rf "$dir/done" && folders "$dir/done" $each_folders || exit 1
    WHAT=$WHAT dir=$dir step=$step inputs=$inputs coarsest=$coarsest time=$time tick=$tick fifty=$fifty total=$total \
        xargs -n 2 -P "$(nproc 2>/dev/null || echo 1)" sh tools/measure/method.sh "$each_command" <"$dir/each" || exit 1
}
