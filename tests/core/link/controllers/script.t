#!/bin/sh
# A controller that sets tunables and faults at random ticks of a run: to the bit as `at T set` in the scene, from C and
# from Python, on the host and on the Cortex-M4F. The example of models/hil: ten faults from one snapshot, with pytest.
. tests/host/test.sh
begin link_script
. tests/host/bits.sh
common="core/numbers/*.c core/runtime/*.c core/application/stream.c core/link/*.c"
ticks=1500
seed=$(cksum <models/hil/faults.scene | cut -d ' ' -f 1)
echo "# seed $seed"

# A schedule of faults and of a tunable with limits; and the scene that has it as text, beside one without.
awk -v seed="$seed" -v ticks=$ticks 'BEGIN {
    srand(seed)
    count = split("sag supply drive belt angle hiss shift wire", parts, " ")
    for (i = 0; i < 12; i++) {
        tick = 1 + int(rand() * (ticks - 1))
        name = parts[1 + int(rand() * count)]
        name = name (name == "drive" ? "_open" : "_active")
        if (i % 4 == 3) printf "%d reach %.4f\n", tick, 0.2 * rand()
        else printf "%d %s %g\n", tick, name, (rand() < 0.3 ? 0.37 : rand() < 0.5)
    }
}' | sort -n -s -k 1,1 >"$out/schedule"
sed 's/^    amount 0.1 m$/    amount reach/; s/^constant pole_start .*/&\ntunable reach = 0.1 m in 0 m to 0.2 m/' \
    models/hil/faults.scene | sed "s|\"../parts/|\"$PWD/models/parts/|" >"$out/script.scene"
grep -q '^tunable reach' "$out/script.scene" && grep -q '^    amount reach$' "$out/script.scene" && [ "$(grep -c . "$out/schedule")" -eq 12 ]
result $? "a scene with a tunable, and a schedule of $(sort -u -k 2,2 "$out/schedule" | grep -c .) tunables"
mkdir -p "$out/at"
{
    cat "$out/script.scene"
    while read -r tick name value; do
        case $name in
        reach) echo "at $tick ms set reach = $value m" ;;
        *) echo "at $tick ms set ${name%_*}.${name##*_} = $value" ;;
        esac
    done <"$out/schedule"
} >"$out/at/script.scene"
: >"$out/nothing"

# plants NAME SCENE: the plant's program with its link, and a controller in C; NAME is also their folder.
plants()
{
    real float
    # shellcheck disable=SC2086
    build/isoc "$2" -o "$out/$1" --link >"$out/summary" &&
        EXTRA=-D_POSIX_C_SOURCE=200809L program "$1/program" "$out/$1"/*.c $common port/host/*.c port/unix/*.c &&
        EXTRA="-I$out/$1" program "$1/controller" tests/core/link/controllers/script.c
}

# hash PROGRAM COMMAND...: what the controller says of a run.
hash()
{
    hash_program=$1
    shift
    PYTHONDONTWRITEBYTECODE=1 "$out/join" "$hash_program" -- "$@" 2>"$out/errors" | grep -x '[0-9a-f]\{16\}' || sed 's/^/# /' "$out/errors"
}

EXTRA=-D_POSIX_C_SOURCE=200809L program join tests/core/link/controllers/join.c && plants link "$out/script.scene" && plants scene "$out/at/script.scene"
result $? "plants and controllers are built"
in_scene=$(hash "$out/scene/program" "$out/scene/controller" "$out/nothing" $ticks)
over_link=$(hash "$out/link/program" "$out/link/controller" "$out/schedule" $ticks)
[ -n "$over_link" ] && [ "$over_link" = "$in_scene" ]
result $? "from C: $over_link, in the scene $in_scene"
export PYTHONPATH="$out/scene"
in_scene=$(hash "$out/scene/program" python3 tests/core/link/controllers/script.py "$out/nothing" $ticks)
PYTHONPATH=$out/link
over_link=$(hash "$out/link/program" python3 tests/core/link/controllers/script.py "$out/schedule" $ticks)
[ -n "$over_link" ] && [ "$over_link" = "$in_scene" ]
result $? "from Python: $over_link, in the scene $in_scene; tunables and counts can be read, and what is wrong is refused"

# shellcheck disable=SC2046,SC2086
arm-none-eabi-gcc $FLAGS $(of_port mps2 PORT_FLAGS) $(of_port mps2 PORT_LINK) "$out"/link/*.c $common port/mps2/*.c \
    -o "$out/firmware"
cat >"$out/board" <<S
#!/bin/sh
exec qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none -chardev \\
    socket,id=wire,fd=3 -serial chardev:wire -semihosting-config enable=on,target=native,arg=plant -kernel "$out/firmware"
S
chmod +x "$out/board"
on_board=$(hash "$out/board" python3 tests/core/link/controllers/script.py "$out/schedule" $ticks)
[ -n "$on_board" ] && [ "$on_board" = "$over_link" ]
result $? "the same on the board: $on_board"

# The package of the controller's end: a wheel, which Python reads as it is.
python3 -c 'import os, sys; sys.path.insert(0, sys.argv[1]); import script_link_wheel; print(script_link_wheel.build_wheel(sys.argv[2]))' \
    "$out/link" "$out" >"$out/wheel"
PYTHONPATH=$out/$(cat "$out/wheel")
from_wheel=$(hash "$out/link/program" python3 tests/core/link/controllers/script.py "$out/schedule" $ticks)
[ -n "$from_wheel" ] && [ "$from_wheel" = "$over_link" ] && python3 -m zipfile -t "$out/$(cat "$out/wheel")" >"$out/told"
result $? "the same from the wheel $(cat "$out/wheel")"
PYTHONPATH=$out/link

# Control: the same one tick later has another hash.
awk '{ $1++; print }' "$out/schedule" >"$out/later"
later=$(hash "$out/link/program" python3 tests/core/link/controllers/script.py "$out/later" $ticks)
[ -n "$later" ] && [ "$later" != "$over_link" ]
result $? "found: a tick later, $later"

# The worked example, as its head says.
command=$(sed -n "s|^    tools/isochron link |tools/isochron link |p" models/hil/test_faults.py)
eval "PYTHONDONTWRITEBYTECODE=1 $command --out $out/pytest" >"$out/told" 2>&1
grep -q '^[= ]*10 passed' "$out/told" && grep -q '^link_inputs 17000$' "$out/told" && grep -q 'tests="10"' build/faults.xml && grep -q 'failures="0"' build/faults.xml
result $? "ten cases pass: $command"
sed 's/drive.open", 1/drive.open", 0/' models/hil/test_faults.py >"$out/test_planted.py"
! eval "PYTHONDONTWRITEBYTECODE=1 $(echo "$command" | sed "s| models/hil --| $out/test_planted.py -p no:cacheprovider --|; s|build/faults|$out/faults|") --out $out/pytest" >"$out/told" 2>&1 &&
    grep -q 'failures="1"' "$out/faults.xml"
result $? "found: a fault that is not switched on"
finish
