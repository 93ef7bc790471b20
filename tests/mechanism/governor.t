#!/bin/sh
# The stiff flyball governor (IFToMM benchmark A05) with the implicit methods and projection, 5 s in steps of 1 ms, where
# an explicit method needs steps below 0.34 ms. With springs and dampers as given, against the solution of its equations in
# two coordinates (Radau IIA, 58 digits); with 10,000 times of both, which leaves the legs rigid to 1e-8 m, the methods
# against each other.
. tests/host/test.sh
begin mechanism/governor

# The springs and dampers of the legs, one as an effect, the other between points.
struts='effect strut { joint leg; value k N/m; value c N*s/m
    effort on leg = -k * (position of leg - 0.5 m) - c * speed of leg
}
effect strut1 strut { leg leg1; k stiffness; c damper }
spring strut2 { between eye2 and slider at (-0.05, 0, 0) m; stiffness stiffness; damping damper; length 0.5 m }'

# governed METHOD TIMES [STRUTS]: arm and slider at 1 s and at 5 s, of springs and dampers that are so many times as
# stiff; or of these in their place.
governed()
{
    name=$1.$2${3:+.struts}
    {
        sed -e "s|^\\(constant stiffness =\\).*|\\1 8e5 N/m * $2|; s|^\\(constant damper =\\).*|\\1 4e4 N*s/m * $2|" \
            ${3:+-e '/^    spring /d' -e '/^    damping /d'} tests/order/governor.scene
        echo "${3-}"
    } >"$out/$name.scene"
    build/isoc "$out/$name.scene" -o "$out/$name" --real double --method "$1" --step 1ms >"$out/$name.summary" &&
        EXTRA=-O1 program "$name.run" tests/reference/columns.c "$out/$name/plant.c" &&
        "$out/$name.run" beta s | sed -n '10p; 50p' >"$out/$name.txt"
    result $? "$1 with $2 times the stiffness${3:+, by an effect and between points}: compiled, and run to the end"
}

# apart FILE FILE: the largest difference of two lists of numbers, four of each.
apart()
{
    paste -d ' ' "$1" "$2" | awk '{
        for (i = 1; i <= NF / 2; i++) { d = $i - $(i + NF / 2); if (d < 0) d = -d; if (d > most) most = d; n++ }
    } END { if (n != 4) exit 1; printf "%.1e\n", most }'
}

# within WHAT FILE FILE LIMIT
within()
{
    off=$(apart "$2" "$3") && awk -v off="$off" -v limit="$4" 'BEGIN { exit !(off ~ /^[0-9]/ && off <= limit) }'
    result $? "$1: rad and m off by $off, at most $4"
}

printf '%s\n' '0.5218333016255462 0.5014209223795677' '0.4828745765869398 0.5355631037216435' >"$out/reference"
for method in rosenbrock bdf4; do
    governed $method 1
    governed $method 1e4
done
# The motion that is not damped has 7.35 rad/s: order three leaves at most (7.35 rad/s 1 ms)^3 of it.
within "rosenbrock" "$out/rosenbrock.1.txt" "$out/reference" 4e-7
within "bdf4" "$out/bdf4.1.txt" "$out/reference" 4e-7
within "10,000 times as stiff" "$out/rosenbrock.1e4.txt" "$out/bdf4.1e4.txt" 4e-7

governed rosenbrock 1e4 "$struts"
within "an effect and a spring between points" "$out/rosenbrock.1e4.struts.txt" "$out/rosenbrock.1e4.txt" 1e-9

off=$(apart "$out/bdf4.1e4.txt" "$out/reference") && awk -v off="$off" 'BEGIN { exit !(off > 1e-5) }'
result $? "control: that is another motion, by $off"
finish
