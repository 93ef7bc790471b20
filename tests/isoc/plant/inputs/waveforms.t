#!/bin/sh
# Test signals, measured ones, and what is kept of signals: to the tick.
. tests/host/test.sh
begin waveforms
one_isoc

for number in float double; do
    real $number
    isoc "$out/$number.summary" '' tests/isoc/plant/inputs/waveforms.scene -o "$out/$number" --real $number &&
        EXTRA="-DPLANT=\"$out/$number/plant.c\"" program waveforms.$number tests/isoc/plant/inputs/waveforms.c tests/host/report.c
    joined $number "$out/waveforms.$number"
done

# What programs for the board have in common is compiled once.
m4f="arm-none-eabi-gcc $FLAGS -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16"
mkdir "$out/port"
for source in tests/tap.c port/mps2/*.c; do
    # shellcheck disable=SC2086
    $m4f -c "$source" -o "$out/port/${source##*/}.o"
done

# on_board PLANT: a program for the board counts the instructions of every tick.
on_board()
{
    # shellcheck disable=SC2086
    $m4f -DPLANT="\"$1\"" -nostartfiles --specs=nosys.specs -T port/mps2/mps2.ld tests/isoc/plant/inputs/count.c "$out"/port/*.o -o "$out/board" &&
        qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none \
            -serial none -semihosting-config enable=on,target=native -kernel "$out/board"
}
real float
joined board on_board "$out/float/plant.c"
grep '^# hash' "$out/tap" >"$out/hash"
EXTRA="-DPLANT=\"$out/float/plant.c\"" program host tests/isoc/plant/inputs/count.c tests/tap.c port/host/*.c port/unix/console.c && "$out/host" >"$out/tap"
grep '^# hash' "$out/tap" | cmp - "$out/hash"
result $? 'the board has the bits of the host'

# cost FORMULA [OUTPUT]: the instructions that it takes in a tick of the board, in float, over those of a constant.
cost()
{
    cost_of=$1
    printf '%s\n' 'step 1 ms' "input push N = $1" 'body cart { mass 1 kg }' \
        'joint rail prismatic { parent ground; child cart; axis x; drive push }' "output place = ${2:-position of rail}" >"$out/cost.scene"
    isoc "$out/summary" '' "$out/cost.scene" -o "$out/cost" && on_board "$out/cost/plant.c" >"$out/counted"
    took=0
    while read -r hash part count; do
        case $part in
        drive | advance) took=$((took + count)) ;;
        esac
    done <"$out/counted"
    [ "${constant:=$took}" = "$took" ] || echo "# ${2:-$cost_of}: $((took - constant)) instructions"
}
cp tests/isoc/plant/inputs/road.csv "$out"
seq 0 1023 | awk '{ print $1 / 100 "," $1 % 7 }' >"$out/long.csv"
cost '1 N'
while IFS='|' read -r formula more; do
    cost "1 N * $formula" && stated tools/isoc/README.md "| \`$formula\`$more | $((took - constant)) |"
    result $? "$formula: $((took - constant)) instructions, as tools/isoc/README.md says"
done <<'END'
step(0.3 s)|
square(20 Hz)|, of a whole number of steps
square(7 Hz)|, of any other
prbs(7)|
chirp(1 Hz, 50 Hz, 2 s)|
END
cost '1 N * file "road.csv"' && few=$((took - constant)) && cost '1 N * file "long.csv"' && many=$((took - constant)) &&
    stated tools/isoc/README.md "| \`file\`, of 6 points and of 1024 | $few, $many |"
result $? "a file: $few instructions, and $many of many points, as tools/isoc/README.md says"
for output in 'previous(push)' 'sample(push, every 5 ms)' 'delay(push, 5 ms)' 'delay(push, 500 ms)'; do
    cost '1 N' "$output"
done

# within BUDGET NAME LESS FORMULA [OUTPUT]: what the same takes that is written by hand, and a little more. LESS is what
# is around it.
within()
{
    budget=$1
    name=$2
    less=$3
    shift 3
    cost "$@" && of_it=$((took - less)) && [ $of_it -gt 0 ] && [ $of_it -le "$budget" ]
    result $? "$name: $of_it instructions of a tick, at most $budget"
}
within 15 "a delay" "$constant" '1 N' 'delay(push, 5 ms)'
within 38 "noise" "$constant" '1 N * noise(1)'
cost '1 N' 'previous(position of rail)'
within 16 "a rounding" "$took" '1 N' 'previous(0.01 m * round(position of rail / 0.01 m))'
(within 2 "a delay" "$constant" '1 N' 'delay(push, 5 ms)' >"$out/within"; grep -q '^not ok' "$out/within")
result $? "found: a budget that is too small"

# A method with a history starts anew at the edges, and only there; with a `jump` as that says.
real double
cart()
{
    printf '%s\n' 'step 1 ms' "method $1" "input push $2" 'body cart { mass 1 kg }' \
        'joint rail prismatic { parent ground; child cart; axis x; spring 100 N/m; drive push }' \
        'output place = position of rail' >"$out/cart.scene"
    isoc "$out/summary" "$out/errors" "$out/cart.scene" -o "$out/cart" --real double
}
for method in ab4 bdf4; do
    cart $method '= 1 N * (step(0.3 s) + square(5 Hz) * sin(3 Hz))' &&
        EXTRA="-DPLANT=\"$out/cart/plant.c\"" program edges tests/isoc/plant/inputs/edges.c && [ "$("$out/edges")" = '100 200 300 400 500 600 700 800 900 ' ]
    result $? "$method starts anew at the edges of a step and a square"
done
cart ab4 'jump 10 N = 1 N * step(0.3 s)' && EXTRA="-DPLANT=\"$out/cart/plant.c\"" program edges tests/isoc/plant/inputs/edges.c && [ -z "$("$out/edges")" ]
result $? 'with a jump given, that alone counts'
cart rk4 '= 1 N * step(0.3 s)' && ! grep -q edge "$out/cart/plant.c" "$out/cart/plant.h"
result $? 'rk4 has no history, and no code for edges'

# told MESSAGE TEXT [MORE]: isoc refuses a file with this text; MORE stands behind it in the scene.
told()
{
    printf -- "$2" >"$out/bad.csv"
    ! cart rk4 '= 1 N * file "bad.csv"'"${3-}" && grep -qF -e "$1" "$out/errors"
    result $? "told: ${1#*: error: }"
}
told "$out/bad.csv:3:3: error: expected a number, a value; found 'two'" '0,1\n\n1,two\n'
told "$out/bad.csv:2:1: error: expected a number, the time in s; found '1.5.2'" '0,1\n1.5.2,2\n'
told "$out/bad.csv:3:4: error: expected a number, a value; found ''" 't,x\n0,1\n1, ,2\n'
told "$out/bad.csv:2:1: error: the times of a file increase" '1,1\n1,2\n'
told "$out/bad.csv:1:1: error: the times of a file increase" '-1,1\n0,2\n'
told "$out/bad.csv:2:1: error: this line has no column 2" '0,1\n3\n'
told "$out/bad.csv:2:5: error: the value is 9.99989e-321; " '0;1\n1;  1e-320\n'
told "'$out/bad.csv' has no points" '# nothing\nt,x\n'
told "cart.scene:3:42: error: expected the number of a column, from 2 on" '0,1\n' ' column 1'
rm "$out/bad.csv"
! cart rk4 '= 1 N * file "bad.csv"' && grep -q "cart.scene:3:25: error: cannot read 'bad.csv': No such file" "$out/errors"
result $? 'a file that is not there is told'
build/isoc tests/isoc/plant/inputs/waveforms.scene --files | grep -qx tests/isoc/plant/inputs/road.csv
result $? '--files has it'
finish
