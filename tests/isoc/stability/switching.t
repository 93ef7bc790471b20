#!/bin/sh
# Effects that switch faster than the step follows: what isoc says of them, and by how much a jump within a step is
# misplaced.
. tests/host/test.sh
begin switching
one_isoc
optimised -O1
seed=$(cksum <tests/isoc/stability/switching.py | cut -d ' ' -f 1)
echo "# seed $seed"

# told SCENE [OPTION...]: what isoc says on stderr is in $out/told. Returns isoc's status.
told()
{
    told_scene=$1
    shift
    isoc "$out/summary" "$out/told" "$told_scene" -o "$out" "$@"
}

# compared TOLD: whether this is what isoc has to say of the scene of the last family.
compared() { python3 tests/isoc/stability/switching.py "$seed" "$step" "$method" "$out/family.scene" "$1" 2>"$out/difference"; }

for method in rk4 ab4 heun euler; do
    for step in 100 7; do
        python3 tests/isoc/stability/switching.py "$seed" $step $method "$out/family.scene" && told "$out/family.scene" && compared "$out/told"
        result $? "$method, $step us: effects that switch are told, where half a step at a jump is more than 1 %"
        sed 's/^/# /' "$out/difference"
    done
done
sed '/warning/ { s//information/; :rest
    n; b rest
    }' "$out/told" >"$out/one_less" && ! compared "$out/one_less"
result $? 'control: one that is missing is noticed'
sed 's/jumps every [^ ]*/jumps every 30.1/' "$out/told" >"$out/other" && ! compared "$out/other"
result $? 'control: another number of steps is noticed'

# misplaced METHOD LEAST MOST: the largest time in steps; euler sees a jump at the next step, half a step late in the
# mean.
misplaced()
{
    told tests/isoc/stability/winding.scene --method "$1" --real double &&
        program winding tests/isoc/stability/winding.c "$out/plant.c" tests/host/report.c
    joined 'a winding that is switched' "$out/winding" "$2" "$3"
}
misplaced rk4 0.32 0.335
misplaced heun 0.48 0.505
misplaced ab4 0.48 0.52
misplaced euler 0.97 1.01
! "$out/winding" 0.3 0.5 >/dev/null
result $? 'control: a whole step is noticed'

# A motor with six-step commutation, of which the step follows 1 %, or does not.
told tests/isoc/stability/six_step.scene && grep -q "six_step.scene:36:8: warning: the effect 'motor' jumps every 29 steps of 0.05 ms .* here 3.4 % .* a step of 0.015 ms" "$out/told" &&
    stated tools/isoc/README.md "$(sed -n 's|^tests/isoc/stability/\(six_step.scene:36:8: \)|\1|p' "$out/told")"
result $? 'six-step commutation at 50 us is told, with its line and the step'
told tests/isoc/stability/six_step.scene --step 20us && grep -q "'motor' jumps every 71.4 steps" "$out/told"
result $? 'and at 20 us'
told tests/isoc/stability/six_step.scene --step 10us && [ ! -s "$out/told" ]
result $? 'and not at 10 us'

# Pulses of ten steps: one in a window, which has two jumps, is no frequent switching; two are.
for pulses in 1 2; do
    cat >"$out/pulse.scene" <<END
step 1 ms
body b { mass 1 kg; inertia (1e15, 1e15, 1e15) kg*m^2 }
joint shaft revolute { parent ground; child b; axis z; speed 100 rad/s }
effect pulse { joint along; value pulses; let n = floor((position of along - 5 rad) / 1 rad)
    effort on along = 1 mN*m * (n == 0 or n == 2 and pulses == 2) }
effect e pulse { along shaft; pulses $pulses }
output rate = speed of shaft
END
    told "$out/pulse.scene" && [ "$(grep -c "'e' jumps every" "$out/told")" -eq $((pulses - 1)) ]
    result $? "$pulses pulses in a window: told $((pulses - 1)) times"
done

faults=
for scene in $(grep -l '^ *effect ' models/*.scene); do
    told "$scene" && ! grep -q 'jumps every' "$out/told" || faults="$faults $scene"
done
[ -z "$faults" ]
result $? "no model switches so often:$faults"
finish
