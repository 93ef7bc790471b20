# shellcheck shell=sh
# The page of a report, report.html, with its parts besides the tables of methods: read by report.sh, after these. Each
# part makes its tables and pictures in $dir; a part that a scene cannot have is left out.

# The targets whose ticks are shown, by published timings, if the environment names no others.
: "${TICK_TARGETS:=cortex-m4f cortex-m7}"

# A make that is called does not get the variables of this report, such as METHODS.
unset MAKEFLAGS MFLAGS MAKEOVERRIDES

own_make()
{
    "${MAKE:-make}" --no-print-directory "$@" </dev/null
}

# shape: sets own_method, that of the scene, at whose step errors grow; nothing where its steps vary; and closed,
# whether it has loops.
shape()
{
    own_method=rk4 closed=no
    case $SCENE in
    *.c) return ;;
    esac
    build/isoc "$SCENE" --shape >"$dir/shape"
    while read -r shape_word shape_value _; do
        case $shape_word in
        method) own_method=${shape_value%adams} ;;
        closure) closed=yes ;;
        esac
    done <"$dir/shape"
}

# grow: growth.tsv, the error of the scene's method at its step after parts of the time.
grow()
{
    method=$own_method
    [ -n "$method" ] || return 0
    : >"$dir/grown.txt"
    awk -v n=$((4 * coarsest)) -v step="$step" 'BEGIN {
        for (part = 32; part >= 1; part /= 2) if (int(n / part) > 0) printf "%d %.17g ", int(n / part), int(n / part) * step
        print "" }' >"$dir/parts"
    read -r parts <"$dir/parts"
    for kind in float compensated double; do
        [ -x "$dir/$kind-$method/drive" ] || variable $kind "$method" || return 0
        # shellcheck disable=SC2086
        "$dir/$kind-$method/drive" pairs $parts >"$dir/grown"
        while IFS= read -r line; do
            printf '%s %s 0 - %s\n' $kind "$method" "$line"
        done <"$dir/grown" >>"$dir/grown.txt"
    done
    references "$dir/grown.txt"
    compute reference -f tools/measure/errors.awk "$dir/reference.txt" "$dir/grown.txt" | awk -F '\t' -v OFS='\t' '
        NR == 1 { print "kind", "method", "step_s", "time_s", "error"; next }
        { print $1, $2, $3, sprintf("%.9g", $3 * $4), $5 }' >"$dir/growth.tsv"
    picture growth growth "$NAME" "$dir/growth.tsv"
}

# local_errors: local_error.tsv and local_error.svg, the estimate of the error of a step by the scene's method, in
# double, and the error. With substeps the estimate is that of one of them: such a scene has none.
local_errors()
{
    method=$own_method
    [ -n "$method" ] && ! grep -q '^ *substeps ' "$SCENE" || return 0
    folders "$dir/checked" "$dir/checked-$method"
    { elsewhere "$SCENE" | sed '/^ *checked /d' | compute same "$dir/own/plant.txt" - && printf '\nchecked yes\n'; } >"$dir/checked/$NAME.scene"
    variable checked "$method" >"$dir/checked/said" 2>&1 || return 0
    "$dir/checked-$method/drive" told "$time" $((4 * coarsest)) >"$dir/local.txt" && {
        printf 'time_s\ttold\terror\tratio\tstep_s\tmethod\n'
        "$dir/reference-rk4/drive" true "$time" <"$dir/local.txt" | awk -F '\t' -v OFS='\t' -v step="$step" -v method="$method" '
            { print $0, ($3 > 0 ? sprintf("%.3g", $2 / $3) : "-"), step, method }'
    } >"$dir/local_error.tsv"
    picture local_error local_error "$NAME" "$dir/local_error.tsv"
}

# account: account.tsv and account.svg, of a run: energy, residual of its balance, and violation of closed loops.
account()
{
    outputs="report_energy report_balance"
    [ $closed = no ] || outputs="$outputs report_violation"
    folders "$dir/account"
    {
        elsewhere "$SCENE"
        echo
        for output in $outputs; do
            echo "output $output = ${output#report_}"
        done
    } >"$dir/account/$NAME.scene"
    own_make run SCENE="$dir/account/$NAME.scene" OUT="$dir/account" TARGET=host REAL=float METHOD= INPUTS= STEP="$STEP" \
        SECONDS="$(awk -v n="$NANOSECONDS" 'BEGIN { printf "%.9g", n / 1e9 }')" >"$dir/account/summary.txt" 2>"$dir/account/said" || return 0
    # shellcheck disable=SC2086
    picture account trace "$dir/account" $outputs
    sh tools/plot/picture.sh account "$dir/account" >"$dir/account.tsv"
}

# nearness: nearness.tsv, where closures are watched: the ticks of the account's run, and those near a singular
# position.
nearness()
{
    grep -qs iso_watch_pivots "$dir/account/plant.c" || return 0
    awk -v OFS='\t' '
        $1 == "ticks" { ticks = $2 }
        $1 == "near_singular" { near = $2; first = $4; closure = $7 }
        END {
            print "ticks", "near", "first_s", "closure"
            print ticks, near + 0, near ? first : "-", near ? closure : "-"
        }' "$dir/account/summary.txt" >"$dir/nearness.tsv"
    curves_of_nearness
}

# curves_of_nearness: singular.tsv and singular.svg, over the time: the pivots in the account's run, by nearness.c, and
# the largest violation in the same ticks.
curves_of_nearness()
{
    [ -s "$dir/account/trace.csv" ] || return 0
    $COMPILE -include tools/measure/pivots.h -c "$dir/account/plant.c" -o "$dir/account/watched.o" &&
        $COMPILE tools/measure/nearness.c "$dir/account/watched.o" build/obj/tools/file/file.o build/obj/tools/trace/decimal.o \
            -o "$dir/account/nearness" || exit 1
    "$dir/account/nearness" "$(awk '$1 == "ticks" { print $2 }' "$dir/account/summary.txt")" 400 >"$dir/singular.tsv" || exit 1
    picture singular singular "$NAME" "$dir/singular.tsv"
}

# cycle_costs: cycles.tsv, in the columns of report.tsv, and cycles.svg: the errors in float over the cycles of steps
# without a restart on the Cortex-M4F, by published timings, the most of them. Of adams, whose steps vary, there are
# none.
cycle_costs()
{
    : >"$dir/cycles.txt"
    held=
    [ "${inputs:-0}" -eq 0 ] || held=held
    set --
    for method in $fixed; do
        set -- "$@" "$dir/float-$method/m4f/cycles" "$dir/compensated-$method/m4f/cycles"
    done
    folders "$@"
    for kind in float compensated; do
        for method in $fixed; do
            of=$dir/$kind-$method/m4f
            make_alone cortex-m4f/float "$of" cycles SCENE="$dir/$kind/$NAME.scene" METHOD="$method" \
                STEP="$STEP" INPUTS="$held" >"$of/counted" 2>&1 </dev/null
            [ ! -s "$of/cycles/run.tsv" ] || while read -r word part _ _ most _; do
                [ "$word $part" != 'part step' ] || printf '%s\t%s\t%s\n' $kind "$method" "$most"
            done <"$of/cycles/run.tsv" >>"$dir/cycles.txt"
        done
    done
    [ -s "$dir/cycles.txt" ] || return 0
    awk -F '\t' -v OFS='\t' '
        FNR == NR { cycles[$1, $2] = $3; next }
        FNR == 1 { gsub(/instructions/, "cycles"); print; next }
        ($1, $2) in cycles { print "cycles_" $1, $2, $3, $4, $5, $6, cycles[$1, $2], sprintf("%.6g", cycles[$1, $2] / $3), $9 }' \
        "$dir/cycles.txt" "$dir/report.tsv" >"$dir/cycles.tsv"
    picture cycles work_precision "$NAME" "$time" "$dir/cycles.tsv"
}

# tick: tick.tsv, the parts of the dearest tick on each target.
tick_parts()
{
    printf 'target\tpart\tinstructions\tcycles_least\tcycles_most\tus\n' >"$dir/tick.new"
    for target in $TICK_TARGETS; do
        make_alone "$target/float" "$dir/cycles-$target" cycles SCENE="$SCENE" METHOD= INPUTS= STEP="$STEP" \
            >"$dir/cycles-$target.txt" 2>&1 </dev/null && sed -n "s/^part	/$target	/p" "$dir/cycles-$target/cycles.tsv" >>"$dir/tick.new"
    done
    [ "$(grep -c . "$dir/tick.new")" -lt 2 ] || mv "$dir/tick.new" "$dir/tick.tsv"
}

# prices: effects.tsv and effects.svg, of a scene that has effects.
prices()
{
    [ -n "$(build/isoc "$SCENE" --effects)" ] || return 0
    own_make cost SCENE="$SCENE" METHOD= INPUTS= STEP="$STEP" SECONDS=1 >"$dir/cost.txt" 2>&1 || return 0
    cp "build/cost/$FOLDER/effects.tsv" "build/cost/$FOLDER/effects.svg" "$dir"
}

# eigenvalues: regions.tsv and regions.svg, the regions of stability of all methods (regions.c) and the step times the
# eigenvalues of the scene: at its start, piece 1, and at the end of the time, piece 2.
eigenvalues()
{
    cp build/regions.tsv "$dir/regions.new"
    piece=0
    for at in '' "${time}s"; do
        piece=$((piece + 1))
        own_make linear SCENE="$SCENE" AT="$at" METHOD= INPUTS= STEP="$STEP" TRIM= BODE= \
            >"$dir/linear.txt" 2>&1 || continue
        awk -F '\t' -v step="$step" -v piece=$piece 'FNR > 1 { printf "eigenvalue\t%.6g\t%.6g\t%d\n", step * $1, step * $2, piece }' "build/linear/$FOLDER/modes.tsv" >>"$dir/regions.new"
    done
    ! grep -q '^eigenvalue' "$dir/regions.new" || {
        mv "$dir/regions.new" "$dir/regions.tsv"
        picture regions regions "$NAME" "$own_method" "$dir/regions.tsv"
    }
}

# motion: the page of make show, in this page.
motion()
{
    [ "${REPORT_PARTS#*motion}" != "$REPORT_PARTS" ] || return 0
    own_make show SCENE="$SCENE" METHOD= INPUTS= STEP="$STEP" OUT="$dir/motion" TARGET=host REAL=float \
        SECONDS="$(awk -v n="$NANOSECONDS" 'BEGIN { printf "%.9g", n / 1e9 }')" >"$dir/motion.txt" 2>&1 || return 0
    echo '<h2>The mechanism</h2>'
    printf '<iframe title="The mechanism in motion" srcdoc="'
    sed 's/&/\&amp;/g; s/"/\&quot;/g' "$dir/motion/show.html"
    echo '"></iframe>'
}

# section TITLE PART NAME PICTURE TEXT: a part of the page, if its table is there.
section()
{
    [ -s "$dir/$3.tsv" ] || return 0
    echo "<h2>$1</h2>"
    [ -z "$5" ] || echo "<p>$5</p>"
    section_picture=
    [ -z "$4" ] || [ ! -s "$dir/$4.svg" ] || section_picture=$dir/$4.svg
    compute page -v part="$2" -v file="$3.tsv" -v picture="$section_picture" -v title="$1" "$dir/$3.tsv"
}

# page: the whole page.
page()
{
    cat <<END
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>$NAME: report</title>
<style>
$(cat tools/show/page.css tools/measure/page.css)
</style>
</head>
<body>
<header><h1>$NAME</h1><p id="about">report of its methods; every number is of a table on this page</p></header>
<main class="report">
END
    motion
    section "Error over cost and step" errors report work_precision \
        "The error of the state at the end, as a 2-norm over all states in SI units, for every method, step and number type. ${resting:-Inputs keep their values at the start.}"
    section "Error over cycles" errors cycles cycles \
        "The same over the cycles of a step on <code>cortex-m4f</code>: the most by its published timings. For this machine there are none: above, all costs are instructions."
    [ ! -s "$dir/unlooped" ] || echo "<p>In a loop nothing is measured: two methods do not agree on what is right.</p>"
    section "In a loop" table loop loop "Inputs change at every tick, as a held staircase or as samples of a smooth signal."
    section "How the error grows" growth growth growth ""
    section "The error of a step" local_error local_error local_error \
        "What the method tells of it with <code>checked yes</code>, in double, and what it is against a reference that begins at the same state."
    section "Energy and balance" account account account \
        "Of a run in float. The balance is the power that the energy does not explain."
    section "Singular positions" nearness nearness "" ""
    section "Nearness and violation" singular singular singular \
        "A pivot of the closures falls to nearly nothing at a singular position: the least of all, over the largest that the same has in this run; how much one changes in a step, which says whether the step is short enough to see it; and how far the loops come apart."
    section "Stability" regions regions regions \
        "A method keeps stable what lies to the left of its curve, or within it: the growth of its own step is one there. The points are the step times the eigenvalues at the start and at the end; some may lie outside of the picture. Of <code>adams</code> the step is that of a sub-step; <code>bdf4</code> and <code>rosenbrock</code> know fast decays only as the Jacobian at the start of a step has them."
    section "The dearest tick" tick tick "" "Its parts by published timings of the core."
    section "What each effect costs and changes" table effects effects ""
    echo '</main></body></html>'
}

# The parts of the page that are made, if the environment names no others; a plant in C has only one.
case $SCENE in
*.c) REPORT_PARTS=grow ;;
*) : "${REPORT_PARTS=cycle_costs grow local_errors account nearness tick_parts eigenvalues prices motion}" ;;
esac
shape
(cd "$dir" && exec rm -f cycles.tsv growth.tsv local_error.tsv account.tsv nearness.tsv tick.tsv regions.tsv effects.tsv singular.tsv)
for making in $REPORT_PARTS; do
    [ "$making" = motion ] || { echo "$WHAT: the page: $making" >&2 && $making; }
done
draw_pictures
echo "$WHAT: the page" >&2
page >"$dir/report.html.new" && mv "$dir/report.html.new" "$dir/report.html"
