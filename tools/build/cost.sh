#!/bin/sh
# The price list, as Markdown tables: what each model costs on the Cortex-M4F in float, what its steps cost with each
# method, what the dearest of them cost, and what each effect of tools/build/effects.txt adds to the pendulum. Called by
# `make cost`, with the make to call in $MAKE and the methods in $METHODS.
set -u

. tools/build/measure.sh

# tick: the most instructions from the time that a tick is due until its outputs are out: 25 in a microsecond, less what
# was left.
tick()
{
    awk '$1 == "step" { step = $2 } $1 == "margin" { margin = $2; n++ }
        END { if (n != 1) exit 1; printf "%.0f\n", step * 25e6 - margin }' "$dir/measured" ||
        fail "$dir/measured has not one margin"
}

# price: of the program measured last: instructions of a step and of a tick, bytes of the firmware's text and of the
# plant's memory.
price()
{
    instructions=$(get instructions_per_step) && all=$(tick) && text=$(get text) && memory=$(get plant_memory) || exit 1
    echo "$instructions $all $text $memory"
}

# model MODEL: of the squeezer, whose step takes longer than its tick of 10 us, in longer ticks: no count depends on them.
model()
{
    step=$([ "$1" != squeezer ] || echo 500us)
    measure "$1-euler" "models/$1.scene" euler
    once=$(get instructions_per_step) || exit 1
    measure "$1-rk4" "models/$1.scene" rk4 size stack
    states=$(awk '$1 == "states" { print $2 }' "$dir/plant.txt")
    instructions=$(get instructions_per_step) && operations=$(operations) && text=$(get step_text) &&
        memory=$(get plant_memory) && stack=$(get stack_of_step) && isoc=$(compiling "models/$1.scene") || exit 1
    step=
    echo "| $1 | $states | $operations | $once | $instructions | $text | $memory | $stack | $isoc |"
}

# methods MODEL: the instructions of its steps.
methods()
{
    line="| $1"
    for method in $METHODS; do
        measure "$1-$method" "models/$1.scene" "$method"
        instructions=$(get instructions_per_step) || exit 1
        line="$line | $instructions"
    done
    echo "$line |"
}

effect()
{
    folder=build/cost/effects/$(echo "$1" | tr -cs 'a-z\n' -)
    mkdir -p "$folder"
    awk -v effect="$1" -f tools/build/effect.awk tools/build/effects.txt models/pendulum.scene \
        >"$folder/pendulum.scene" || fail "no scene for '$1'"
    measure "${folder#build/cost/}" "$folder/pendulum.scene" rk4 size
    with=$(price) || exit 1
    echo "$without $with" | awk -v name="$1" '
        { printf "| %s | %+d | %+d | %+d | %+d |\n", name, $5 - $1, $6 - $2, $7 - $3, $8 - $4 }'
}

models="pendulum double_pendulum cart_pole arm6 tree"
echo '| model | states | add | mul | div | sincos | euler | rk4 | text | memory | stack | isoc |'
echo '|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|'
for name in $models four_bar squeezer; do
    model $name
done
echo
echo "| steps of |$(for method in $METHODS; do printf ' %s |' "$method"; done)"
echo "|---|$(for method in $METHODS; do printf -- '--:|'; done)"
for name in $models; do
    methods $name
done
echo
echo '| dearest step of | ab4 | abm4 | abm4_pec | abm4_pecece | bdf4 | adams |'
echo '|---|--:|--:|--:|--:|--:|--:|'
for name in $models; do
    for jump in told found; do
        line="| $name, $jump"
        for method in ab4 abm4 abm4_pec abm4_pecece bdf4 adams; do
            instructions=-
            [ $method-$jump = adams-found ] ||
                instructions=$(dearest "$name-$method-$jump" "models/$name.scene" $method $jump) || exit 1
            line="$line | $instructions"
        done
        echo "$line |"
    done
done
echo
echo '| effect on the pendulum | instructions of a step | of a tick | bytes of text | of memory |'
echo '|---|--:|--:|--:|--:|'
measure pendulum-rk4 models/pendulum.scene rk4 size
without=$(price) || exit 1
sed -n 's/^\([^#|][^|]*[^ |]\) *|.*/\1/p' tools/build/effects.txt | while IFS= read -r name; do
    effect "$name" || exit 1
done
