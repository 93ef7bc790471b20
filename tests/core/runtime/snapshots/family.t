#!/bin/sh
# A plant goes on from a record bit for bit: models by every method, in float and in double, with and without a check of
# its steps (with one, a step may be made again) and smooth inputs; the scene with all effects of the library, its
# noise, delays and faults among them; and a drive whose faults come by the clock.
. tests/host/test.sh
begin snapshot_family
one_isoc
quick
METHODS=$(build/isoc --methods | sed -n 's/^| \([a-z0-9_]*\) | [0-9].*/\1/p')
seed=$(turn_of 1000000)
[ "$seed" != all ] || seed=1

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

# plant SCENE METHOD TICKS OPTION...: of a member of the family; $checked adds a line to the scene.
plant()
{
    scene=$1
    method=$2
    ticks=$3
    shift 3
    name=${scene##*/}
    name=${name%.scene}_$method
    line=
    is_in "$scene" "$with_check" || line=$checked
    printf 'include "%s"\n%s\n' "$PWD/$scene" "$line" >"$out/$name.scene"
    isoc "$out/summary" "$out/errors" "$out/$name.scene" -o "$out" --name "$name" --real "$real" --method "$method" "$@" || {
        sed 's/^/# /' "$out/errors"
        return 1
    }
    names="$names $name"
    members="$members$name $ticks $checked $*
"
}

# sources: one for each member, which has its plant twice, and the list of them.
sources()
{
    # shellcheck disable=SC2046
    with_before=" $(cd "$out" && grep -l 'const before)' $(printf '%s.h\n' $names) | tr '\n' ' ')"
    list=
    while read -r name ticks text; do
        before=
        ! is_in "$name.h" "$with_before" || before=", &before[i]"
        echo "#include \"$out/$name.c\"
#include \"tests/core/runtime/snapshots/family.h\"
static iso_plant plant_of(const int i)
{
    static ${name}_memory memory[2]${before:+, before[2]};
    return ${name}_plant(&memory[i]$before);
}
extern const family_member $name;
const family_member $name = {\"$name $text\", $ticks, plant_of};" >"$out/$name.member.c"
        echo "extern const family_member $name;" >&3
        list="$list&$name, "
    done
    echo "const family_member *const family[] = {${list}0};" >&3
}

# plants: every model that is not large with every method, in the present type of numbers.
plants()
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
            plant "$scene" "$method" 300 $inputs || return
        done
    done
}

# family PROGRAM SNAPSHOT: the program of all members, with this source of snapshots.
family()
{
    # shellcheck disable=SC2086
    program "$1" tests/core/runtime/snapshots/family.c "$out/family.c" "$2" tests/host/report.c $sources
}

tried=0
for real in float double; do
    real $real
    names=
    members=
    checked=
    plants
    result $? "$real: isoc compiles the models"
    checked=
    [ "$real" = double ] || {
        plant tests/isoc/effects/all.scene rk4 4200 && plant tests/isoc/events/events.scene rk4 900 && plant models/cart_pole_drive.scene adams 9000
        result $? "$real: and the scenes with all effects, with events and with faults"
    }
    echo '#include "tests/core/runtime/snapshots/family.h"' >"$out/family.c"
    printf '%s' "$members" | sources 3>>"$out/family.c"
    # shellcheck disable=SC2046
    sources=$(printf "$out/%s.member.c\n" $names)
    family "family_$real" core/runtime/snapshot.c
    result $? "$real: the plants compile, and link into one program"
    joined "$real" "$out/family_$real" "$seed"
done

# Control: what a record leaves out shows.
sed 's/memcpy(snapshot + sizeof head, plant->memory, head.memory_bytes);/memcpy(snapshot + sizeof head, plant->memory, 4);/' \
    core/runtime/snapshot.c >"$out/planted.c"
! cmp -s "$out/planted.c" core/runtime/snapshot.c &&
    family planted "$out/planted.c" && ! "$out/planted" 1 >"$out/found" && grep -q '^not ok' "$out/found"
result $? "found: a record that has 4 bytes of the memory alone"
finish
