#!/bin/sh
# Springs and dampers between points, against closed forms and against a spring of a joint.
. tests/host/test.sh
begin language_springs
one_isoc

# compiled NAME [OPTION...]: the program of the scene on stdin, or, without one there, of the last one of that name.
compiled()
{
    name=$1
    shift
    input=
    [ -t 0 ] || input=$(cat)
    [ -z "$input" ] || printf '%s\n' "$input" >"$out/$name.scene"
    isoc "$out/$name.summary" '' "$out/$name.scene" -o "$out/$name" --real "$real" "$@" &&
        EXTRA=-O0 program "$name.run" tests/isoc/scene/language/last.c "$out/$name/plant.c"
}

# near LIMIT GOT WANT: whether each number of two lists is, but for so much; what is largest is in $told.
near()
{
    told=$(awk -v limit="$1" -v all_got="$2" -v all_want="$3" '
        BEGIN {
            n = split(all_got, got)
            m = split(all_want, want)
            for (i = 1; i <= n; i++) { d = got[i] - want[i]; d = d < 0 ? -d : d; if (!(d <= worst)) worst = d }
            printf "%.1e", worst; exit !(n > 0 && n == m && worst <= limit) }')
}

# The damped oscillator through the point where its spring has no length: e^-at (cos wt + a/w sin wt) with a = c / 2m
# and w^2 = k/m - a^2. rk4 is off by (w h)^5 / 120 in a step, 5000 of which make 1.4e-12; the rounding of as many is
# less.
compiled oscillator <<'END'
step 1 ms
body bob { mass 2 kg; inertia (1, 1, 1) g*m^2 }
joint afloat free { parent ground; child bob; start at (0, 0.6, 0.8) m }
spring bungee { between ground and bob; stiffness 8 N/m; damping 0.4 N*s/m; length 0 m }
output place = position of bob
output pull = effort of bungee
END
result $? "an oscillator builds"
want=$(awk 'BEGIN {
    a = 0.1; w = sqrt(4 - a * a); t = 5; e = exp(-a * t)
    x = e * (cos(w * t) + a / w * sin(w * t)); v = -e * sin(w * t) * (w + a * a / w)
    printf "%.15g %.15g %.15g", 0.6 * x, 0.8 * x, (x < 0 ? -1 : 1) * (8 * x + 0.4 * v) }')
near 1e-11 "$("$out/oscillator.run" 5000 place_y place_z pull)" "$want"
result $? "an oscillator through the zero of its spring's length: off by $told"

# The ends meet exactly: x is -0.5, 0, 0.5. Nothing overflows, in float neither, nor in the Jacobian of a stiff method.
for case in float:euler float:rosenbrock double:bdf4; do
    real ${case%:*}
    compiled meeting --method "${case#*:}" <<'END'
step 0.5 s
body bob { mass 1 kg }
joint slide prismatic { parent ground; child bob; axis x; start -0.5 m; speed 1 m/s }
spring gap { between ground and bob; stiffness 1e-9 N/m; damping 1e-9 N*s/m; length 0 m }
output x = position of slide
output pull = effort of gap
END
    near 1e-6 "$("$out/meeting.run" 1 x pull) $("$out/meeting.run" 2 x)" '0 0 0.5'
    result $? "ends that meet, ${case#*:} in ${case%:*}: off by $told"
done
real double

# Between two bodies, on a line, a spring is that of a joint: but for the rounding of 5000 steps, 2.2e-16 each.
compiled old <<'END'
step 1 ms
tunable k = 40 N/m
body one { mass 1 kg }
body two { mass 2 kg }
joint first prismatic { parent ground; child one; axis x; start 100 mm; speed 1 m/s }
joint second prismatic { parent one; child two; axis x; start 0.4 m; spring k rest 0.3 m; damping 0.5 N*s/m }
output energy = energy
output a = position of first
output b = speed of second
END
sed -e 's/ spring k rest 0.3 m; damping 0.5 N\*s\/m / /' \
    -e '$ a spring link { between one at (-1, 0, 0) m and two at (-1, 0, 0) m; stiffness k; damping 0.5 N*s/m; length 0.3 m }' \
    "$out/old.scene" | compiled new
near 1e-11 "$("$out/new.run" 5000 energy a b)" "$("$out/old.run" 5000 energy a b)"
result $? "a spring between two bodies is that of the joint between them: off by $told"

# Statics by hand: r = (3, -4, 0) m, d = 5 m, d' = 0.6 m/s, T = 10 N/m 1 m + 5 N*s/m d' = 13 N along (0.6, -0.8, 0).
compiled statics <<'END'
step 1 ms
body post { mass 1 kg }
body bob { mass 2 kg }
frame top { on post at (0, 4, 0) m }
joint root fixed { parent ground; child post }
joint slide prismatic { parent ground; child bob; axis x; start 3 m; speed 1 m/s }
spring link { between top and bob; stiffness 10 N/m; damping 5 N*s/m; length 4 m }
output pull = effort of link
output a = acceleration of slide
output on_post = force of root
output turning = moment of root
output on_bob = force of slide
END
near 1e-13 "$("$out/statics.run" 0 pull a on_post_x on_post_y turning_z on_bob_x on_bob_y)" '13 -3.9 -7.8 10.4 31.2 0 -10.4'
result $? "tension, acceleration and reactions by hand: off by $told"

# In space, between bodies on a ball and on a universal joint, with a gap that a loop holds: the energy of an undamped
# one is kept, and each method has its order, so its Jacobian is right.
scene='gravity (0, 0, -9.81) m/s^2; step 2 ms; stabilisation projection
body arm { mass 1 kg; com (0, 0, -0.3) m; inertia (20, 30, 10) g*m^2 }
body fore { mass 2 kg; com (0, 0.1, -0.3) m; inertia (30, 20, 10) g*m^2 }
body load { mass 1.5 kg; inertia (10, 20, 30) g*m^2 }
joint ball spherical { parent ground; child arm; start rotate 30 deg about x rotate 20 deg about y; spin (1, 0, 2) rad/s }
joint elbow universal { parent arm at (0, 0, -0.6) m; child fore; axis x; second y; start rotate 40 deg rotate 10 deg }
joint swing revolute { parent ground at (1, 0, -1) m; child load at (0, 0, 0.4) m; axis y; start 20 deg }
spring inner { between ground at (0.5, 0, 0) m and fore at (0, 0, -0.6) m; stiffness k; length 0.5 m }
spring outer { between load at (0.1, 0, 0) m and arm at (0, 0.1, -0.6) m; stiffness 2 * k; damping c; length 0.4 m }
output energy = energy
output place = position of fore
output angle = position of swing'
for step in 2ms:250 1ms:500; do
    printf 'constant k = 60 N/m; constant c = 0 N*s/m; %s\n' "$scene" | compiled tangle --step ${step%:*}
    echo "$("$out/tangle.run" 0 energy) $("$out/tangle.run" ${step#*:} energy)"
done >"$out/energies"
told=$(awk '{ off[NR] = $2 - $1 } END { r = off[1] / off[2]; printf "%.1e J, %.1f times less", off[1], r; exit !(r > 16) }' "$out/energies")
result $? "the energy of a mechanism with springs changes with the step's fourth power at least: $told with half a step"
printf 'tunable k = 60 N/m; tunable c = 3 N*s/m; %s\n' "$scene" >"$out/tangle.scene"
for case in rk4:16 rosenbrock:8 bdf4:16; do
    for step in 1ms:200 500us:400 250us:800 125us:1600; do
        compiled tangle --method ${case%:*} --step ${step%:*} </dev/null && "$out/tangle.run" ${step#*:} place_x place_y place_z angle
    done >"$out/orders"
    told=$(awk -v ratio="${case#*:}" '
        { for (i = 1; i <= 4; i++) at[NR, i] = $i }
        END {
            for (n = 1; n < NR; n++) for (i = 1; i <= 4; i++) off[n] += (at[n, i] - at[n + 1, i]) ^ 2
            printf "%.1f and %.1f", sqrt(off[1] / off[2]), sqrt(off[2] / off[3])
            r = sqrt(off[2] / off[3]); exit !(NR == 4 && r > ratio / 1.5 && r < ratio * 1.5) }' "$out/orders")
    result $? "${case%:*}: half the step makes the difference to it smaller by $told, where its order asks for ${case#*:}"
done

# The root has the same bits on the board.
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES SCENE METHOD STEP SECONDS TARGET REAL SCRIPT V CFLAGS
for target in host cortex-m4f; do
    tools/isochron run tests/isoc/scene/frames.scene --target $target --seconds 1 >"$out/$target" 2>"$out/errors" || cat "$out/errors"
    sed -n 's/^hash //p' "$out/$target"
done >"$out/hashes"
[ "$(wc -l <"$out/hashes")" -eq 2 ] && [ "$(uniq "$out/hashes" | wc -l)" -eq 1 ] && grep -q '^instructions_per_step' "$out/cortex-m4f"
result $? "springs and frames have one hash on the host and on the board, and one count"
finish
