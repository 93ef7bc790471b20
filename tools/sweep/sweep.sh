#!/bin/sh
# The runs of a sweep. Called by `isochron sweep`, with these in the environment:
#
#     SCENE NAME FOLDER NANOSECONDS SECONDS   the scene, where all stands, how long a run is
#     SET OF RUNS SEED                        the variables, the results in the table; number and seed of random values
#     METHOD STEP TOLERANCE INPUTS WITHOUT REAL
#     ENGINE HOSTS                            local, parallel or slurm; of parallel the machines
#     LANES                                   how many runs are made side by side; empty: as many as pay
#     COMPILE LINK OBJECTS                    how plants become a program
#
# FOLDER/SUM/ has the plan, the plants, the program and the parts; SUM is a checksum of all inputs of the parts, so that
# only those of this sweep are used again. For each of several plants: sweep.sh one_plant|compiled FOLDER NUMBER.
WHAT="isochron sweep"
. tools/measure/common.sh
tab=$(printf '\t')

# refused FILE: the first error in it.
refused()
{
    sed -n '/^[^ ]*: error: /{ p; q; }' "$1"
}

# one_plant FOLDER NUMBER: by isoc, with the options of its line in FOLDER/variations; with lanes, where it can have
# them: else what isoc says of that is in `alone`. A refusal of the plant is in `refused`.
one_plant()
{
    one_folder=$1/plants/$2
    line=$(sed -n "$(($2 + 1))p" "$1/variations")
    folders "$one_folder"
    # The first cell of the line is its number.
    set -f
    IFS=$tab
    # shellcheck disable=SC2086
    set -- $line
    shift
    unset IFS
    set +f
    if [ "$LANES" != 1 ]; then
        with_choices build/isoc "$SCENE" -o "$one_folder" --lanes "$@" >"$one_folder/summary" 2>"$one_folder/told" && return
        refused "$one_folder/told" >"$one_folder/alone"
    fi
    with_choices build/isoc "$SCENE" -o "$one_folder" "$@" >"$one_folder/summary" 2>"$one_folder/told" && return
    [ -n "$(refused "$one_folder/told")" ] || fail "$(cat "$one_folder/told")"
    refused "$one_folder/told" >"$one_folder/refused"
}

# compiled FOLDER NUMBER: its object; the names that plants have in common become its own.
compiled()
{
    # shellcheck disable=SC2086
    $COMPILE $side "-Diso_the_plant_${side:+lanes_}$REAL=sweep_plant_$2" \
        "-Diso_the_derivative_${side:+lanes_}$REAL=sweep_own_derivative_$2" \
        "-Dplant_model=sweep_model_$2" "-Dplant_derivative=sweep_derivative_$2" -c "$1/plants/$2/plant.c" \
        -o "$1/plants/$2/plant.o.$$" && mv "$1/plants/$2/plant.o.$$" "$1/plants/$2/plant.o"
}

case ${1-} in
one_plant | compiled) "$@" && exit ;;
esac
[ $# -eq 0 ] || exit 1

# each FUNCTION NUMBER...: of each plant, as many at once as there are processors.
each()
{
    each_function=$1
    shift
    if [ $# -eq 1 ]; then
        "$each_function" "$made" "$1"
        return
    fi
    [ $# -eq 0 ] || printf '%s\n' "$@" | xargs -P "$processors" -n 1 sh tools/sweep/sweep.sh "$each_function" "$made"
}

# varies_once NAME WORD VALUE: fails if the variable is given and SET varies the same quantity.
varies_once()
{
    if [ -n "$3" ] && grep -q "^$2$tab.*$tab$2$tab" "$made/plan"; then
        fail "$1=$3, and SET varies the $2: leave out one of them"
    fi
}

# planned: the plan in $made, and its plants; nothing else is touched if something is wrong.
planned()
{
    [ ! -e "$made" ] || rm -rf "$made"
    with_choices build/isoc "$SCENE" -o "$made" --sweep "$SET" --of "$OF" ${RUNS:+--runs "$RUNS"} ${SEED:+--seed "$SEED"} || exit 1
    varies_once METHOD method "$METHOD"
    varies_once STEP step "$STEP"
    numbers=$(cut -f 1 "$made/variations")
    # shellcheck disable=SC2086
    set -- $numbers
    each one_plant "$@" || fail "isoc ended"
    count=$# without=0
    for number; do
        [ ! -f "$made/plants/$number/refused" ] || without=$((without + 1))
    done
    if [ "$without" -eq "$count" ]; then
        cat "$made/plants/0/told" >&2
        exit 1
    fi
    [ ! -s "$made/plants/0/told" ] || grep . "$made/plants/0/told" >&2
    [ "$without" -eq 0 ] || echo "  SWEEP isoc refuses $without of $count plants; their runs fail" >&2
}

# grouped: $made/groups has a line for each plant: its number, and that of the first which differs in the start alone,
# by plants/NUMBER/rest; the numbers of the start are in plants/NUMBER/start.
grouped()
{
    if [ "$count" -eq 1 ]; then
        echo "$numbers $numbers" >"$made/groups"
        return
    fi
    (cd "$made/plants" && find . -name plant.c -exec awk '
        FNR == 1 { close(rest); close(start); rest = start = FILENAME; sub(/plant[.]c$/, "rest", rest); sub(/plant[.]c$/, "start", start) }
        /^static const (real|iso_scalar) start\[/ { is_start = 1; next }
        is_start && /^};/ { is_start = 0; next }
        is_start { sub(/.* = /, ""); print >start; next }
        { print >rest }' {} + &&
        find . -name rest -exec sha256sum {} + | sort -t / -k 2n | awk '
            { split($2, path, "/"); if (!($1 in first)) first[$1] = path[2]; print path[2], first[$1] }') >"$made/groups"
}

# plants_in_c: all plants, and why isoc refused the others. A plant that differs in its start only has it as data.
plants_in_c()
{
    printf '#include "tools/sweep/steps.h"\n\nconst uint64_t sweep_duration_ns = UINT64_C(%s);\n' "$NANOSECONDS"
    while read -r number first; do
        eval "first_$number=$first"
        if [ "$number" -eq "$first" ]; then
            echo "extern const struct iso_plant sweep_plant_$number;"
        else
            printf 'static const iso_scalar sweep_start_%s[] = {%s};\n' "$number" "$(cat "$1/plants/$number/start")"
        fi
    done <"$1/groups"
    echo 'const sweep_plant sweep_plants[] = {'
    for number in $numbers; do
        if [ -f "$1/plants/$number/refused" ]; then
            printf '    {NULL, "%s", NULL},\n' "$(sed -e 's/[\\"]/\\&/g' -e "s/$tab/ /g" "$1/plants/$number/refused")"
            continue
        fi
        eval "first=\$first_$number"
        start=NULL
        [ "$number" -eq "$first" ] || start=sweep_start_$number
        echo "    {&sweep_plant_$first, NULL, $start},"
    done
    echo '};'
}

# laid: $side are the flags of the compiler for plants side by side; empty: one by one. Unless LANES asks for a number
# of lanes, there are 16 where a plant has four runs on average: a step of so many takes as long as two of one plant.
laid()
{
    side=
    export side
    set -- "$made"/plants/*/alone
    for one; do
        [ -f "$one" ] && [ ! -f "${one%alone}refused" ] || continue
        echo "  SWEEP makes its runs one by one: $(sed 's/^.*error: //' "$one")" >&2
        return
    done
    if [ -z "$LANES" ]; then
        kinds=$(awk '$1 == $2' "$made/groups" | wc -l)
        runs=$(sed -n 's/^runs //p' "$made/plan")
        [ "$runs" -ge $((4 * kinds)) ] || return
    fi
    [ "$LANES" != 1 ] || return
    side="-march=native -Wno-psabi -DISO_LANES=${LANES:-16}"
    # shellcheck disable=SC2086
    $COMPILE $side -fsyntax-only core/numbers/self_check.c 2>"$made/told" && return
    [ -z "$LANES" ] || fail "$COMPILE has no vectors"
    side=
}

# sum: $sum is the checksum of all inputs of the parts, its first 16 digits.
sum()
{
    {
        echo "$COMPILE $side $LINK"
        find "$made/plants" -name 'plant.[ch]' -print0 | LC_ALL=C sort -z |
            xargs -0 cat "$made/plan" "$made/plants.c" core/*/*.[ch] tools/sweep/*.[ch] tools/trace/decimal.[ch]
    } | sha256sum >"$made/sum"
    read -r sum _ <"$made/sum"
    sum=${sum%"${sum#????????????????}"}
}

# kept: $dir is the folder of this plan, with its parts that exist; folders of other plans are removed.
kept()
{
    grouped
    laid
    plants_in_c "$made" >"$made/plants.c"
    sum
    dir=$FOLDER/$sum
    for other in "$FOLDER"/*/; do
        other=${other%/}
        [ "$other" != "$made" ] && [ "$other" != "$dir" ] && [ -f "$other/plan" ] || continue
        if [ -f "$other/slurm_job" ]; then
            scancel "$(cat "$other/slurm_job")" 2>/dev/null
        fi
        rm -rf "$other"
    done
    if [ -f "$dir/program" ]; then
        rm -rf "$made"
        return
    fi
    rm -rf "$dir" "$FOLDER"/sweep.tsv "$FOLDER"/columns.tsv "$FOLDER"/failures.txt "$FOLDER"/*.svg "$FOLDER"/*.png
    with_plant=$(awk '$1 == $2 { print $1 }' "$made/groups")
    # shellcheck disable=SC2086
    set -- $with_plant
    plural=s
    [ $# -gt 1 ] || plural=
    echo "  CC    $# plant$plural of $SCENE"
    # shellcheck disable=SC2086
    each compiled $with_plant || fail "a plant cannot be compiled"
    if [ -n "$side" ]; then
        # shellcheck disable=SC2086
        $COMPILE $side -c tools/sweep/side.c -o "$made/side.o" || fail "tools/sweep/side.c cannot be compiled"
        OBJECTS=$(echo "$OBJECTS" | sed 's|[^ ]*/tools/sweep/alone[.]o||')
    fi
    # shellcheck disable=SC2086
    $COMPILE -c "$made/plants.c" -o "$made/plants.o" &&
        { echo "$made/plants.o" && for number in $with_plant; do echo "$made/plants/$number/plant.o"; done && echo ${side:+"$made/side.o"}; } >"$made/objects" &&
        $LINK "@$made/objects" $OBJECTS -o "$made/program" -lm || fail "the program cannot be linked"
    mkdir -p "$made/parts"
    mv "$made" "$dir" || exit 1
}

# again: $again is the beginning of the command that makes a run alone.
again()
{
    again="make run SCENE=$SCENE"
    [ "$REAL" = float ] || again="$again REAL=$REAL"
    again="$again SECONDS=$SECONDS"
    for name in METHOD STEP TOLERANCE INPUTS WITHOUT; do
        eval "value=\$$name"
        [ -z "$value" ] || again="$again $name='$value'"
    done
}

# watched PROCESS: shows the progress; when this script ends, so does the process.
watched()
{
    trap 'kill $1 2>/dev/null' EXIT
    trap 'exit 1' INT TERM HUP
    "$dir/program" "$dir" watch "$1"
    watched_status=$?
    wait "$1" 2>/dev/null
    trap - EXIT INT TERM HUP
    return $watched_status
}

# by_parallel: GNU parallel, on this machine, where a job makes several parts; or on HOSTS over ssh, which get the
# program and the plan, and give back a part.
by_parallel()
{
    parallel --version 2>/dev/null | grep -q '^GNU parallel' ||
        fail "ENGINE=parallel is GNU parallel, which is missing. Install it with: apt-get install parallel"
    if [ -z "$HOSTS" ]; then
        set -- parallel -n 8
    else
        set -- parallel --sshlogin "$(echo "$HOSTS" | tr ' ' ,)" --workdir ".isochron/sweep-${dir##*/}" --basefile plan --basefile program \
            --return 'parts/{}.tsv' --cleanup --retries 3
    fi
    (cd "$dir" && ./program . absent | exec "$@" 'mkdir -p parts && ./program . part {}') &
    watched $!
}

# is_queued: whether Slurm has the job of before.
is_queued()
{
    [ -f "$dir/slurm_job" ] && read -r job <"$dir/slurm_job" && [ -n "$(squeue -h -j "$job" 2>/dev/null)" ]
}

# by_slurm: an array of jobs, two shares for each processor; where one of before is still there, that.
by_slurm()
{
    for tool in sbatch squeue sinfo; do
        command -v $tool >/dev/null || fail "ENGINE=slurm needs $tool, which is missing. Install it with: apt-get install slurm-wlm"
    done
    if ! is_queued; then
        shares=$(sinfo -h -o %C | awk -F / -v parts="$("$dir/program" "$dir" absent | wc -l)" '
            { n += 2 * $4 } END { n = n < 2 ? 2 : n > 1000 ? 1000 : n; print (n < parts ? n : parts) }')
        mkdir -p "$dir/log"
        sbatch --parsable --job-name="sweep_$NAME" --array="0-$((shares - 1))" --chdir="$PWD" --output="$dir/log/%a.txt" \
            --wrap="exec '$dir/program' '$dir' share \$SLURM_ARRAY_TASK_ID $shares" >"$dir/slurm_job.new" || fail "sbatch refuses the job"
        mv "$dir/slurm_job.new" "$dir/slurm_job"
    fi
    echo "  SLURM job $(cat "$dir/slurm_job"), whose output is in $dir/log" >&2
    (while is_queued; do sleep 1; done) &
    watched $!
}

# summed: $sums are checksums of the table and its columns.
summed()
{
    sums=$(cksum "$FOLDER/columns.tsv" "$FOLDER/sweep.tsv" 2>/dev/null)
}

# drawn BEFORE: the table as sweep.svg and sweep.png, where gnuplot is there, and they are not those of this table
# already.
drawn()
{
    summed
    if [ "$1" = "$sums" ] && [ -s "$FOLDER/sweep.svg" ] && [ -s "$FOLDER/sweep.png" ] &&
        [ -z "$(find tools/plot -newer "$FOLDER/sweep.png")" ]; then
        printf 'picture %s\n' "$FOLDER/sweep.svg" "$FOLDER/sweep.png"
        return
    fi
    for old in "$FOLDER/sweep.svg" "$FOLDER/sweep.png"; do
        [ ! -e "$old" ] || rm -f "$old"
    done
    command -v gnuplot >/dev/null || {
        echo "no picture: gnuplot is missing. Install it with: apt-get install gnuplot-nox" >&2
        return 0
    }
    case $SET in
    *uniform\(* | *normal\(*) values=random ;;
    *) values=listed ;;
    esac
    # shellcheck disable=SC2086
    pictures=$(sh tools/plot/draw.sh "$FOLDER/sweep.gnuplot" sweep "$NAME" $values "$FOLDER/columns.tsv" "$FOLDER/sweep.tsv") &&
        [ -z "$pictures" ] || printf 'picture %s\n' $pictures
    rm -f "$FOLDER/sweep.gnuplot"
}

case $LANES in
'' | 1 | 2 | 4 | 8 | 16 | 32) ;;
*) fail "LANES=$LANES is no number of lanes; it can be 1, 2, 4, 8, 16 or 32" ;;
esac
case $ENGINE in
local | parallel | slurm) ;;
*) fail "ENGINE=$ENGINE is unknown; it can be local, parallel or slurm" ;;
esac
[ -z "$HOSTS" ] || [ "$ENGINE" = parallel ] || fail "HOSTS has no effect on ENGINE=$ENGINE; it is of ENGINE=parallel"
made=$FOLDER/made
processors=$(nproc)
planned
kept
if [ -n "$("$dir/program" "$dir" absent)" ]; then
    case $ENGINE in
    local) "$dir/program" "$dir" make "$processors" ;;
    parallel) by_parallel ;;
    slurm) by_slurm ;;
    esac || exit 1
fi
for left in "$dir"/parts/*.tsv.*; do
    [ ! -e "$left" ] || rm -f "$left"
done
summed
before=$sums
again
"$dir/program" "$dir" table "$FOLDER" "$again" && drawn "$before"
