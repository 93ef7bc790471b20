#!/bin/sh
# Other cores than the Cortex-M4F, also without a floating-point unit, and double where there is no unit for that: the
# bits of the host, and one number of instructions, or of cycles, for every step; with libgcc's helpers in place of
# port/soft the number follows from the state, and in float the bits are the same.
. tests/host/test.sh
. tests/host/project.sh
begin soft_targets
project
unoptimised clang
cp tests/promises/cost/masses3.scene "$out/project/models"

# ran SCENE TARGET SECONDS [REAL]: make run.
ran()
{
    isochron run "models/$1.scene" --target "$2" --seconds "$3" --real "${4-float}"
}

# on_host SCENE SECONDS: sets hash, by a run at the first call for both.
on_host()
{
    [ -f "$out/$1-$2" ] || { ran "$1" host "$2" && value hash >"$out/$1-$2"; }
    hash= && read -r hash <"$out/$1-$2" && [ -n "$hash" ]
}

# tabled TARGET COLUMN VALUE: whether port/README.md has it in the target's row, in the table of cores without a
# floating-point unit.
tabled()
{
    tabled=$(awk -F ' *[|] *' -v target="\`$1\`" -v column="$2" '
        /^## / { here = /^## Cores without / }
        here && index($2, target) { print $(column + 1) }' port/README.md)
    [ "$tabled" = "$3" ] || { echo "# port/README.md: $tabled; measured: $3" && false; }
}

# counted: in the last run the shortest step took as long as the longest. $least, $mean and $most are these.
counted()
{
    read_value execution
    # shellcheck disable=SC2086
    set -- $value
    least=${1-none} mean=${2-} most=${3-} unit=${4-}
    [ "$least" = "$most" ]
}

while read -r target seconds; do
    column=0
    for scene in double_pendulum cart_pole_drive; do
        column=$((column + 2))
        on_host $scene "$seconds"
        expect $? "$scene on the host: $hash"
        ran $scene "$target" "$seconds" && printed hash "$hash"
        expect $? "$scene on the $target: the same bits"
        counted && tabled "$target" $column "$least"
        expect $? "$scene on the $target: $least $unit on every step, as port/README.md says"
    done
    on_host masses3 0.02 && ran masses3 "$target" 0.02 && printed hash "$hash" && counted
    expect $? "springs, with a root and a quotient each, on the $target: the same bits, $least $unit on every step"
done <<END
cortex-m7 2
cortex-m33 2
cortex-m55 2
cortex-m3 2
cortex-m0 2
rv32imafc 2
rv32imac 2
atmega1284p 0.02
END

# Of double by turns a scene on a target.
turn=$(turn_of 8 "${1-}")
echo "# turn $turn of double"
ran double_pendulum host 0.1 double && read_value hash && right=$value && [ -n "$right" ]
expect $? "double_pendulum on the host, double: $right"
number=0
for target in cortex-m4f cortex-m33 cortex-m3 cortex-m0 rv32imac rv32imafc stm32f407 cortex-m55; do
    number=$((number + 1))
    [ "$turn" = all ] || [ $((number - 1)) -eq "$turn" ] || continue
    ran double_pendulum $target 0.1 double && printed hash "$right" && counted && tabled $target 6 "$least"
    expect $? "double_pendulum on the $target, double: the same bits, $least $unit on every step, as port/README.md says"
    [ $target != cortex-m4f ] || {
        double=$least
        ran double_pendulum $target 0.1 && counted && stated README.md "in double a Cortex-M4F takes $(((double / least + 5) / 10 * 10)) times as long"
        expect $? "as README.md says of $double and, in float, $least $unit"
    }
done
for port in mps2 virt; do
    sed -i 's/^PORT_DOUBLE = .*/PORT_DOUBLE =/' "$out/project/port/$port/board.mk"
done
case $turn in
[0246] | all)
    ! ran double_pendulum cortex-m4f 0.1 double && says 'changes the bits of results'
    expect $? "found: helpers of libgcc for double on the cortex-m4f, by the check at the start"
    ;;
esac
case $turn in
[1357] | all)
    ran double_pendulum rv32imac 0.1 double && printed hash "$right" && ! counted && [ -n "$unit" ] &&
        stated port/README.md "In double libgcc takes $least to $most, mean $mean, on the \`rv32imac\`"
    expect $? "found: helpers of libgcc for double on the rv32imac: from $least to $most $unit, mean $mean"
    ;;
esac

while read -r target seconds; do
    sed -i 's/ port\/soft\/[a-z_]*\.[cS]//g' "$out/project/port/$target/port.mk"
    column=1
    for scene in double_pendulum cart_pole_drive; do
        column=$((column + 2))
        on_host $scene "$seconds" && ran $scene "$target" "$seconds" && printed hash "$hash" && ! counted && [ -n "$unit" ] &&
            tabled "$target" $column "$least to $most, mean $mean"
        expect $? "found: helpers of libgcc for $scene on the $target: from $least to $most $unit, mean $mean"
    done
done <<END
cortex-m3 2
cortex-m0 2
rv32imac 2
atmega1284p 0.02
END
finish
