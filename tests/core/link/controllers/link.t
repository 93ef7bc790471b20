#!/bin/sh
# A plant and a controller with a wire between them: in lockstep the hash is that without a wire, on the host and on the
# board, of a controller in C and of one in Python; another plant is refused; and without a link nothing of all this is
# there.
. tests/host/test.sh
begin link/link
one_isoc
optimised -O0
posix=-D_POSIX_C_SOURCE=200809L
sed 's/^input force .*/input force in -20 N to 20 N safe 0 N after 5 ticks/' models/cart_pole.scene >"$out/cart_pole.scene"
EXTRA=$posix program join tests/core/link/controllers/join.c && EXTRA=$posix program noise tests/core/link/controllers/noise.c && program words tests/core/link/controllers/words.c
result $? "what joins two programs is built"

# one_file NAME SOURCE...: $out/NAME.o, of these sources as one file, in which names of one part may hide those of
# another.
one_file()
{
    one_file=$1
    shift
    printf '#include "%s"\n' "$@" >"$out/$one_file.c"
    EXTRA="$posix -Wno-shadow" program "$one_file.o" -c "$out/$one_file.c"
}

# compiled DIR SCENE [OPTION...]
compiled()
{
    compiled_to=$1
    compiled_from=$2
    shift 2
    isoc "$out/summary" "$out/errors" "$compiled_from" -o "$compiled_to" --real $real "$@"
}

for real in float double; do
    real $real
    made=$out/$real
    one_file plain_$real core/numbers/*.c core/runtime/*.c core/application/stream.c port/host/*.c port/unix/console.c &&
        one_file wire_$real port/unix/channel.c port/unix/datagrams.c core/link/*.c
    shared="$out/plain_$real.o $out/wire_$real.o"
    # shellcheck disable=SC2086
    compiled "$made" "$out/cart_pole.scene" --link && program "$real/program" "$made"/*.c $shared
    result $? "$real: a program with a link is built"
    EXTRA="-I$made" program "$real/controller" tests/core/link/controllers/controller.c
    result $? "$real: so is a controller"
    program "$real/alone" "$made/plant.c" tests/core/link/controllers/alone.c "$out/plain_$real.o" && "$made/alone" 3000 >"$out/alone.txt" &&
        "$out/join" "$made/program" -- "$made/controller" 3000 >"$out/joined.txt" && cmp "$out/alone.txt" "$out/joined.txt"
    result $? "$real, in C: the hash is that without a wire: $(cat "$out/joined.txt")"
    "$out/join" "$made/program" -- python3 tests/core/link/controllers/controller.py "$made" 3000 >"$out/joined.txt" &&
        cmp "$out/alone.txt" "$out/joined.txt"
    result $? "$real, in Python: likewise"
    mkdir -p "$made/run"
    "$out/join" build/trace -o "$made/run" -- "$made/program" 3000000000 -- "$made/controller" 0 >"$out/traced.txt" &&
        grep -qx "$(sed 's/ pole.*//' "$out/alone.txt")" "$out/traced.txt" && [ "$(wc -l <"$made/run/trace.csv")" -eq 3002 ]
    result $? "$real: a program that is told how long to run writes its trace, and ends"
done
real float
shared="$out/plain_float.o $out/wire_float.o"

# A wire that damages one byte of 270: all is sent again until it has come, but for the outputs of the last tick, behind
# which the end comes.
seed=$(cksum <core/link/link.c | cut -d ' ' -f 1)
"$out/float/alone" 500 >"$out/alone.txt"
for controller in "$out/float/controller" "python3 tests/core/link/controllers/controller.py $out/float"; do
    # shellcheck disable=SC2086
    "$out/join" "$out/float/program" -- "$out/noise" "$seed" $controller 500 10 >"$out/joined.txt" 2>"$out/errors" &&
        [ "$(cut -d ' ' -f 1,2 "$out/joined.txt")" = "$(cut -d ' ' -f 1,2 "$out/alone.txt")" ]
    result $? "the same over a bad wire, ${controller%% *}: $(cat "$out/errors")"
done

EXTRA="-I$out/float" program again tests/core/link/controllers/again.c && "$out/join" "$out/float/program" -- "$out/again" >"$out/again.txt"
result $? "in C: a run that is ended, the same again, and a free one: $(cat "$out/again.txt")"
"$out/join" "$out/float/program" -- python3 tests/core/link/controllers/again.py "$out/float" >"$out/again.txt"
result $? "in Python: likewise, and what is refused: $(cat "$out/again.txt")"

# The end frame: what core calls its words, and what controllers do.
"$out/words" >"$out/words.txt"
sed -n '/^#define ISO_CLIENT_WORDS/,/[^\\]$/s/.*X(\([a-z_]*\)).*/\1/p' "$out/float/cart_pole_link.h" |
    grep . | cmp - "$out/words.txt"
result $? "a controller in C has the words of core"
python3 -c "import sys; sys.path.insert(0, '$out/float'); import cart_pole_link; print(*cart_pole_link.END, sep='\n')" |
    cmp - "$out/words.txt"
result $? "one in Python likewise"
! sed 's/^late$/lost/' "$out/words.txt" | cmp -s - "$out/words.txt"
result $? "found: a word of another name"

for option in --standalone '--name cart'; do
    # shellcheck disable=SC2086
    ! isoc /dev/null "$out/errors" "$out/cart_pole.scene" -o "$out/none" --link $option && [ ! -e "$out/none" ] &&
        grep -q 'makes a whole program: leave out' "$out/errors"
    result $? "refused: --link with $option: $(head -n 1 "$out/errors")"
done

# refused TEXT NAME: the controller of $out/float does not run with the program $out/other.
refused()
{
    ! "$out/join" "$out/other" -- "$out/float/controller" 10 >"$out/joined.txt" 2>"$out/errors" && grep -q "$1" "$out/errors"
    result $? "refused: $2"
}

# other SCENE [OPTION...]: the program of this plant.
other()
{
    rm -rf "$out/foreign" "$out/other"
    # shellcheck disable=SC2086
    compiled "$out/foreign" "$@" --link && program other "$out/foreign"/*.c $shared
}

# long OUTPUTS [OPTION...]: a plant with so many outputs.
long()
{
    awk -v count="$1" '{ print } END { while (++i <= count) print "output long_" i " = speed of shaft" }' tests/core/link/controllers/rotor.scene >"$out/long.scene"
    shift
    rm -rf "$out/long"
    isoc "$out/summary" "$out/errors" "$out/long.scene" -o "$out/long" --link "$@"
}
# With the two of the rotor 506 floats, or 253 doubles, are what a frame has room for.
real float
long 504 && program long/interface.o -c "$out/long/interface.c"
result $? "the longest frame of floats is that of 506 outputs"
mkdir -p "$out/small/port" && sed 's/ISO_CHANNEL_BYTES = 2048/ISO_CHANNEL_BYTES = 2045/' port/channel.h >"$out/small/port/channel.h"
# shellcheck disable=SC2086
! "$CC" -I"$out/small" $FLAGS -c "$out/long/interface.c" -o "$out/small/interface.o" 2>"$out/errors" &&
    grep -q 'a channel takes a frame at once' "$out/errors"
result $? "found: a channel that takes less than its 2046 bytes"
! long 505 && grep -qx "$out/long.scene: error: a frame of its 507 outputs has 2050 bytes, and a channel takes 2048 at once; leave some of them out, or read them over XCP" \
    "$out/errors" && [ ! -e "$out/long" ]
result $? "refused: a frame that is longer than what a channel takes: $(cat "$out/errors")"
long 251 --real double && ! long 252 --real double
result $? "and one of 254 doubles"
real float

other "$out/cart_pole.scene" --step 2ms && refused 'another plant, method, step or type' "another step"
other "$out/cart_pole.scene" --method heun && refused 'another plant, method, step or type' "another method"
mkdir -p "$out/changed" && sed 's/after 5 ticks/after 6 ticks/' "$out/cart_pole.scene" >"$out/changed/cart_pole.scene"
other "$out/changed/cart_pole.scene" && refused 'another plant, method, step or type' "another time of a safe value"
cp "$out/double/program" "$out/other" && refused 'another plant, method, step or type' "another type of numbers"
cp "$out/float/program" "$out/other" && "$out/join" "$out/other" -- "$out/float/controller" 10 >"$out/joined.txt"
result $? "the same plant is not refused"

# On the board: UART0 is the wire. 300 ticks, since a byte takes QEMU 0.1 ms.
m4f="arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16"
board="$m4f ${FLAGS%% -O0 *} -O2 ${FLAGS#* -O0 } -ffunction-sections -fdata-sections"

# on_board NAME SOURCE...: $out/NAME.o for the board, of these sources as one file.
on_board()
{
    on_board=$1
    shift
    printf '#include "%s"\n' "$@" >"$out/$on_board.c"
    # shellcheck disable=SC2086
    $board -Wno-shadow -c "$out/$on_board.c" -o "$out/$on_board.o"
}

# but_main FILE...: $others are these but for main.c.
but_main()
{
    others=
    for file in "$@"; do
        [ "${file##*/}" = main.c ] || others="$others $file"
    done
}

# firmware FILE OBJECT...
firmware()
{
    firmware_file=$1
    shift
    $m4f -nostartfiles --specs=nano.specs -T port/mps2/mps2.ld -Wl,--gc-sections "$@" -o "$out/$firmware_file"
}

# shellcheck disable=SC2086
but_main core/numbers/*.c core/runtime/*.c core/application/*.c port/mps2/port.c port/mps2/console.c port/mps2/semihosting.c \
    port/mps2/start.c && on_board plain $others && on_board plain_main core/application/main.c &&
    but_main core/link/*.c port/mps2/channel.c && on_board link $others && on_board link_main core/link/main.c &&
    on_board made "$out/float/plant.c" && on_board interface "$out/float/interface.c" &&
    firmware linked.elf "$out/plain.o" "$out/link_main.o" "$out/link.o" "$out/made.o" "$out/interface.o"
result $? "a firmware with a link is built"
"$out/float/alone" 300 >"$out/alone.txt" &&
    "$out/join" qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none \
        -chardev socket,id=wire,fd=3 -serial chardev:wire -semihosting-config \
        enable=on,target=native,arg=plant,arg=300000000 -kernel "$out/linked.elf" -- \
        sh -c "exec '$out/float/controller' 300 >'$out/joined.txt'" >"$out/stream" 2>"$out/errors" &&
    cmp "$out/alone.txt" "$out/joined.txt"
result $? "on the board the hash is that of the host without a wire: $(cat "$out/joined.txt")"

# A program without a link is the same whether what a link needs stands beside it or not.
firmware plain.elf "$out/plain_main.o" "$out/plain.o" "$out/made.o" &&
    firmware beside.elf "$out/plain_main.o" "$out/plain.o" "$out/made.o" "$out/link.o" "$out/interface.o" &&
    for name in plain beside linked; do
        arm-none-eabi-objcopy -O binary "$out/$name.elf" "$out/$name.bin" || break
    done && cmp "$out/plain.bin" "$out/beside.bin"
result $? "a firmware without a link has no byte of one"
! cmp -s "$out/plain.bin" "$out/linked.bin"
result $? "found: one with a link"

# Without a link: the same plant to the last byte, and on the board the same program.
compiled "$out/without" "$out/cart_pole.scene" && cmp "$out/without/plant.c" "$out/float/plant.c" &&
    cmp "$out/without/plant.h" "$out/float/plant.h" && [ "$(ls "$out/without" | wc -l)" -eq 2 ]
result $? "the plant with --link is that without"
mkdir -p "$out/named"
sed 's/^input force.*/input force/' models/cart_pole.scene >"$out/named/cart_pole.scene"
compiled "$out/never" "$out/named/cart_pole.scene" &&
    sed -i 's/^input force/& safe 0 N after 5 ticks/' "$out/named/cart_pole.scene" && compiled "$out/safe" "$out/named/cart_pole.scene" &&
    sed 's/ safe 0 N after 5 ticks//' "$out/safe/plant.c" | cmp - "$out/never/plant.c"
result $? "a safe value changes no byte of the plant but the line of the scene that a comment shows"

# Defects that the script of a wire (tests/core/link/link.c) finds.
one_file sim port/host/*.c port/unix/console.c && program tap.o -c tests/tap.c
mkdir -p "$out/tree/core/link"
cp core/link/*.[ch] "$out/tree/core/link"

# defect FROM TO
defect()
{
    sed "s/$1/$2/" core/link/link.c >"$out/tree/core/link/link.c"
    ! cmp -s core/link/link.c "$out/tree/core/link/link.c" &&
        EXTRA="-I$out/tree -Wno-error" program defect -iquote "$out/tree" tests/core/link/link.c "$out/tap.o" "$out/sim.o" &&
        ! "$out/defect" >"$out/tap" && grep -q '^not ok' "$out/tap"
    result $? "found: $1 changed into $2"
}

defect 'link->age >= wire->after' 'link->age > wire->after'
defect 'answers + 1 < link->answered' 'answers + 1 <= link->answered'
defect 'answers > tick' 'answers >= tick'
defect 'late += answers < ' 'late += answers + 1 < '
defect ' keep_admitted(link);' ' (void)keep_admitted;'
defect 'identity != link->interface->identity' 'identity == 0'
defect 'iso_loop_rest(loop);' ';'
finish
