#!/bin/sh
# The cheapest method, step, number of steps in a tick and summation of a scene whose errors stay below bounds. Called
# by `make choose`, which gives in the environment
#
#     MAKE COMPILE                 make, and the compiler with all flags but those of a plant
#     SCENE NAME FOLDER            the scene, its name, and its folder
#     MACHINE TARGET CORE CLOCK BOARD    the chip: the result of cycles/machine.sh, and the variables of make
#     ERROR LOAD NANOSECONDS       the bounds, the most of a tick that may be used, and how long
#     STEP INPUTS RECORDED SET WITHOUT METHODS KEEP    as they were given
#
# Everything stands in build/choose/FOLDER/: tries/, every run that was made; table.txt, the table; advised.scene.
dir=build/choose/$FOLDER
export dir
. tools/measure/choose/parts.sh

# asked: parses ERROR, LOAD, RECORDED and KEEP; messages about errors have these names.
asked()
{
    [ -f "$SCENE" ] || fail "there is no scene $SCENE"
    [ -n "$ERROR" ] || fail "ERROR is missing: how large the error may be, of which output; it could be ERROR='1 mm of tip'"
    compute choose/bounds >"$dir/bounds"
    ! grep -q '^error' "$dir/bounds" || fail "ERROR: $(sed 's/^error //' "$dir/bounds")"
    load=$(echo "$LOAD" | awk '/^ *([0-9]+[.]?[0-9]*|[.][0-9]+) *%? *$/ && $1 + 0 > 0 && $1 + 0 <= 100 { print $1 + 0 }')
    [ -n "$load" ] || fail "LOAD=$LOAD is no load; it could be 50%, above 0 and up to 100%"
    [ -z "$RECORDED" ] || [ -f "$RECORDED" ] || fail "RECORDED=$RECORDED: there is no such file"
    [ "$RECORDED$INPUTS" != "${RECORDED}smooth" ] || [ -z "$RECORDED" ] ||
        fail "INPUTS=smooth has no effect with RECORDED: between the lines of a file there is no signal"
    [ -z "$KEEP" ] || [ "$KEEP" = yes ] || fail "KEEP=$KEEP is unknown; KEEP=yes writes the advice into $SCENE"
}

# scene: base.scene, from which all other scenes are made; the bounded outputs; the scene's step in ns.
scene()
{
    elsewhere "$SCENE" >"$dir/base.scene" || exit 1
    mkdir -p "$dir/bounded"
    {
        cat "$dir/base.scene"
        echo
        awk -F '|' '{ print "output choose_bound_" $1 " = " $2 }' "$dir/bounds"
    } >"$dir/bounded/$NAME.scene"
    for which in base.scene "bounded/$NAME.scene"; do
        build/isoc "$dir/$which" -o "$dir/bounded" ${STEP:+--step "$STEP"} ${SET:+--set "$SET"} ${WITHOUT:+--without "$WITHOUT"} \
            --method rk4 >"$dir/bounded/plant.txt" 2>"$dir/bounded/said" && continue
        [ "$which" = base.scene ] || fail "ERROR='$ERROR': $(sed -n 's/.*error: //p' "$dir/bounded/said" | head -n 1)"
        sed "s|^$dir/base.scene:|$SCENE:|" "$dir/bounded/said" >&2
        exit 1
    done
    compute choose/columns "$dir/bounded/plant.c" "$dir/bounds" >"$dir/columns"
    ! grep -q '^error' "$dir/columns" || fail "ERROR: $(sed -n 's/^error //p' "$dir/columns")"
    plant=$dir/bounded/plant.c
    read_plant "$plant"
    inputs=$(awk '$1 == "inputs" { print $2 }' "$dir/bounded/plant.txt")
    rows=$((NANOSECONDS / period))
    rows=$((rows / every * every))
    [ $((rows / every)) -ge 8 ] || fail "SECONDS is too short: $rows steps of $(step_of "$period") are less than 8 rows"
    reading=held
    if [ -z "$RECORDED" ] && { [ "$INPUTS" = smooth ] || { [ -z "$INPUTS" ] && grep -q ISO_SMOOTH "$plant"; }; }; then
        reading=smooth
    fi
    [ -z "$RECORDED" ] || [ "$inputs" -gt 0 ] || fail "RECORDED=$RECORDED has no effect: $SCENE has no inputs"
    bounds=$(scaled 1)
    export period rows every bounds
}

# scaled FACTOR: the bounds, so many times as large.
scaled()
{
    awk -F '|' -v factor="$1" '{ printf "%.9g=%s ", $2 * factor, $3 }' "$dir/columns"
}

# reference N OUT [OPTION...]: rows of rk4 in double with compensated sums, of N steps in a step of the scene; prints
# the output of run.c. Smooth inputs are sampled at each of them.
reference()
{
    reference_n=$1 reference_out=$2
    shift 2
    reference_of=$dir/reference-$reference_n
    if [ $reading = smooth ]; then
        reference_every=$reference_n reference_substeps=- reference_inputs=smooth
    else
        reference_every=1 reference_substeps=$reference_n reference_inputs=$INPUTS
    fi
    [ -x "$reference_of/run" ] || built "$reference_of" double "substeps $reference_substeps; compensated yes" rk4 \
        $((period / reference_every)) ${reference_inputs:+--inputs $reference_inputs} ||
        fail "the reference cannot be built for $SCENE: $(head -n 1 "$reference_of/said")"
    "$reference_of/run" -n $((rows * reference_every)) -e $reference_every ${RECORDED:+-u "$RECORDED"} ${reference_out:+-w "$reference_out"} "$@" ||
        fail "the reference does not run"
}

# kept FILE: from the output of run.c in it, $kept is the number of rows that keep all bounds: all that were asked for,
# or fewer.
kept()
{
    kept='' kept_rows=''
    while read -r kept_word kept_first _ _ kept_by; do
        case $kept_word in
        error) [ "${kept:-$kept_by}" -lt "$kept_by" ] || kept=$kept_by ;;
        rows) kept_rows=$kept_first ;;
        esac
    done <"$1"
    : "${kept:=0}"
    [ "${kept_rows:-$kept}" -ge "$kept" ] || kept=$kept_rows
}

# seconds ROWS
seconds()
{
    awk -v rows="$1" -v ns="$period" 'BEGIN { printf "%.4g\n", rows * ns * 1e-9 }'
}

# judge: the reference, in $dir/reference, and for how many rows one can judge. From the first row on in which a start
# as far off as rounding to float puts it makes an error as large as the bound, no method in float can keep it; an
# eighth is left to the steps.
judge()
{
    steps=$(awk -v period="$period" 'BEGIN {
        for (n = 2; n <= 1000 && period / n >= 1000; n++) if (period % n == 0 && n >= 2 * last) { printf "%d ", n; last = n } }')
    # shellcheck disable=SC2086
    set -- $steps
    [ $# -ge 2 ] || fail "the step of $(step_of "$period") is too short for a reference"
    [ $# -eq 2 ] || shift
    # shellcheck disable=SC2086
    reference "$1" "$dir/reference" $bounds >"$dir/reference.txt"
    ended=$(awk '$1 == "rows" { print $2 }' "$dir/reference.txt")
    if [ "$ended" -lt "$rows" ]; then
        rows=$(((ended - 1) / every * every))
        echo "The motion ends at the guard after $(seconds "$rows") s: judged up to there."
        [ $rows -ge $((8 * every)) ] || fail "the scene does not run for 8 steps; make run SCENE=$SCENE says why"
    fi
    sure=$rows can=$rows
    part=$(scaled 0.125)
    for seed in 1 2 3; do
        # shellcheck disable=SC2086
        reference "$1" "" -p $seed -r "$dir/reference" $part >"$dir/near"
        # shellcheck disable=SC2086
        reference "$1" "" -p $seed -r "$dir/reference" $bounds >"$dir/far"
        kept "$dir/near" && near=$kept
        kept "$dir/far" && far=$kept
        [ "$near" -ge "$sure" ] || sure=$near
        [ "$far" -ge "$can" ] || can=$far
    done
    eighth=$sure
    if [ "$can" -lt "$rows" ] && [ $((can / 2 / every)) -lt 8 ]; then
        # The time does not matter: the tries decide.
        sure=$rows
        # shellcheck disable=SC2086
        reference "$1" "" -p 1 -r "$dir/reference" $bounds >"$dir/far"
        echo "Rounding of the start to float may alone make $(awk '
            $1 == "error" && $3 / $2 > most { most = $3 / $2 } END { printf "%.2g", most }' "$dir/far") times the bound."
    elif [ "$can" -lt "$rows" ]; then
        [ "$sure" -ge $((can / 2)) ] || sure=$((can / 2))
        fold=$(awk -v near="$(seconds "$eighth")" -v far="$(seconds "$can")" 'BEGIN { printf "%.2g", (far - near) / log(8) }')
        echo "From $(seconds "$can") s on no method in float can keep the bound: the rounding of the start to float, 6e-8 of it, grows to the"
        echo "bound; in the end it grows by a factor of e in $fold s. Judged up to $(seconds "$sure") s."
    else
        sure=$rows
    fi
    rows=$((sure / every * every))
    agree "$@"
}

# agree N...: refines the reference until it differs from the one before by less than a fiftieth of the bounds.
agree()
{
    shift
    part=$(scaled 0.02)
    for n; do
        # shellcheck disable=SC2086
        reference "$n" "$dir/finer" -r "$dir/reference" $part >"$dir/finer.txt"
        mv "$dir/finer" "$dir/reference"
        kept "$dir/finer.txt" && agreed=$kept
        known=$(awk '$1 == "error" && $3 / $2 > most { most = $3 / $2 } END { printf "%.1g", most / 50 }' "$dir/finer.txt")
        # A reference with more steps would take minutes.
        [ "$agreed" -lt "$rows" ] && [ $((rows * n)) -lt 4000000 ] || break
    done
    # A tenth of the bound will do, or most of the time.
    if [ "$agreed" -lt "$rows" ] && awk -v known="$known" 'BEGIN { exit !(known > 0.1) }'; then
        [ "$agreed" -ge $((rows / 2)) ] && [ "$agreed" -ge $((8 * every)) ] ||
            fail "the exact motion is not known: $n steps in $(step_of "$period") or half as many differ by $known times the bound.
Take a larger ERROR or a shorter SECONDS"
        rows=$((agreed / every * every))
        echo "The exact motion is known to a fiftieth of the bound up to $(seconds $rows) s: judged up to there."
        known=0.02
    fi
    echo "Reference: rk4 in double, $n steps in $(step_of "$period"), inputs $reading; twice the steps change it by $known of the bound."
}

# candidates METHOD...: tries them, a few at once.
candidates()
{
    total=$#
    rm -rf "$dir/done"
    mkdir -p "$dir/done" "$dir/found" "$dir/tries"
    : >"$dir/best-none" # so that there is always a best-* to read
    export total load hz each limit longest METHODS
    export -p >"$dir/settings"
    printf '%s\n' "$@" | xargs -n 1 -P "$(nproc 2>/dev/null || echo 1)" sh tools/measure/choose/method.sh || exit 1
    for method; do
        shift
        set -- "$@" "$dir/found/$method-no" "$dir/found/$method-yes"
    done
    cat "$@" >"$dir/candidates"
}

# told WHAT FILE
told()
{
    compute choose/bound -f tools/measure/choose/told.awk -v what="$1" -v period="$period" -v hz="$hz" -v most_load="$load" \
        "$dir/columns" "$2"
}

# advise LINE: writes the advised scene, runs it by make, measures its error again, and prints it.
advise()
{
    # shellcheck disable=SC2086
    set -- $1
    method=$1 compensated=$2 k=$3 n=$4 ratio=$8
    state "$n" "$([ "$compensated" = yes ] && echo yes || echo -)" "$method"
    text="step $(step_of $((period * k))); method ${method%%-*}; ${statements#method adams; }"
    if compute choose/edit -v statements="$text" -v must=step "$dir/base.scene" >"$dir/advised.scene"; then
        set --
    else
        state "$n" "$compensated" "$method"
        compute choose/edit -v statements="$statements" "$dir/base.scene" >"$dir/advised.scene"
        set -- METHOD="${method%%-*}" STEP="$((period * k))ns"
    fi
    shown=
    if [ -n "$RECORDED" ]; then
        sh tools/measure/choose/try.sh "$method" "$compensated" "$k" "$n" | awk '{ print $1, 1e-4 }' >"$dir/again"
    else
        "${MAKE:-make}" --no-print-directory run SCENE="$dir/advised.scene" OUT="$dir/run" \
            SECONDS="$(awk -v ns=$((period * rows)) 'BEGIN { printf "%.9f", ns * 1e-9 }')" TARGET=host REAL=float SET="$SET" WITHOUT="$WITHOUT" INPUTS="$INPUTS" "$@" >"$dir/run.txt" 2>&1 </dev/null ||
            fail "the advised scene does not run; see $dir/run.txt"
        reference_rows "$dir" | awk -v step=$((k * every)) 'NR % step == 1 || step == 1' >"$dir/reference.rows"
        compute choose/bound -f tools/measure/choose/measured.awk -v judged=$((rows / k / every)) -v every="$every" \
            "$dir/columns" "$dir/reference.rows" "$dir/run/trace.csv" >"$dir/again"
    fi
    again=
    read -r again shown <"$dir/again"
    awk -v a="$again" -v b="$ratio" -v shown="$shown" 'BEGIN { exit !(a != "" && a <= 1 + shown && a - b <= shown && b - a <= shown) }' ||
        fail "the advised scene has $again of the bound when it runs, not $ratio; it is $dir/advised.scene"
    echo "It ran as $dir/advised.scene: its error is $(awk -v a="$again" 'BEGIN { printf "%.0f", 100 * a }') % of the bound."
}

# keep: writes the advice into the scene.
keep()
{
    [ "$KEEP" = yes ] || return 0
    compute choose/edit -v statements="$text" -v must=step "$SCENE" >"$dir/kept.scene" ||
        fail "KEEP=yes: $SCENE has no step of its own, but includes one; it stays as it is. The advice is: $text"
    cat "$dir/kept.scene" >"$SCENE"
    echo "kept in $SCENE: $text$([ -z "$INPUTS" ] || echo "; INPUTS=$INPUTS has to be given to each run")"
}

mkdir -p "$dir"
rm -rf "$dir"/best-* "$dir/found" "$dir/tries" "$dir"/reference-* "$dir/candidates"
asked
scene
# shellcheck disable=SC2086
set -- $MACHINE
core=$1 hz=$2 board=$3
case $core in
cortex-m4f | cortex-m7) soft=1 ;;
*) soft=20 ;; # a sum or a product without a unit takes at least so many cycles
esac
# Cycles of an evaluation: at least those of its operations.
each=$(awk -v soft=$soft '$1 == "derivative" { print soft * ($3 + $5 + 14 * $7 + 20 * $9) }' "$dir/bounded/plant.txt")
# A step that is given is the tick: then no longer one is tried.
longest=1000
[ -z "$STEP" ] || longest=1
limit=$(awk -v hz="$hz" -v most_load="$load" 'BEGIN { print hz * most_load / 100 }')
for real in float double; do
    [ $real = double ] && flag=-DISO_REAL_DOUBLE || flag=
    # shellcheck disable=SC2086
    $COMPILE $flag -c tools/measure/choose/run.c -o "$dir/run_$real.o" || exit 1
done
build/isoc --methods >"$dir/methods"

echo "$SCENE on the $board at $(awk -v hz="$hz" 'BEGIN { print hz / 1e6 }') MHz: $ERROR over $(seconds "$rows") s, load at most $load %"
judge
# Methods that are known to be dear come last: then they need not be tried in short steps. For adams only variants are
# tried that are cheaper than all others.
first='' middle='' dear='' last=''
for method in $METHODS; do
    case $method in
    rk4) first=" $method" ;;
    euler | semi_implicit) dear="$dear $method" ;;
    adams) last=" $method" ;;
    *) middle="$middle $method" ;;
    esac
done
METHODS=$first$middle$dear$last
# shellcheck disable=SC2086
candidates $METHODS
told table "$dir/candidates" | tee "$dir/table.txt"
best=$(told cheapest "$dir/candidates")
if [ -n "$best" ]; then
    advise "$best"
    told decides "$dir/candidates"
    keep
    echo "$best" >"$dir/best"
    printf 'take: '
    told take "$dir/best"
    exit 0
fi
if awk '$3 != "none" { priced = 1 } $4 == "unpriced" { unpriced = 1 } END { exit priced || !unpriced }' "$dir/candidates"; then
    echo "none: of no method that keeps $ERROR the cycles are known"
    exit 1
fi
. tools/measure/choose/none.sh
exit 1
