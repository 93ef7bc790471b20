#!/bin/sh
# Tables of costs on the Cortex-M4F in float, as Markdown; the parts of $PARTS, with an empty line between them:
#
#     models    states, operations, instructions and bytes of each model
#     methods   instructions of a step with each method
#     restarts  instructions of the longest step, which is one with a restart
#     effects   the cost that each effect of tools/measure/effects.txt adds to the pendulum
#     library   the cost that each effect of models/effects adds, in a scene of tools/measure/library.txt
#
# Called by `make cost`, with the make to call in $MAKE and the methods in $METHODS. With $TURN only some rows of each
# table (`due` of tools/measure/common.sh).
. tools/measure/board.sh

# cost: $cost is that of the program measured last: instructions of a step and of a tick, bytes of the firmware's text
# and of the plant's memory.
cost()
{
    get instructions_per_step text plant_memory && tick || exit 1
    cost="$instructions_per_step $tick $text $plant_memory"
}

# model MODEL: a row. The squeezer's step is longer than its tick of 10 us, so it runs with a longer tick, and only for
# some of them: its motion is then far from the true one, and would soon be out of range. No count depends on it.
model()
{
    [ "$1" != squeezer ] || { STEP=500us && seconds=0.01; }
    measure "$1-euler" "models/$1.scene" euler
    get instructions_per_step && once=$instructions_per_step
    measure "$1-rk4" "models/$1.scene" rk4 size stack
    count_operations && get instructions_per_step step_text plant_memory stack_of_step
    STEP='' seconds=0.05
    echo "| $1 | $states | $operations | $once | $instructions_per_step | $step_text | $plant_memory | $stack_of_step |"
}

models()
{
    echo '| model | states | add | mul | div | sincos | euler | rk4 | text | memory | stack |'
    echo '|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|'
    for name in $models four_bar squeezer $machines; do
        ! due || model "$name"
    done
}

methods()
{
    head='| instructions of a step |' line='|---|'
    for method in $METHODS; do
        head="$head $method |" line="$line--:|"
    done
    printf '%s\n' "$head" "$line"
    for name in $models; do
        due || continue
        line="| $name"
        set --
        for method in $METHODS; do
            set -- "$@" "build/cost/$name-$method"
        done
        folders "$@"
        for method in $METHODS; do
            measure "$name-$method" "models/$name.scene" "$method"
            get instructions_per_step
            line="$line | $instructions_per_step"
        done
        echo "$line |"
    done
}

restarts()
{
    echo '| instructions of the longest step | ab4 | abm4 | abm4_pec | abm4_pecece | bdf4 | adams |'
    echo '|---|--:|--:|--:|--:|--:|--:|'
    for name in $models; do
        for discontinuity in announced detected; do
            due || continue
            line="| $name, $discontinuity"
            for method in ab4 abm4 abm4_pec abm4_pecece bdf4 adams; do
                instructions=-
                [ $method-$discontinuity = adams-detected ] ||
                    instructions=$(longest_step "$name-$method-$discontinuity" "models/$name.scene" $method $discontinuity) || exit 1
                line="$line | $instructions"
            done
            echo "$line |"
        done
    done
}

# effect NAME: a row.
effect()
{
    folder=build/cost/effects/$(echo "$1" | tr -cs 'a-z\n' -)
    folders "$folder"
    compute effect -v name="$1" tools/measure/effects.txt models/pendulum.scene \
        >"$folder/pendulum.scene" || fail "no scene for '$1'"
    measure "${folder#build/cost/}" "$folder/pendulum.scene" rk4 size
    cost
    # shellcheck disable=SC2086
    set -- "$1" $without $cost
    printf '| %s | %+d | %+d | %+d | %+d |\n' "$1" $(($6 - $2)) $(($7 - $3)) $(($8 - $4)) $(($9 - $5))
}

effects()
{
    echo '| effect on the pendulum | instructions of a step | of a tick | bytes of text | of memory |'
    echo '|---|--:|--:|--:|--:|'
    measure pendulum-rk4 models/pendulum.scene rk4 size
    cost
    without=$cost
    sed -n 's/^\([^#|][^|]*[^ |]\) *|.*/\1/p' tools/measure/effects.txt | while IFS= read -r name; do
        ! due || effect "$name" || exit 1
    done
}

# library_scene BASE SIGNAL [STATEMENTS]: the pendulum with these statements and those of the base; measured in
# build/cost/$folder: $instructions_per_step, and $rest of the tick.
library_scene()
{
    folders "build/cost/$folder"
    {
        awk -F ' *[|] *' -v name="$1" -v signal="$2" '
            FNR == NR { print; next }
            $1 == "base" && $2 == name { gsub(/SIGNAL/, signal == "" ? $3 : signal, $4); print $4 }' models/pendulum.scene tools/measure/library.txt
        echo "${3-}"
    } >"build/cost/$folder/pendulum.scene"
    measure "$folder" "build/cost/$folder/pendulum.scene" rk4
    get instructions_per_step && tick || exit 1
    rest=$((tick - instructions_per_step))
}

# told KIND: the description in its file, as cells: the first sentence of its comment, and its operands; in brackets
# those with a default.
told()
{
    awk '
        /^#/ && !told { text = text substr($0, 2); if (match(text, /[.:]( |$)/)) { text = substr(text, 2, RSTART - 2); told = 1 } }
        /^ / {
            sub(/#.*/, "")
            parts = split($0, part, ";")
            for (i = 1; i <= parts; i++) {
                words = split(part[i], word, " ")
                if (words < 2 || word[1] !~ /^(joint|body|signal|value|fault)$/) continue
                name = word[1] == "fault" ? "fault `" word[2] "`" : "`" word[2] "`"
                list = list (list == "" ? "" : ", ") (part[i] ~ /=/ ? "[" name "]" : name)
            }
        }
        END { print text " | " list }' "models/effects/$1.scene"
}

library()
{
    rm -rf build/cost/library
    echo '| effect | what it is | operands | step | rest of the tick |'
    echo '|---|---|---|--:|--:|'
    grep -v '^#\|^base ' tools/measure/library.txt | while IFS='|' read -r kind base signal statements; do
        due || continue
        kind=${kind% }
        base=${base# }
        base=${base% }
        folder=library/$base
        [ -s "build/cost/$folder/without" ] || {
            library_scene "$base" ''
            echo "$instructions_per_step $rest" >"build/cost/$folder/without"
        }
        read -r step_without rest_without <"build/cost/$folder/without"
        folder=library/of-$kind
        signal=${signal# }
        library_scene "$base" "${signal% }" "$statements"
        # shellcheck disable=SC2016
        printf '| `%s` | %s | %+d | %+d |\n' "$kind" "$(told "$kind")" $((instructions_per_step - step_without)) $((rest - rest_without))
    done
}

models="pendulum double_pendulum cart_pole arm6 tree"
machines="dc_motor_bench cart_pole_drive arm_drive quarter_car crane balancer hopper quadrotor_sih"
first=yes
for part in $PARTS; do
    case $part in
    models | methods | restarts | effects | library) ;;
    *) fail "PARTS=$part is unknown; it can be: models methods restarts effects library" ;;
    esac
    [ $first = yes ] || echo
    first=no
    row=-1
    $part || exit 1
done
