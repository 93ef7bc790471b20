#!/bin/sh
# A plant goes on from a record bit for bit: models by every method, in float and in double, with and without a check of its
# steps (with one, a step may be made again) and smooth inputs; always the scene with all effects of the library, its noise,
# delays and faults among them, and a drive whose faults come by the clock. By itself a model for each method, by turns; with
# an argument, every model that is not large:
#
#     tests/snapshot/family.t all
. tests/host/test.sh
begin snapshot_family
METHODS=$(build/isoc --methods | sed -n 's/^| \([a-z0-9_]*\) | [0-9].*/\1/p')
turns=24
turn=$(turn_of $turns "${1-}" core tools/isoc)
seed=$(turn_of 1000000 "" core tools/isoc)
[ "$seed" != all ] || seed=1
echo "# turn $turn"
cp -R models/*.scene models/parts "$out" # for those that include another

# member SCENE METHOD TICKS OPTION...: its plant, twice; $checked adds a line to the scene.
member()
{
    scene=$1
    method=$2
    ticks=$3
    shift 3
    name=$(basename "$scene" .scene)_$method
    { cat "$scene" && ! grep -q '^checked' "$scene" && echo "$checked"; } >"$out/$name.scene"
    build/isoc "$out/$name.scene" -o "$out" --name "$name" --real "$real" --method "$method" "$@" >"$out/summary" 2>"$out/errors" || {
        sed 's/^/# /' "$out/errors"
        return 1
    }
    before=
    ! grep -q 'const before)' "$out/$name.h" || before=", &before[i]"
    cat >"$out/$name.member.c" <<C
#include "$out/$name.c"
#include "tests/snapshot/family.h"
static iso_plant plant_of(const int i)
{
    static ${name}_memory memory[2]${before:+, before[2]};
    return ${name}_plant(&memory[i]$before);
}
extern const family_member $name;
const family_member $name = {"$name $checked $*", $ticks, plant_of};
C
    # Without optimisation, and by the compiler that takes half of the time for that.
    # shellcheck disable=SC2086
    clang -std=c11 -O0 -ffp-contract=off -fno-math-errno -I. $REAL_FLAG -c "$out/$name.member.c" -o "$out/$name.o" &&
        list="$list $name"
}

# has_its_turn NUMBER: of the model with that number.
has_its_turn()
{
    [ "$turn" = all ] || [ $(($1 % turns)) -eq "$turn" ]
}

# members: those of the present type of numbers. A model has another turn with each method, and in each type.
members()
{
    number=$([ "$real" = float ] && echo 0 || echo 5)
    for method in $METHODS; do
        number=$((number + 7))
        at=$number
        for scene in $(models "$method" | grep -vxF models/stewart.scene); do
            at=$((at + 1))
            has_its_turn $at || continue
            tried=$((tried + 1))
            checked=$([ $((tried % 2)) -eq 0 ] || echo 'checked yes')
            inputs=$([ $((tried / 2 % 2)) -eq 0 ] && grep -q '^input' "$scene" && echo '--inputs smooth')
            # shellcheck disable=SC2086
            member "$scene" "$method" 300 $inputs || return
        done
    done
}

tried=0
for real in float double; do
    real $real
    list=
    checked=
    members
    result $? "$real: the plants of this turn are compiled"
    checked=
    [ "$real" = double ] || {
        member tests/effects/all.scene rk4 4200 && member models/cart_pole_drive.scene adams 9000
        result $? "$real: and those with all effects and with faults"
    }
    {
        echo '#include "tests/snapshot/family.h"'
        for name in $list; do
            echo "extern const family_member $name;"
        done
        echo 'const family_member *const family[] = {'
        for name in $list; do
            echo "    &$name,"
        done
        echo '    0};'
    } >"$out/family.c"
    # shellcheck disable=SC2046
    program "family_$real" tests/snapshot/family.c "$out/family.c" core/runtime/snapshot.c tests/host/report.c \
        $(for name in $list; do echo "$out/$name.o"; done)
    result $? "$real: they link into one program"
    joined "$real" "$out/family_$real" "$seed"
done

# Control: what a record leaves out shows.
sed 's/memcpy(record + sizeof head, plant->memory, head.memory_bytes);/memcpy(record + sizeof head, plant->memory, 4);/' \
    core/runtime/snapshot.c >"$out/planted.c"
# shellcheck disable=SC2046
! cmp -s "$out/planted.c" core/runtime/snapshot.c &&
    program planted tests/snapshot/family.c "$out/family.c" "$out/planted.c" tests/host/report.c \
        $(for name in $list; do echo "$out/$name.o"; done) && ! "$out/planted" 1 >"$out/found" && grep -q '^not ok' "$out/found"
result $? "found: a record that has 4 bytes of the memory alone"
finish
