#!/bin/sh
# Commands over the link: run, rest, reset, snapshot and restore, in lockstep and in a free run, after the guard too. A
# snapshot of tick 12345 on the host goes on to the same hash on the host and on the Cortex-M4F.
. tests/host/test.sh
begin link_commands
one_isoc
. tests/host/bits.sh
posix=-D_POSIX_C_SOURCE=200809L
common="core/numbers/*.c core/runtime/*.c core/application/stream.c core/link/*.c"
tick=12345

# plants NAME: the program of the plant of $out/NAME.scene, in float.
plants()
{
    real float
    # shellcheck disable=SC2086
    isoc "$out/summary" '' "$out/$1.scene" -o "$out/$1" --link &&
        EXTRA="$posix" program "$1/program" "$out/$1"/*.c $common port/host/*.c port/unix/*.c
}

# firmware NAME: the same for the board.
firmware()
{
    # shellcheck disable=SC2046,SC2086
    arm-none-eabi-gcc $FLAGS $(of_port mps2 PORT_FLAGS) $(of_port mps2 PORT_LINK) "$out/$1"/*.c $common port/mps2/*.c \
        -o "$out/$1/firmware" || return
    cat >"$out/$1/board" <<S
#!/bin/sh
exec qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none -chardev \\
    socket,id=wire,fd=3 -serial chardev:wire -semihosting-config enable=on,target=native,arg=plant -kernel "$out/$1/firmware"
S
    chmod +x "$out/$1/board"
}

# on PROGRAM COMMAND...: this command at the other end of the wire; the plant has no end by itself.
on()
{
    program=$out/$1
    shift
    "$out/join" "$program" -- "$@" 2>"$out/errors"
}

EXTRA=$posix program join tests/core/link/controllers/join.c
sed 's/^input force .*/input force in -20 N to 20 N/' models/cart_pole.scene >"$out/cart_pole.scene"
cp tests/core/link/controllers/rotor.scene "$out/rotor.scene"

plants cart_pole && EXTRA="-I$out/cart_pole" program commands tests/core/link/controllers/commands.c tests/host/report.c
result $? "a plant and a controller are built"
firmware cart_pole
result $? "and the plant's firmware"
on cart_pole/program "$out/commands" tick "$out/record" $tick >"$out/whole"
on cart_pole/program "$out/commands" from "$out/record" $tick >"$out/resumed"
grep -Eqx "tick $((tick + 1000)) hash [0-9a-f]{16}" "$out/whole" && cmp "$out/whole" "$out/resumed"
result $? "a snapshot of tick $tick goes on to the same hash: $(cat "$out/resumed")"
on cart_pole/board "$out/commands" from "$out/record" $tick >"$out/resumed" || sed 's/^/# /' "$out/errors"
cmp "$out/whole" "$out/resumed"
result $? "and on the board: $(cat "$out/resumed")"
joined "lockstep" on cart_pole/program "$out/commands" all "$out/record"
PYTHONPATH=$out/cart_pole on cart_pole/program python3 tests/core/link/controllers/commands.py || sed 's/^/# /' "$out/errors"
! grep -q Error "$out/errors"
result $? "lockstep: the same from Python"
plants rotor && EXTRA="-I$out/rotor" program rotor_commands tests/core/link/controllers/rotor.c tests/host/report.c
result $? "a rotor and its controller are built"
joined "free" on rotor/program "$out/rotor_commands"

# Control: another input at one tick has another hash.
sed 's/LAW(plant.y);/LAW(plant.y) + (plant.client.tick == 13000);/' tests/core/link/controllers/commands.c >"$out/planted.c"
EXTRA="-I$out/cart_pole" program planted "$out/planted.c" tests/host/report.c &&
    on cart_pole/program "$out/planted" from "$out/record" $tick >"$out/other" && [ -s "$out/other" ] &&
    ! cmp -s "$out/whole" "$out/other"
result $? "found: one input that is another"
finish
