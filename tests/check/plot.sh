#!/bin/sh
# make plot: a panel for every output with its unit, in svg and in png, for the models; nothing fast is lost when the
# points are made fewer.
. tests/host/test.sh
. tests/host/project.sh
begin check/plot
project

# texts FILE: the texts of a drawing, one on a line.
texts()
{
    grep -o '<text>.*</text>' "$1" | sed 's/<[^>]*>//g'
}

for scene in $(models any) models/oscillator.c; do
    name=$(basename "$scene" | sed 's/\..*//')
    folder=$out/project/build/host/float/$name
    call plot SCENE="$scene" SECONDS=1 && [ ! -s "$out/errors" ] && texts "$folder/trace.svg" >"$out/texts"
    expect $? "$name is drawn, and nothing is said against it"
    missing=
    for output in $(head -n 1 "$folder/trace.csv" | tr , '\n' | sed -n '2,$ { s/_[xyz]$//; p; }' | sort -u); do
        grep -Eq "^$output(, .*)?\$" "$out/texts" || missing="$missing $output"
    done
    [ -z "$missing" ] && [ -s "$folder/trace.png" ]
    expect $? "$name: every output has its panel, a point one for its three$missing"
done

texts "$out/project/build/host/float/tree/trace.svg" >"$out/texts"
for text in 'tree: rk4, step 0.5 ms, float' 'rail_position, m' 'hinge_angle, rad' 'rotor_turns, turns' \
    'needle_rate, rad/s' 'sensor_velocity, m/s' 'hinge_acceleration, rad/s^2' 'energy, J' 't, s'; do
    grep -qxF "$text" "$out/texts"
    result $? "tree: $text"
done
! grep -qxF 'needle_rate, m/s' "$out/texts"
result $? "found: a unit that is not there"
[ ! -e "$out/project/build/host/float/oscillator/path.svg" ]
result $? "no path without a point"

# A signal that is 0 but for one row of 10,000: its height is in the drawing.
printf 'scene spike\nmethod rk4\nstep 0.001\nreal float\n' >"$out/summary.txt"
awk 'BEGIN { print "t,a"; for (i = 1; i <= 10000; i++) print i / 1000 "," (i == 4567 ? 7.25 : 0) }' >"$out/spike.csv"
awk -v kind=trace -f tools/plot/plot.awk part=scene /dev/null part=run "$out/summary.txt" part=trace "$out/spike.csv" \
    >"$out/spike.gnuplot"
grep -qx '4.567 7.25' "$out/spike.gnuplot" && [ "$(grep -c '^[0-9.]* [-0-9.]*$' "$out/spike.gnuplot")" -lt 1000 ]
result $? "a spike in one row of 10,000 is drawn, with less than 1000 points"

# A machine without gnuplot.
mkdir -p "$out/bin"
for tool in cc gcc as ld make sh awk sed tr cut printf mkdir cat cmp cksum grep test ls basename dirname nproc; do
    path=$(command -v $tool) && [ -x "$path" ] && ln -sf "$path" "$out/bin/$tool"
done
! PATH=$PWD/$out/bin call plot && grep -q 'gnuplot is missing.*apt-get install gnuplot-nox' "$out/errors"
expect $? "without gnuplot: it is named, with how to install it"
finish
