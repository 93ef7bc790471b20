#!/bin/sh
# What isoc says of stability: eigenvalues of the Jacobian, and warnings where the method does not hold them.
. tests/host/test.sh
begin modes
one_isoc
optimised -O0

program eigenvalues tests/isoc/stability/eigenvalues.c tools/isoc/base/eigenvalues.c tools/isoc/base/arena.c tests/host/report.c
joined eigenvalues "$out/eigenvalues"

# told SCENE [OPTION...]: compiles a scene; what isoc says on stderr is in $out/told, and in $said without ends of
# lines. Returns isoc's status.
told()
{
    told_scene=$1
    shift
    isoc "$out/summary" "$out/told" "$told_scene" -o "$out" "$@"
    told_status=$?
    said=
    while IFS= read -r told_line; do
        said="$said$told_line "
    done <"$out/told"
    return $told_status
}

# is_silent, warns PATTERN: of the last scene.
is_silent() { [ ! -s "$out/told" ]; }
warns() { grep -q "warning: $1" "$out/told"; }

# shown_until TEXT: whether tools/isoc/README.md shows what was said, as far as this text.
shown_until()
{
    shown=${said#"$out/"}
    stated tools/isoc/README.md "${shown%%"$1"*}$1"
}

cat >"$out/spring.scene" <<'END'
method rk4
step 1 ms
constant frequency = 1 kHz
effect elastic { joint along; value stiffness N/m; effort on along = -stiffness * position of along }
body block { mass 1 kg }
joint slide prismatic { parent ground; child block; axis x; start 1 mm }
effect strap elastic { along slide; stiffness 1 kg * frequency^2 }
effect bearing friction { along slide; sliding 1 mN; creep 1 m/s }
output x = position of slide
END

# holds: of the last scene, that nothing is too fast; what swings may still grow slowly.
holds()
{
    case $said in
    *'too fast'*) return 1 ;;
    esac
}

# limit METHOD BELOW ABOVE: held at this frequency of the undamped spring, and not 2 % above.
limit()
{
    told "$out/spring.scene" --method "$1" --set "frequency = $2 Hz" && holds &&
        told "$out/spring.scene" --method "$1" --set "frequency = $3 Hz" &&
        warns "the effect 'strap' is too fast for $1 with a step of 1 ms: the Jacobian at the start has the eigenvalue .* +- $3 i 1/s"
    result $? "$1: a spring of $2 rad/s is held, one of $3 is warned of"
}
limit rk4 2800 2856           # sqrt(8)
limit semi_implicit 1980 2020 # 2
# Undamped oscillations grow with euler however small the step is; sqrt(1 + z^2) = exp(z / 10) + 1e-3 at 0.214.
limit euler 212 216
told "$out/spring.scene" --method rosenbrock --set 'frequency = 1 MHz' && is_silent
result $? 'rosenbrock: no spring is too fast'

# What grows slowly is told with the time in which it grows by e, and a run grows by that: undamped springs of frequency
# times step from 0.02 to 0.8, where the method is not yet too fast.
program drift.o -c tests/isoc/stability/drift.c && program report.o -c tests/host/report.c
result $? 'the runs build'

# time_of: $time is the last time that is told.
time_of()
{
    case $said in
    *'grows by e in '*' s '*)
        time=${said##*grows by e in }
        time=${time%% *}
        ;;
    *) time= ;;
    esac
}

# drifts METHOD FREQUENCY: with a step of 4 ms. Without a warning it takes longer than ten seconds.
drifts()
{
    told "$out/spring.scene" --method "$1" --set "frequency = $2 Hz" --step 4ms --real double
    time_of
    [ -n "$time" ] && warns "the oscillation of $2 rad/s by the effect 'strap' grows .* s with $1 and a step of 4 ms" &&
        program drift "$out/plant.c" "$out/drift.o" "$out/report.o"
    result $? "$1: what swings at $2 rad/s grows by e in $time s, says isoc"
    joined "$1 at $2 rad/s" "$out/drift" "$time" "$2"
}
drifts euler 8
drifts euler 40
drifts heun 60
drifts heun 140
drifts abm4 105
drifts abm4 160
drifts abm4_pecece 180
drifts bdf4 83
drifts bdf4 190
! "$out/drift" "$(awk -v t="$time" 'BEGIN { print 1.03 * t }')" 190 >/dev/null
result $? 'control: a time that is 3 % off is noticed'
silent=0
for method in rk4 ab4 semi_implicit rosenbrock; do
    told "$out/spring.scene" --method $method --set "frequency = 80 Hz" --step 4ms && is_silent || silent=1
done
told "$out/spring.scene" --method euler --set "frequency = 6.8 Hz" --step 4ms && is_silent || silent=1
[ $silent -eq 0 ]
result $? 'what a method does not let grow, or by e in more than ten seconds, is not told'
told "$out/spring.scene" --method heun --set "frequency = 100 Hz" --step 4ms && warns '.* or rk4, ab4, semi_implicit, abm4_pecece, rosenbrock$'
result $? 'the methods are told with which it does not grow'
told "$out/spring.scene" --method euler --set "frequency = 100 Hz" && warns '.* grows by e' && shown_until ' semi_implicit,'
result $? 'tools/isoc/README.md shows what is told'

# A winding of R / L = 400/s: ab4 holds 0.3 a step.
cat >"$out/motor.scene" <<'END'
step 1 ms
method ab4
input volts V smooth
body rotor { mass 1 kg; inertia (1, 1, 1) g*m^2 }
joint shaft revolute { parent ground; child rotor; axis z; damping 0.01 N*m*s/rad }
effect bearing friction { along shaft; sliding 10 mN*m; creep 10 rad/s }
constant ohm = 8 Ohm
effect drive dc_motor { shaft shaft; supply volts; resistance ohm; inductance 20 mH; constant 1 mN*m/A }
output current = drive.current
END
told "$out/motor.scene" &&
    warns "the effect 'drive' is too fast for ab4 .* the eigenvalue -400 1/s; .*euler 5 ms, heun 5 ms, rk4 6.9[67] ms, ab4 0.75. ms, .*bdf4 any, rosenbrock any" &&
    grep -q 'motor.scene:8:8: warning' "$out/told" && shown_until ' 0.751 ms,'
result $? 'ab4: the winding of a motor is told, with its line and the steps of all methods'
for method in bdf4 rosenbrock euler rk4; do
    told "$out/motor.scene" --method $method && is_silent
    result $? "$method: holds the winding"
done
told "$out/motor.scene" --set 'ohm = 5.94 Ohm' && is_silent && told "$out/motor.scene" --set 'ohm = 6.06 Ohm' && warns "the effect 'drive'"
result $? 'ab4: the limit is within 1 %'

# Friction is steepest at rest; what is too fast is told one after the other.
sed 's/creep 1 m/creep 0.1 um/; s/start 1 mm/start 1 mm speed 1 m\/s/' "$out/spring.scene" >"$out/moving.scene"
told "$out/moving.scene" && warns "the effect 'bearing' is too fast for rk4 .* at rest has the eigenvalue -"
result $? 'friction with a small creep is told at rest, also where the start moves'
sed 's/creep 1 m/creep 0.1 um/' "$out/spring.scene" >"$out/both.scene"
told "$out/both.scene" --set 'frequency = 200 kHz' && warns "the effect 'bearing'" && warns "the effect 'strap'" &&
    [ "$(grep -c warning: "$out/told")" -eq 2 ]
result $? 'two effects that are too fast are both told'

# What grows by itself is no fault of the method: an inverted pendulum, whose other mode, -0.157 a step, all methods
# hold.
cat >"$out/inverted.scene" <<'END'
gravity (0, -9.81, 0) m/s^2
step 50 ms
body bob { mass 1 kg; com (0, 1, 0) m }
joint pivot revolute { parent ground; child bob; axis z; start 0.01 rad }
output angle = position of pivot
END
silent=0
for method in euler heun rk4 semi_implicit ab4 abm4 abm4_pec abm4_pecece bdf4 rosenbrock; do
    told "$out/inverted.scene" --method $method && is_silent || silent=1
done
[ $silent -eq 0 ]
result $? 'no method is blamed for an inverted pendulum'

sed '/^stabilisation/d' models/four_bar.scene >"$out/loop.scene"
echo 'stabilisation baumgarte { alpha 3 kHz; beta 3 kHz }' >>"$out/loop.scene"
told "$out/loop.scene" --method rk4 && warns "the stabilisation of the closure 'rocker_pin'"
result $? 'a stabilisation that is too fast is told'

# A root has no slope at zero.
cat >"$out/root.scene" <<'END'
method rk4
step 1 ms
effect orifice { joint along; effort on along = -1 N * sign(position of along) * sqrt(abs(position of along / 1 m)) }
body block { mass 1 kg }
joint slide prismatic { parent ground; child block; axis x }
effect hole orifice { along slide }
output x = position of slide
END
told "$out/root.scene" && is_silent && ! told "$out/root.scene" --method bdf4 && [ ! -s "$out/summary" ] &&
    grep -q "root.scene:5:7: error: the Jacobian at the start is not finite: .* by 'slide' there, and bdf4 needs it" "$out/told"
result $? 'an implicit method is refused where the Jacobian is not finite'

# What is stiff in contact alone is told wherever the scene starts: k m of 8 / h^2 is held by rk4, with two equal
# inertias that meet half of it; with the damping k c, c 0.0091 h, that an impact has at its begin it is 8.146 / h^2.
cat >"$out/stop.scene" <<'END'
method rk4
step 1 ms
body block { mass 1 kg }
joint slide prismatic { parent ground; child block; axis x }
effect ends stop { along slide; lower -0.1 m; upper 0.1 m; impact 1 m/s; stiffness hard }
output x = position of slide
END
cat >"$out/backlash.scene" <<'END'
method rk4
step 1 ms
body a { mass 1 kg; inertia (1, 1, 1) kg*m^2 }
body b { mass 1 kg; inertia (1, 1, 1) kg*m^2 }
joint one revolute { parent ground; child a; axis x }
joint two revolute { parent ground; child b; axis x }
effect ends backlash { motor one; load two; gap 0.2 rad; impact 1 rad/s; stiffness hard / 2 }
output x = position of one
END
cat >"$out/contact.scene" <<'END'
gravity (0, 0, -9.81) m/s^2
method rk4
step 1 ms
body ball { mass 1 kg; inertia (1, 1, 1) g*m^2 }
joint air free { parent ground; child ball; start at (0, 0, 1) m rotate 20 deg about x }
effect ends contact { ball ball; radius 5 cm; load 1 kg; impact 1 m/s; friction 0.3; stiffness hard; grip 100 N*s/m }
output x = position of ball
END
cat >"$out/limit.scene" <<'END'
method rk4
step 1 ms
effect limiter { joint along; value top m/s; value strength N*s/m
    effort on along = -strength * (max(speed of along - top, 0) - max(-top - speed of along, 0)) }
body block { mass 1 kg }
joint slide prismatic { parent ground; child block; axis x }
effect ends limiter { along slide; top 2 m/s; strength hard * 1 s * 2.785 / 8 / 1000 }
output x = position of slide
END
# contact NAME UNIT LIMIT: silent 1 % below the limit, told 1 % above, with the place of the use.
contact()
{
    for part in 0.99 1.01; do
        sed "2aconstant hard = $3 * $part M$2" "$out/$1.scene" >"$out/$1.$part.scene"
    done
    told "$out/$1.0.99.scene" && is_silent && told "$out/$1.1.01.scene" &&
        warns "the effect 'ends' is too fast for rk4 with a step of 1 ms: the Jacobian where 'ends' is steepest has the eigenvalue" &&
        grep -q "scene:$(($(grep -n '^effect ends' "$out/$1.scene" | cut -d : -f 1) + 1)):8: warning" "$out/told"
    result $? "$1: what is too stiff in contact alone is told, and what is held is not"
}
contact stop N/m 8.146
contact backlash N*m/rad 8.146
contact contact N/m 8.146
contact limit N/m 8
sed 's/; stiffness hard[^;}]*//' "$out/stop.scene" >"$out/default.scene"
silent=0
for method in euler heun rk4 semi_implicit ab4 abm4 abm4_pec abm4_pecece bdf4 rosenbrock; do
    told "$out/default.scene" --method $method && is_silent || silent=1
done
[ $silent -eq 0 ]
result $? 'a stop as stiff as the step allows is held by every method'

# The models with their own methods and three others.
for scene in models/*.scene; do
    { told "$scene" --inputs smooth && is_silent; } || echo "$scene"
    for method in rk4 semi_implicit bdf4; do
        { told "$scene" --method $method --inputs smooth && holds; } || echo "$scene $method"
    done
done >"$out/blamed"
sed 's/^/# /' "$out/blamed"
[ ! -s "$out/blamed" ]
result $? 'their own methods, rk4, semi_implicit and bdf4 hold all models'

# The program leaves its range after 237 ticks.
told models/arm6.scene --method abm4_pec --inputs smooth && warns "the spring and damping of the joint 'pitch'"
result $? 'control: abm4_pec does not hold the arm'
finish
