#!/bin/sh
# A force that jumps in the middle of a run starts the history of a method anew, where its scene says what a jump is, or
# where steps are checked and their error tells of it: reported as `restarts`, measured as `restart_execution`, and
# needed for the right motion. The plant is a cart of 1 kg on a spring of 100 N/m, pushed with 2 N from 0.501 s on: x =
# 2 N / k (1 - cos(w (t - 0.501 s))), w = 10 / s.
. tests/host/test.sh
. tests/host/project.sh
begin check/jumps
project
unoptimised clang

# cart JUMP [STATEMENT...]: writes the scene; JUMP is what is said of jumps.
cart()
{
    jump=$1
    shift
    echo "step 1 ms
input push $jump = table(0 s: 0 N, 0.5 s: 0 N, 0.5005 s: 2 N)
body cart {
    mass 1 kg
}
joint rail prismatic {
    parent ground
    child cart
    axis x
    spring 100 N/m
    drive push
}
output place = position of rail" >"$out/cart.scene"
    printf '%s\n' "$@" >>"$out/cart.scene"
}

# push METHOD ARGUMENT...: runs the cart for a second in double.
push()
{
    method=$1
    shift
    isochron run "$PWD/$out/cart.scene" --method "$method" --seconds 1 "$@"
}

# off MOST: $off is how far the last run ended from the exact place; whether that is at most so far.
off()
{
    off=
    read_value state && off=$(awk -v place="${value%% *}" -v most="$1" 'BEGIN {
        e = place - 0.02 * (1 - cos(10 * 0.499))
        e = e < 0 ? -e : e
        printf "%.3g", e
        exit !(e <= most)
    }')
}

# With the history made anew what is left is the method's own: of ab4, the largest, 251/720 (w h)^5 of the amplitude of
# 0.02 m in each of 499 steps, 3.5e-10 m; of bdf4 it is 1/5.
near=7e-10
# Weights 55, -59, 37, -9 over 24 on a derivative that jumps in between add half a step of impulse too much, h F / 2 m =
# 1e-3 m/s or 1e-4 m in place.
far=5e-5

for method in ab4 abm4 abm4_pec abm4_pecece bdf4; do
    cart "jump 0.5 N"
    push "$method" --real double && printed restarts 1 && off $near
    expect $? "$method starts anew where it is told of the jump: $off m off"
    cart "" "checked yes"
    push "$method" --real double && printed restarts 1 && off $near
    expect $? "$method, checked, finds the jump: $off m off"
    cart ""
    push "$method" --real double && printed restarts ''
    expect $? "without either nothing is a jump"
    ! off $far && [ -n "$off" ]
    expect $? "control: $method, with a history from before, is $off m off"
done

# on_the_board METHOD NAME: the same bits there.
on_the_board()
{
    push "$1"
    read_value hash && known=$value
    push "$1" --target cortex-m4f && printed hash "$known" && printed restarts 1
    expect $? "$2: a restart has the same bits on the Cortex-M4F"
}

# dearest WHAT: the last run took more for the step with the restart, and for all others one number of instructions.
dearest()
{
    read_value instructions_per_step && steps=$value
    read_value restart_execution && restart=${value% instructions}
    [ "$restart" -gt "$steps" ]
    expect $? "the dearest step has $1 in it: $restart instructions; all others: $steps"
}

cart "jump 0.5 N" "checked yes"
for method in rosenbrock rk4; do
    on_the_board $method "$method, checked"
done
cart "jump 0.5 N"
for method in ab4 bdf4; do
    on_the_board $method $method
done
dearest "the restart"
cart "" "checked yes"
for method in abm4 bdf4 ab4; do
    on_the_board $method "$method that finds the jump"
done
dearest "the restart and a second step"

# What jumps by as much in every tick costs no restart in every tick: the force turns about from tick to tick.
cart "" "checked yes"
sed -i 's/ = table.*/ = 2 N * sin(500 Hz, 90 deg)/' "$out/cart.scene"
push ab4 --real double && printed restarts ''
expect $? "a force that turns about in every tick is no jump"

# Where nothing is kept there is nothing to start anew, and no code for it.
cart "jump 0.5 N"
push rk4 && printed restarts '' && printed restart_execution '' &&
    read_value trace && ! grep -q discontinuity "$out/project/${value%/*}/plant.c"
expect $? "rk4 without a check has no history"
finish
