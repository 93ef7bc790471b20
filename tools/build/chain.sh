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
awk -v n="$1" -v kind="$2" 'BEGIN {
    print "# A " kind " chain of uniform rods: " n ".\n\ngravity (0, -9.81, 0) m/s^2\nstep 1 ms\nmethod rk4\n"
    print "constant radius = 10 mm\nconstant long = 1 kg * radius^2 / 2\nconstant across = 1 kg * ((1 m)^2 / 12 + radius^2 / 4)"
    for (i = 1; i <= n; i++) {
        print "\nbody rod" i " {\n    mass 1 kg\n    com (0, -0.5, 0) m\n    inertia (across, long, across)\n}\n"
        print "joint j" i " revolute {\n    parent " (i > 1 ? "rod" i - 1 " at (0, -1, 0) m" : "ground")
        print "    child rod" i "\n    axis " (kind == "spatial" && i % 2 == 0 ? "x" : "z")
        print "    start " (i == 1 ? 90 : 0) " deg\n}"
    }
    print "\noutput tip = position of rod" n " at (0, -1, 0) m\noutput energy = energy"
}'
