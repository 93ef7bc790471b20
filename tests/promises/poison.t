#!/bin/sh
# Nothing in a step branches, loops or indexes on state, input or parameter: memcheck says so with all of them marked
# undefined, for every scene and the plant written by hand, with each method, in float and in double.
. tests/host/test.sh
begin check/poison
one_isoc
. tests/host/poison.sh
METHODS=$(build/isoc --methods | sed -n 's/^| \([a-z0-9_]*\) | [0-9] |.*/\1/p')

# On the models that are tried in depth every kernel, one of the methods that share it, those that are not one-step
# methods from a table by turns, with the argument `all` all; and rk4 on the others, by turns. On one that has all kinds
# of joints every method with a check, compensation and a smooth input, in double, and by clang; of each of the three
# one half by turns.
turn=$(turn_of 20 "${1-}")
echo "# turn $turn of the models and methods"
batch float float
{ sed 's/^input push /&smooth /' models/tree.scene && printf 'checked yes\ncompensated yes\n'; } >"$out/tree_checked.scene"
for method in $METHODS; do
    models_of "$method"
    for scene in $models; do
        if { [ "$method" = rk4 ] || { in_depth "$scene" && has_turn "$scene" "$method"; }; } && due "$scene" "$method"; then
            generated "$scene" "$method"
        fi
    done
    macro_of "$method"
    add "oscillator, $method, float" models/oscillator.c "-DISO_METHOD=$macro" "-DISO_METHOD_NAME=$method"
    ! next_turn 2 || generated "$out/tree_checked.scene" "$method"
done
for method in rk4 rosenbrock; do
    generated tests/isoc/scene/frames.scene $method
done
generated tests/isoc/plant/inputs/waveforms.scene rk4
generated tests/isoc/plant/tunables/chain.scene rk4
generated tests/isoc/effects/all.scene rk4
generated tests/isoc/events/events.scene rk4
generated tests/isoc/events/holds.scene rk4
generated tests/isoc/effects/substeps.scene rk4
{ cat models/pendulum.scene && printf '%s\n' 'overrun degrade { method euler; hold; after 9 ticks }' 'grace 10 ticks' 'publish next_tick' histogram 'substeps 4'; } >"$out/policies.scene"
generated "$out/policies.scene" rk4
joined "examined" watch

batch double double
for method in $METHODS; do
    next_turn 2 || continue
    generated models/tree.scene "$method"
    macro_of "$method"
    add "oscillator, $method, checked and compensated, double" models/oscillator.c "-DISO_METHOD=$macro" "-DISO_METHOD_NAME=$method" \
        -DISO_CHECK -DISO_COMPENSATE
done
generated models/tree.scene bdf4 --factors looped
generated tests/isoc/effects/all.scene rk4
generated tests/isoc/events/events.scene rk4
generated tests/isoc/events/holds.scene rk4
joined "examined" watch

# Clang has its own ways to make a branch of a selection; steps with a check and compensation select the most.
batch clang float clang
for method in $METHODS; do
    ! next_turn 2 || generated "$out/tree_checked.scene" "$method"
done
generated "$out/tree_checked.scene" rosenbrock --factors looped
generated tests/isoc/effects/all.scene rk4
generated tests/isoc/events/events.scene rk4
generated tests/isoc/events/holds.scene rk4
generated tests/isoc/effects/substeps.scene rk4
joined "by clang" watch

# planted KIND TESTS NAME: memcheck finds it with every method, half of them by turns, in the tests of these numbers of
# three and no other.
planted()
{
    for method in euler rk4 ab4 abm4 bdf4 rosenbrock; do
        next_turn 2 || continue
        macro_of $method
        add "$1 $method" tests/promises/planted_plant.c "-DPLANTED=$1" "-DISO_METHOD=$macro" "-DISO_METHOD_NAME=$method"
        echo "$method: $3" >>"$folder/names"
        echo "${2:-none}" >>"$folder/expected"
    done
}

batch planted float
planted NOTHING "" "the plant that the violations are planted in is clean"
planted BRANCH 2 "found: a branch on the state"
planted INDEX 2 "found: an index from the state"
planted LOOP 2 "found: a loop count from the state"
planted OUTPUT 3 "found: a branch on the state in the outputs"
planted MEMORY 3 "found: a branch on the state in the memories"
watch >"$out/tap"
# Of every three tests those that failed.
awk '/^(not )?ok [0-9]+ - / {
        failed = failed (/^not/ ? n % 3 + 1 : "")
        if (++n % 3 == 0) {
            print (failed == "" ? "none" : failed)
            failed = ""
        }
    }' "$out/tap" >"$out/found"
paste -d '|' "$folder/expected" "$out/found" "$folder/names" >"$out/compared"
while IFS='|' read -r expected found name; do
    [ "$expected" = "$found" ]
    result $? "$name"
done <"$out/compared"
finish
