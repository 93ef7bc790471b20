#!/bin/sh
# A force that jumps in the middle of a run starts the history of a method anew: told as `restarts`, priced in the dearest
# step, and needed for the right motion. The plant is a cart of 1 kg on a spring of 100 N/m, pushed with 2 N from
# 0.501 s on: x = 2 N / k (1 - cos(w (t - 0.501 s))), w = 10 / s.
. tests/host/test.sh
. tests/host/project.sh
begin check/jumps
project

# cart JUMP: writes the scene; JUMP is what is said of jumps.
cart()
{
    cat >"$out/cart.scene" <<END
step 1 ms
checked yes
input push $1 = table(0 s: 0 N, 0.5 s: 0 N, 0.5005 s: 2 N)
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
output place = position of rail
output error = local_error
END
}

# push METHOD ARGUMENT...: runs the cart for a second in double.
push()
{
    method=$1
    shift
    call run SCENE="$(pwd)/$out/cart.scene" METHOD="$method" SECONDS=1 "$@"
}

# off: how far the last run ended from the exact place.
off()
{
    value state | awk '{ exact = 0.02 * (1 - cos(10 * 0.499)); e = $1 - exact; printf "%.3g", e < 0 ? -e : e }'
}

for method in ab4 abm4 abm4_pec abm4_pecece; do
    cart "jump 0.5 N"
    push $method REAL=double && [ "$(value restarts)" = 1 ]
    expect $? "$method starts anew once"
    with=$(off)
    cart ""
    push $method REAL=double && [ -z "$(value restarts)" ]
    expect $? "without a threshold nothing is a jump"
    without=$(off)
    # Weights 55, -59, 37, -9 over 24 on a slope that jumps in between add half a step of impulse too much, h F / 2 m =
    # 1e-3 m/s or 1e-4 m in place. With the history made anew what is left is the method's own: 251/720 (w h)^5 of the
    # amplitude of 0.02 m in each of 499 steps, 3.5e-10 m.
    awk -v with="$with" -v without="$without" 'BEGIN { exit !(with < 7e-10 && without > 5e-5) }'
    expect $? "$method: $with m off with a new history, $without m without"
done

cart "jump 0.5 N"
for method in ab4 bdf4 rosenbrock rk4; do
    push $method
    known=$(value hash)
    push $method TARGET=cortex-m4f && [ "$(value hash)" = "$known" ]
    expect $? "$method: a restart has the same bits on the Cortex-M4F"
done
push ab4 TARGET=cortex-m4f
set -- $(value instructions_per_step)
[ $# -eq 2 ] && [ "$2" -gt "$1" ]
expect $? "the dearest step has the restart in it: $*"

# Where nothing is kept there is nothing to start anew, and no code for it.
sed -i '/^checked/d; /local_error/d' "$out/cart.scene"
push rk4 && [ -z "$(value restarts)" ] && ! grep -q jumped "$out/project/build/host/float/cart/plant.c"
expect $? "rk4 without a check has no history"
finish
