#!/bin/sh
# A ball rolls on each of the six planes across a coordinate axis: on the side to which the normal points it is
# accepted, and its centre moves as its spin says; on the other side it is refused, two radii off.
. tests/host/test.sh
begin rolling

# ball AXIS PLACE SPIN: compiles a ball with this spin and centre on the plane across the axis; $said is what isoc says.
ball()
{
    cat >"$out/ball.scene" <<END
step 1 ms
body ball { mass 1 kg; inertia (1, 1, 1) g*m^2 }
joint air free { parent ground; child ball; start at $2 m rotate 0 deg about x; spin $3 rad/s }
close plane rolling { parent ground; child ball; axis $1; radius 0.1 m }
output place = position of ball
END
    said=$(build/isoc "$out/ball.scene" -o "$out" 2>&1)
}

# The normal n, the centre at 0.1 n, the spin w, and the component of the velocity w x 0.1 n that is not zero.
while read -r axis right wrong spin part speed; do
    ball "$axis" "$right" "$spin" && echo "$said" | grep -qx "assembled air_${part}_speed $speed m/s"
    result $? "$axis: the ball on the right side rolls with $speed m/s along $part"
    ! ball "$axis" "$wrong" "$spin" && echo "$said" | grep -q 'a gap of 0.2 m remains'
    result $? "$axis: the ball on the wrong side is refused"
done <<'END'
x (0.1,0,0) (-0.1,0,0) (0,2,0) z -0.2
-x (-0.1,0,0) (0.1,0,0) (0,2,0) z 0.2
y (0,0.1,0) (0,-0.1,0) (0,0,2) x -0.2
-y (0,-0.1,0) (0,0.1,0) (0,0,2) x 0.2
z (0,0,0.1) (0,0,-0.1) (2,0,0) y -0.2
-z (0,0,-0.1) (0,0,0.1) (2,0,0) y 0.2
END
finish
