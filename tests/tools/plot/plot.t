#!/bin/sh
# make plot: a panel for every output, with the unit that isoc gives it, in svg and in png, for the models; the
# pictures, read back through their labels, show the rows of the trace, and nothing fast is lost when the points are
# made fewer.
. tests/host/test.sh
. tests/host/project.sh
. tests/host/picture.sh
begin check/plot
project
reads_picture
unoptimised

# texts FILE: the texts of a drawing, one on a line.
texts()
{
    grep -o '<text>.*</text>' "$1" | sed 's/<[^>]*>//g'
}

# trace_points DIRECTORY: writes all that its trace.svg may show into $out/points: every row of the trace, by panel and
# curve; and of each curve the least and the greatest into $out/extremes.
trace_points()
{
    : >"$out/points"
    awk -F , -v OFS='\t' -v points="$out/points" '
        function point(i,    text) {
            text = panel[i] OFS curve[i] OFS $1 OFS $i
            print text >points
            if (!(i in least) || $i + 0 < least[i]) { least[i] = $i + 0; least_at[i] = text }
            if (!(i in most) || $i + 0 > most[i]) { most[i] = $i + 0; most_at[i] = text }
        }
        FNR == 1 { files++ }
        FNR == 1 { for (i = 2; i <= NF; i++) column[$i] = i }
        files == 1 && FNR == 2 { for (i = 2; i <= NF; i++) unit[i] = $i == "" || $i == "1" ? "" : ", " $i }
        files == 2 && FNR == 1 {
            for (i = 2; i <= NF; i++) {
                stem = substr($i, 1, length($i) - 2)
                vector = (stem "_x") in column && (stem "_y") in column && (stem "_z") in column
                panel[i] = (vector ? stem : $i) unit[i] "|t, s"
                curve[i] = vector ? substr($i, length($i)) : ""
            }
        }
        files == 2 && FNR > 1 { for (i = 2; i <= NF; i++) point(i) }
        { columns = NF }
        END { for (i = 2; i <= columns; i++) print least_at[i] "\n" most_at[i] }' "$1/units.csv" "$1/trace.csv" >"$out/extremes"
}

# true_to DIRECTORY: whether its trace.svg shows rows of its trace, the least and the greatest of each column among
# them.
true_to()
{
    trace_points "$1"
    shows "$1/trace.svg" "$out/points" drawn "$out/extremes" covered
}

# drawn_in NAME: the last call drew NAME.png; $folder is where.
drawn_in()
{
    folder=
    while read -r line; do
        case $line in
        */"$1.png") folder=$out/project/${line%/*} ;;
        esac
    done <"$out/output"
    [ -s "$folder/$1.png" ]
}

# A second; of the squeezer, which has a hundred thousand rows in that, a tenth of it.
for scene in $(models any) models/oscillator.c tests/isoc/scene/units.scene; do
    name=${scene##*/}
    name=${name%%.*}
    seconds=1
    [ "$name" != squeezer ] || seconds=0.1
    call_alone host/float "build/host/float/$name" plot SCENE="$scene" SECONDS=$seconds && [ ! -s "$out/errors" ] && drawn_in trace
    expect $? "$name is drawn, and nothing is said against it"
    true_to "$folder"
    result $? "$name: a panel for every output with its unit, and in it what the trace has"
    [ ! -e "$folder/path.svg" ] || shows "$folder/path.svg"
    result $? "$name: no text of the path is cut off"
done

# The path, and the change of the energy.
folder=$out/project/build/host/float/double_pendulum
awk -F , -v OFS='\t' '
    FNR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
    FNR == 2 { start = $column["energy"] }
    {
        print "double_pendulum: rk4, step 1 ms, float|tip_x, m", "", $column["tip_x"], $column["tip_y"]
        print "|t, s", "", $1, $column["energy"] - start
    }' "$folder/trace.csv" >"$out/points"
shows "$folder/path.svg" "$out/points" drawn
result $? "double_pendulum: the path has the points of the trace"

# The execution times of a scene that asks for them, 40 of which a script makes long: the bins follow from the script.
{ cat models/pendulum.scene && echo histogram; } >"$out/timed.scene"
awk 'BEGIN { for (i = 1; i <= 40; i++) print "slow " 20 * i " " i * i "us" }' >"$out/script"
awk -v OFS='\t' '
    { bin = int($3 * 1000 / 31250); ticks[bin < 31 ? bin : 31]++ }
    END {
        ticks[0] += 1000 - NR
        for (i = 0; i < 32; i++) if (ticks[i] > 0) for (k = 0; k < 2; k++) {
            print "|execution of a step, us, to the end of the period; the last bin is open", "", (i + k) * 31.25, ticks[i]
        }
    }' "$out/script" >"$out/points"
call plot SCENE="$PWD/$out/timed.scene" SCRIPT="$PWD/$out/script" SECONDS=1 && drawn_in histogram
expect $? "a histogram of the execution times is drawn"
timed=$folder
shows "$timed/histogram.svg" "$out/points" all
result $? "it has the ticks of each bin: $(grep -c . "$out/points") corners"
sed '$d' "$out/points" | sed '5s/2$/3/' >"$out/others"
! cmp -s "$out/points" "$out/others" && ! shows "$timed/histogram.svg" "$out/others" all >"$out/found"
result $? "found: another height"
[ ! -e "$out/project/build/host/float/double_pendulum/histogram.svg" ]
result $? "there is none of a scene that does not ask for it"

# wrong WHAT SED...: the trace of the tree so changed is found not to be that of its picture.
tree=$out/project/build/host/float/tree
wrong()
{
    what=$1
    shift
    mkdir -p "$out/wrong"
    cp "$tree/trace.csv" "$tree/units.csv" "$out/wrong"
    sed "$@" "$tree/trace.svg" >"$out/wrong/trace.svg"
    ! true_to "$out/wrong" >/dev/null
    result $? "found: $what"
}
wrong "a wrong unit" 's/needle_rate, rad/needle_rate, m/'
wrong "another component" 's/>y</>z</'
wrong "a wrong label" 's/>0\.4</>0.5</'

texts "$tree/trace.svg" >"$out/texts"
for text in 'tree: rk4, step 0.5 ms, float' 'rail_position, m' 'rotor_turns' 'needle_rate, rad/s' 'hinge_acceleration, rad/s^2'; do
    grep -qxF "$text" "$out/texts"
    result $? "tree: $text"
done
call plot SCENE=models/tree.scene SECONDS=1 OUTPUTS=rail_position,needle_rate && texts "$tree/trace.svg" >"$out/texts" &&
    grep -qxF 'rail_position, m' "$out/texts" && grep -qxF 'needle_rate, rad/s' "$out/texts" && ! grep -q '^hinge' "$out/texts"
expect $? "OUTPUTS are drawn, and no others"
! call plot SCENE=models/tree.scene SECONDS=1 OUTPUTS=rail_position,rail && grep -q "plot: no output is called 'rail'" "$out/errors"
expect $? "told: an output that is not there"
[ ! -e "$out/project/build/host/float/oscillator/path.svg" ]
result $? "no path without a point"

# The unit of every kind of output, of what turns and of what slides.
sed -n '/OF_EFFECT/d; s/.*ROW(QUANTITY_[A-Z_]*, "\([a-z_][a-z_]*\)".*/\1/p' tools/isoc/scene/quantities.h | sort -u >"$out/kinds"
sed -n 's/^output [a-z_]* = \([a-z_]*\).*/\1/p' tests/isoc/scene/units.scene | sort -u | cmp -s - "$out/kinds" && [ -s "$out/kinds" ]
result $? "tests/isoc/scene/units.scene has every kind of output"
units='t s
position_of_a_slide m
position_of_a_hinge rad
point_x m
point_y m
point_z m
point_along m
speed_of_a_slide m/s
speed_of_a_hinge rad/s
acceleration_of_a_slide m/s^2
acceleration_of_a_hinge rad/s^2
velocity_x m/s
velocity_y m/s
velocity_z m/s
turns 1
orientation_w 1
orientation_x 1
orientation_y 1
orientation_z 1
spin_x rad/s
spin_y rad/s
spin_z rad/s
x_axis_x 1
x_axis_y 1
x_axis_z 1
y_axis 1
z_axis 1
specific_force_x m/s^2
specific_force_y m/s^2
specific_force_z m/s^2
inertia kg*m^2
force_x N
force_y N
force_z N
force_along N
moment_x N*m
moment_y N*m
moment_z N*m
effort_of_a_gear_on_a_slide N
effort_of_a_gear_on_a_hinge N*m
effort_of_a_motion_of_a_hinge N*m
effort_of_a_motion_of_a_slide N
energy J
power W
balance W
local_error mixed
residual mixed
violation m or rad
violation_rate m/s or rad/s
violation_acceleration m/s^2 or rad/s^2'
printf '%s\n' "$units" >"$out/units"
awk -F , 'NR == 1 { columns = split($0, name) } NR == 2 { for (i = 1; i <= columns; i++) print name[i], $i }' \
    "$out/project/build/host/float/units/units.csv" | cmp -s - "$out/units"
result $? "every kind of output has its unit"
[ "$(cat "$out/project/build/host/float/oscillator/units.csv")" = "$(printf 't,position,speed,energy\ns,m,m/s,J')" ]
result $? "so have those of a plant in C"

# A signal that is 0 but for one row of 10,000: its height is in the drawing.
mkdir -p "$out/spike"
printf 'scene spike\nmethod rk4\nstep 0.001\nreal float\n' >"$out/spike/summary.txt"
printf 't,a\ns,\n' >"$out/spike/units.csv"
awk 'BEGIN { print "t,a"; for (i = 1; i <= 10000; i++) print i / 1000 "," (i == 4567 ? 7.25 : 0) }' >"$out/spike/trace.csv"
sh tools/plot/picture.sh trace "$out/spike" >"$out/spike/trace.gnuplot"
grep -qx '4.567 7.25' "$out/spike/trace.gnuplot" && [ "$(grep -c '^[0-9.]* [-0-9.]*$' "$out/spike/trace.gnuplot")" -lt 1000 ]
result $? "a spike in one row of 10,000 is drawn, with less than 1000 points"

# A machine without gnuplot.
mkdir -p "$out/bin"
tools_in "$out/bin" cc gcc as ld make sh awk sed tr cut printf mkdir cat cmp cksum grep test ls basename dirname nproc flock realpath
! PATH=$PWD/$out/bin call plot && grep -q 'gnuplot is missing.*apt-get install gnuplot-nox' "$out/errors"
expect $? "without gnuplot: it is named, with how to install it"
finish
