#!/bin/sh
# A plant goes on from a record bit for bit: models by every method, in float and in double, with and without a check of its
# steps (with one, a step may be made again) and smooth inputs; always the scene with all effects of the library, its noise,
# delays and faults among them, and a drive whose faults come by the clock.
. tests/host/test.sh
begin snapshot_family
one_isoc
METHODS=$(build/isoc --methods | sed -n 's/^| \([a-z0-9_]*\) | [0-9].*/\1/p')
seed=$(turn_of 1000000 "" core tools/isoc)
[ "$seed" != all ] || seed=1
cp -R models/*.scene models/parts "$out" # for those that include another

# with PATTERN: $with is a list of the models that have a line like it, each between spaces.
with()
{
    with=" $(grep -l -- "$1" models/*.scene | tr '\n' ' ')"
}
with '^checked'
with_check=$with
with '^input'
with_input=$with

# is_in SCENE LIST: whether it stands in it.
is_in()
{
    case $2 in
    *" $1 "*) ;;
    *) return 1 ;;
    esac
}

# member SCENE METHOD TICKS OPTION...: its plant, twice; $checked adds a line to the scene.
member()
{
    scene=$1
    method=$2
    ticks=$3
    shift 3
    name=${scene##*/}
    name=${name%.scene}_$method
    cat "$scene" >"$out/$name.scene"
    is_in "$scene" "$with_check" || echo "$checked" >>"$out/$name.scene"
    isoc "$out/summary" "$out/errors" "$out/$name.scene" -o "$out" --name "$name" --real "$real" --method "$method" "$@" || {
        sed 's/^/# /' "$out/errors"
        return 1
    }
    before=
    ! grep -q 'const before)' "$out/$name.h" || before=", &before[i]"
    echo "#include \"$out/$name.c\"
#include \"tests/snapshot/family.h\"
static iso_plant plant_of(const int i)
{
    static ${name}_memory memory[2]${before:+, before[2]};
    return ${name}_plant(&memory[i]$before);
}
extern const family_member $name;
const family_member $name = {\"$name $checked $*\", $ticks, plant_of};" >"$out/$name.member.c"
    quick_object "$out/$name.member.c" "$out/$name.o" && list="$list $name"
}

# members: every model that is not large with every method, in the present type of numbers.
members()
{
    for method in $METHODS; do
        models_of "$method"
        for scene in $models; do
            [ "$scene" != models/stewart.scene ] || continue
            tried=$((tried + 1))
            checked=
            [ $((tried % 2)) -eq 0 ] || checked='checked yes'
            inputs=
            [ $((tried / 2 % 2)) -ne 0 ] || ! is_in "$scene" "$with_input" || inputs='--inputs smooth'
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
    result $? "$real: the plants are compiled"
    checked=
    [ "$real" = double ] || {
        member tests/effects/all.scene rk4 4200 && member models/cart_pole_drive.scene adams 9000
        result $? "$real: and those with all effects and with faults"
    }
    objects=
    {
        echo '#include "tests/snapshot/family.h"'
        for name in $list; do
            echo "extern const family_member $name;"
            objects="$objects $out/$name.o"
        done
        echo 'const family_member *const family[] = {'
        for name in $list; do
            echo "    &$name,"
        done
        echo '    0};'
    } >"$out/family.c"
    # shellcheck disable=SC2086
    program "family_$real" tests/snapshot/family.c "$out/family.c" core/runtime/snapshot.c tests/host/report.c $objects $quick_library
    result $? "$real: they link into one program"
    joined "$real" "$out/family_$real" "$seed"
done

# Control: what a record leaves out shows.
sed 's/memcpy(record + sizeof head, plant->memory, head.memory_bytes);/memcpy(record + sizeof head, plant->memory, 4);/' \
    core/runtime/snapshot.c >"$out/planted.c"
# shellcheck disable=SC2086
! cmp -s "$out/planted.c" core/runtime/snapshot.c &&
    program planted tests/snapshot/family.c "$out/family.c" "$out/planted.c" tests/host/report.c $objects $quick_library && ! "$out/planted" 1 >"$out/found" && grep -q '^not ok' "$out/found"
result $? "found: a record that has 4 bytes of the memory alone"
finish
