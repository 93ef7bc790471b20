#!/bin/sh
# chain.sh N planar|spatial: writes the scene of a hanging chain of N uniform rods of 1 kg and 1 m, 20 mm thick. All
# joints of a planar chain turn about z; those of a spatial one about z and x in turn.
case $#:$1:$2 in
2:[1-9]*:planar | 2:[1-9]*:spatial) ;;
*)
    echo "usage: $0 N planar|spatial" >&2
    exit 2
    ;;
esac

# rod INDEX AXIS PARENT START: a rod and its joint, with indices as isoc has them.
rod()
{
    printf '    body rod%s { mass 1 kg; com (0, -0.5, 0) m; inertia (across, long, across) }\n' "$1"
    printf '    joint j%s revolute { parent %s; child rod%s; axis %s; start %s deg }\n' "$1" "$3" "$1" "$2" "$4"
}

[ "$2" = spatial ] && pair=x || pair=z
cat <<HEAD
# A $2 chain of uniform rods: $1.

gravity (0, -9.81, 0) m/s^2
step 1 ms
method rk4

constant radius = 10 mm
constant long = 1 kg * radius^2 / 2
constant across = 1 kg * ((1 m)^2 / 12 + radius^2 / 4)

$(rod 1 z ground 90)

repeat i from 1 to $((($1 - 1) / 2)) {
$(rod '[2 * i]' $pair 'rod[2 * i - 1] at (0, -1, 0) m' 0)
$(rod '[2 * i + 1]' z 'rod[2 * i] at (0, -1, 0) m' 0)
}
$([ $(($1 % 2)) -eq 1 ] || rod "$1" $pair "rod$(($1 - 1)) at (0, -1, 0) m" 0)

output tip = position of rod$1 at (0, -1, 0) m
output energy = energy
HEAD
