#!/bin/sh
# Tunables: what follows from them alone is computed when one changes. A change between two ticks is what a plant does
# that was compiled with these values; the rest of a step costs as much as with constants.
. tests/host/test.sh
. tests/host/project.sh
begin tunables
one_isoc
out=$PWD/$out

# Other values of all, within their limits.
other='rod = 0.45 kg; length = 0.27 m; drag = 0.03 N*m*s/rad; stiffness = 3.3 N*m/rad; delay = 35 ms'
sed 's/^tunable \([a-z]* = [0-9.]* [^ ]*\) in .*/constant \1/' tests/isoc/plant/tunables/chain.scene >"$out/chain.scene"

# plants METHOD held|smooth: the three plants of tunables.c.
plants()
{
    isoc "$out/summary" '' tests/isoc/plant/tunables/chain.scene -o "$out" --name tuned --method "$1" --inputs "$2" --real "$real" &&
        isoc "$out/summary" '' tests/isoc/plant/tunables/chain.scene -o "$out" --name other --method "$1" --inputs "$2" --real "$real" --set "$other" &&
        isoc "$out/summary" '' "$out/chain.scene" -o "$out" --name fixed --method "$1" --inputs "$2" --real "$real" --set "$other"
}

# tried NAME: the program of them.
tried()
{
    EXTRA="-I$out" program "$1" tests/isoc/plant/tunables/tunables.c tests/host/report.c "$out/tuned.c" "$out/other.c" "$out/fixed.c"
}

quick
real float
for method in 'rk4 held' 'rk4 smooth' 'ab4 smooth' 'bdf4 smooth' 'rosenbrock held' 'semi_implicit held' 'adams held'; do
    # shellcheck disable=SC2086
    plants $method
    grep -q '^static void tune(' "$out/tuned.c" && ! grep -q 'PLANT_P_\|p\[' "$out/fixed.c"
    result $? "$method: a function computes what follows from tunables alone"
    tried program
    joined "$method, float" "$out/program"
done
real double
plants rk4 held
tried program
joined 'rk4 held, double' "$out/program"

# A change that is not seen shows.
sed 's/^    found |= memory->changed != 0;$//' "$out/tuned.c" >"$out/forgets.c"
mv "$out/forgets.c" "$out/tuned.c"
tried forgets
! "$out/forgets" >"$out/tap" && grep -q '^not ok .*compiled with these values' "$out/tap"
result $? 'control: a plant that does not look is found'

# run_of KIND NAME: a short run on the Cortex-M4F of $out/NAME.scene with its tunables as this kind of parameter.
run_of()
{
    sed "s/^tunable /$1 /" "$out/$2.scene" >"$out/$2_$1.scene"
    isochron run "$out/$2_$1.scene" --target cortex-m4f --seconds 0.1 || explain
    read_value instructions_per_step
    step=$value
    read_value margin
    margin=${value%% *}
}

# within NAME: with tunables a step takes at most 2 % and 15 more instructions than with constants, which are literals;
# and another number, so that it is another plant. In one with many spills gcc may find it the cheaper one.
within()
{
    run_of constant "$1"
    constant=$step left=$margin
    run_of tunable "$1"
    beside=$((left - margin - (step - constant)))
    [ "$constant" -gt 0 ] && [ "$step" -ne "$constant" ] && [ $((100 * (step - constant))) -le $((2 * constant + 1500)) ]
    result $? "$1: a step has $step instructions, with constants $constant, at most 2 % and 15 more; the rest of a tick $beside more"
}

# The quadrotor's inertia and damping become six tunables.
sed -e '/^constant hover/i tunable mass = 1.2 kg\
tunable about_x = 12 g*m^2\
tunable about_y = 12.5 g*m^2\
tunable about_z = 21 g*m^2\
tunable drag = 0.2 N*s/m\
tunable spin_drag = 5 mN*m*s/rad' -e 's/    mass 1.2 kg/    mass mass/' \
    -e 's/inertia (12, 12.5, 21; 0.1, 0.2, -0.1) g/inertia (about_x, about_y, about_z; 0.1 g*m^2, 0.2 g*m^2, -0.1 g/' \
    -e '/inertia/s/$/)/' -e 's/ damping 0.2.*/ damping drag/' -e 's/spin_damping 5.*/spin_damping spin_drag/' \
    models/quadrotor.scene >"$out/quadrotor.scene"
# That with effects has seven: its mass and inertia, and of its propellers and of the air.
sed -e '/^constant arm/i tunable mass = 1.2 kg\
tunable about_x = 12 g*m^2\
tunable about_y = 12.5 g*m^2\
tunable about_z = 21 g*m^2\
tunable lag = 50 ms\
tunable face = 500 cm^2' -e 's/^constant thrust/tunable thrust/' -e 's/    mass 1.2 kg/    mass mass/' \
    -e 's/inertia (12, 12.5, 21; 0.1, 0.2, -0.1) g.*/inertia (about_x, about_y, about_z; 0.1 g*m^2, 0.2 g*m^2, -0.1 g*m^2)/' \
    -e 's/lag 50 ms/lag lag/' -e 's/area 500 cm^2/area face/' models/quadrotor_sih.scene >"$out/quadrotor_sih.scene"
[ "$(grep -c '^tunable ' "$out/quadrotor_sih.scene")" = 7 ]
result $? 'the quadrotor with effects has seven tunables'
cp models/cart_pole.scene "$out"
project
within cart_pole
stated core/README.md "\`cart_pole\` takes $step instructions, with constants $constant."
result $? 'as core/README.md says'
within quadrotor_sih
within quadrotor
known=$step
sed -i '/^step/a at 50 ms set mass = 1.5 kg' "$out/quadrotor.scene"
run_of tunable quadrotor
changes=$(sed -n 's/^restart_execution \([0-9]*\) .*/\1/p' "$out/output")
[ "$step" = "$known" ] && printed restarts 1 && [ "$changes" -gt "$step" ] && [ "$changes" -lt $((step + 100)) ]
expect $? "quadrotor: the step of a change has $changes instructions, all others $step"
stated core/README.md "takes $step instructions of a step on the Cortex-M4F, with constants $constant; the step after a change takes $changes, and the checks of the tunables $beside in each tick"
result $? 'as core/README.md says'
finish
