#!/bin/sh
# Each quantity of tools/isoc/scene/quantities.h: as an output, in a formula, in the next of a memory, and in an effort,
# which has it or is refused with the reason.
. tests/host/test.sh
begin language/quantities
one_isoc

# The rows: kind, formula of one number, unit, what becomes of an effort by it.
cat >"$out/rows" <<'ROWS'
POSITION|position of pivot|rad|taken
POINT|position of bob at (1, 2, 3) m along x|m|taken
SPEED|speed of pivot|rad/s|taken
ACCELERATION|acceleration of pivot|rad/s^2|loop
VELOCITY|velocity of bob at (1, 2, 3) m in body along y|m/s|taken
TURNS|turns of pivot|1|late
ORIENTATION|orientation of bob along z|1|taken
SPIN|spin of bob in ground along z|rad/s|taken
X_AXIS|x_axis of bob along x|1|taken
Y_AXIS|y_axis of bob along x|1|taken
Z_AXIS|z_axis of slider along z|1|taken
SPECIFIC_FORCE|specific_force of bob at (1, 2, 3) m along y|m/s^2|loop
INERTIA|inertia of pivot|kg*m^2|taken
INERTIA_OF_POINT|inertia of slider along x|kg|taken
FORCE|force of pivot along y|N|loop
MOMENT|moment of rail along z|N*m|loop
EFFORT|effort of rack|N*m|loop
ENERGY|energy|J|late
POWER|power|W|loop
BALANCE|balance|W|loop
EVENT_LOSS|event_loss|J|late
LOCAL_ERROR|local_error|1|late
RESIDUAL|residual|1|late
VIOLATION|violation|1|late
VIOLATION_RATE|violation_rate|1|late
VIOLATION_ACCELERATION|violation_acceleration|1|loop
POWER_OF_EFFECT|power of drag|W|loop
ENERGY_OF_EFFECT|energy of drag|J|loop
LOSS|loss of drag|W|loop
WORK|work of drag|W|loop
ROWS
cut -d '|' -f 1 "$out/rows" | sort >"$out/tried"
sed -n 's/.*ROW(QUANTITY_\([A-Z_]*\), .*/\1/p' tools/isoc/scene/quantities.h | sort | cmp - "$out/tried" >&2 && [ -s "$out/tried" ]
result $? "all rows of the table are tried: $(grep -c . "$out/tried")"

cat >"$out/common.scene" <<'SCENE'
gravity (0, -9.81, 0) m/s^2
step 1 ms
method bdf4
checked yes
body bob { mass 1 kg; com (0, -1, 0) m; inertia (1, 1, 1) g*m^2 }
body slider { mass 1 kg; inertia (1, 1, 1) g*m^2 }
joint pivot revolute { parent ground; child bob; axis z; start 10 deg; speed 10 rad/s; continuous }
joint rail prismatic { parent ground; child slider; axis x }
close rack gear { first pivot; second rail; ratio 1 rad/m }
input push smooth = 1 N*m * sin(3 Hz)
effect brake {
    joint along
    signal push N*m
    effort on along = push - 0.1 N*m*s * speed of along
    energy = 0.5 kg*m^2 * (speed of along)^2
    loss = 0.1 N*m*s * (speed of along)^2
    work = push * speed of along
}
effect keeper { signal now; memory kept = 0; next kept = now; output kept }
effect pusher { joint along; signal now; effort on along = 1 N * now }
effect drag brake { along pivot; push push }
output taken = event_loss
SCENE

# per UNIT: $per divides by it; it is nothing where the unit is 1.
per()
{
    per=
    [ "$1" = 1 ] || per="/ (1 $1)"
}

common=$(cat "$out/common.scene")
echo "$common" >"$out/all.scene"
while IFS='|' read -r kind formula unit becomes; do
    per "$unit"
    {
        echo "output alone_$kind = $formula"
        echo "output once_$kind = 1 * $formula"
        echo "output twice_$kind = 2 * $formula $per"
        echo "signal of_$kind = $formula $per"
        echo "effect keep_$kind keeper { now of_$kind }"
        echo "output kept_$kind = keep_$kind.kept"
    } >>"$out/all.scene"
done <"$out/rows"
echo "output whole = orientation of bob" >>"$out/all.scene"
for letter in w x y z; do
    echo "output part_$letter = 1 * orientation of bob along $letter" >>"$out/all.scene"
done
tools/isochron run "$out/all.scene" --real double --seconds 1 >"$out/summary" 2>"$out/errors" &&
    cp "$(sed -n 's/^trace //p' "$out/summary")" "$out/trace"
result $? "a plant with all of them runs"

# compare TRACE: of each kind in how many rows it is wrong, and in how many another number than at the start. A memory
# is zero in the first row.
compare()
{
    awk -F , '
        function off(a, b) { return (a - b) ^ 2 > (1e-7 * a) ^ 2 }
        FNR == 1 { for (i = 2; i <= NF; i++) column[$i] = i; next }
        {
            for (name in column) {
                if (name !~ /^alone_/) continue
                kind = substr(name, 7)
                is = $column[name]
                wrong[kind] += $column["once_" kind] != is || off(2 * is, $column["twice_" kind]) ||
                    (("kept_" kind) in column && FNR > 2 && off(is, $column["kept_" kind]))
                if (FNR == 2) first[kind] = is
                changes[kind] += is != first[kind]
            }
        }
        END { for (kind in wrong) print kind, wrong[kind], changes[kind] }' "$1" | LC_ALL=C sort
}

compare "$out/trace" >"$out/compared"
LC_ALL=C sort "$out/tried" >"$out/wanted"
cut -d ' ' -f 1 "$out/compared" | cmp - "$out/wanted" >&2 && ! grep -qv '^[^ ]* 0 ' "$out/compared"
result $? "alone, times one, times two and in a memory each is the same number$(awk '$2 > 0 { printf ", not %s", $1 }' "$out/compared")"
changed=$(awk '$3 > 0' "$out/compared" | grep -c .)
[ "$changed" -ge 23 ]
result $? "these are numbers that change: $changed of $(grep -c . "$out/compared")"
awk -F , 'FNR == 1 { for (i = 2; i <= NF; i++) column[$i] = i; next }
    { for (i = 1; i <= 4; i++) wrong += $column["whole_" substr("wxyz", i, 1)] != $column["part_" substr("wxyz", i, 1)] }
    END { exit wrong > 0 || FNR < 100 }' "$out/trace"
result $? "the parts of a quaternion by themselves are those of the whole"
for name in alone_ENERGY twice_POWER kept_FORCE once_SPIN; do
    awk -F , -v OFS=, -v name="$name" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) at = i }
        NR == 100 { $at = $at * 1.000001 } { print }' "$out/trace" >"$out/planted"
    [ "$(compare "$out/planted" | awk '$2 > 0' | grep -c .)" -eq 1 ]
    result $? "found: $name off by a millionth in one row"
done

while IFS='|' read -r kind formula unit becomes; do
    word=${formula%% *}
    case $becomes in
    loop) said="an algebraic loop: 'along' needs the $word, which depends on it; a memory breaks it" ;;
    late) said="'$word' is known after the step: for outputs and the next of memories, not for 'along'" ;;
    *) said= ;;
    esac
    per "$unit"
    {
        echo "$common"
        echo "signal asked = $formula $per"
        echo "effect push_by pusher { along rail; now asked }"
        echo "output shown = position of pivot"
    } >"$out/effort.scene"
    isoc "$out/summary" "$out/told" "$out/effort.scene" -o "$out/effort"
    status=$?
    if [ -z "$said" ]; then
        [ $status -eq 0 ]
        result $? "an effort by $formula"
    else
        errors=0
        others=0
        while IFS= read -r line; do
            case $line in
            *' error: '*"$said"*) errors=$((errors + 1)) ;;
            *' error: '*) others=$((others + 1)) ;;
            esac
        done <"$out/told"
        [ $status -ne 0 ] && [ $errors -eq 1 ] && [ $others -eq 0 ]
        result $? "no effort by $formula: $said"
    fi
done <"$out/rows"
finish
