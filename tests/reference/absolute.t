#!/bin/sh
# The same mechanism as a tree with one closure and in absolute coordinates, every body free and every joint a closure:
# one motion, to 1e-8 over 5 s (double, rk4, 0.1 ms, projection). The slider-crank turns at a tenth of its 150 rad/s,
# where the truncation of a step alone is more than that, and another one in other coordinates.
. tests/host/test.sh
begin reference_absolute
one_isoc
quick

# moved FILE SCENE OUTPUT...: what a scene's outputs do.
moved()
{
    file=$1
    text=$2
    shift 2
    sed -e 's/^stabilisation.*/stabilisation projection/' -e 's/-225 rad/-22.5 rad/' -e 's/\([ ,]\)150\()* rad\)/\115\2/' \
        -e 's/22\.95/2.295/' -e 's/-75) rad/-7.5) rad/' "$text" >"$out/$file.scene"
    isoc "$out/$file.summary" '' "$out/$file.scene" -o "$out/$file" --real double --step 100us &&
        program "$file.run" tests/reference/columns.c "$out/$file/plant.c" && "$out/$file.run" "$@" >"$out/$file.txt"
}

# apart FILE FILE: the largest difference of two columns of numbers.
apart()
{
    paste -d ' ' "$out/$1.txt" "$out/$2.txt" | awk '{
        for (i = 1; i <= NF / 2; i++) { d = $i - $(i + NF / 2); if (d < 0) d = -d; if (d > most) most = d }
    } END { if (NR != 500) exit 1; printf "%.2e\n", most }'
}

moved four_bar models/four_bar.scene coupler_point_x coupler_point_y &&
    moved absolute_four_bar tests/isoc/mechanism/absolute_four_bar.scene coupler_point_x coupler_point_y
result $? "four_bar: both are compiled and run"
moved slider_crank models/slider_crank.scene slider_position &&
    moved absolute_slider_crank tests/isoc/mechanism/absolute_slider_crank.scene slider_x
result $? "slider_crank: both are compiled and run"
for name in four_bar slider_crank; do
    far=$(apart $name absolute_$name) && awk -v far="$far" 'BEGIN { exit !(far <= 1e-8) }'
    result $? "$name: the points of both are $far m apart, at most 1e-8"
done

# Control: a crank of other mass, by a part in 10,000, moves otherwise.
sed 's/mass 38 g/mass 38.0038 g/' models/slider_crank.scene >"$out/heavier.text"
moved heavier "$out/heavier.text" slider_position && far=$(apart slider_crank heavier) &&
    awk -v far="$far" 'BEGIN { exit !(far > 1e-8) }'
result $? "control: a slider-crank that is heavier by 1e-4 is $far m apart"
finish
