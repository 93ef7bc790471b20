#!/bin/sh
# A plant in Python: one file of pytest has equal results on the plant in the process, on the host over the link in
# virtual and in real time, and on the Cortex-M4F over it. Plants beside one another, float and double, with policies
# and with steps that are made again, have the hash of one alone, which is that of a run. The wheel; refusals of isoc.
. tests/host/test.sh
. tests/host/bits.sh
begin python/plant
one_isoc
optimised -O0
export PYTHONDONTWRITEBYTECODE=1
common="core/numbers/*.c core/runtime/*.c core/application/stream.c core/link/*.c"
library="core/numbers/self_check.c core/runtime/*.c core/link/command.c core/link/frame.c tools/python/instance.c"

# package NAME SCENE [OPTION...]: the package of a plant, $out/NAME, in $real.
package()
{
    package_name=$1
    shift
    # shellcheck disable=SC2086
    isoc "$out/summary" "$out/errors" "$@" --real $real -o "$out/$package_name" --python &&
        EXTRA="-fPIC -fvisibility=hidden -shared" program "$package_name/plant.so" "$out/$package_name/plant.c" $library &&
        mv "$out/$package_name/plant.so" "$(echo "$out/$package_name"/*_plant)"
}

# words NAME COMMAND...: the tests of all words, by a command that has pytest behind it; their results are $out/NAME.
words()
{
    words_name=$1
    shift
    "$@" pytest-3 -p no:cacheprovider -q "$file" -o junit_family=xunit1 --junitxml="$out/$words_name.xml" >"$out/told" 2>&1 || {
        sed 's/^/# /' "$out/told"
        return 1
    }
    sed 's/></>\n</g' "$out/$words_name.xml" | grep '<property ' | grep -v 'name="takes"' >"$out/$words_name"
    grep -q 'skipped="0" tests="16"' "$out/$words_name.xml"
}

real float
file=tests/tools/python/try_words.py
mkdir -p "$out/link"
EXTRA=-D_POSIX_C_SOURCE=200809L program join tests/core/link/controllers/join.c
# shellcheck disable=SC2086
package words tests/tools/python/words.scene && isoc "$out/summary" '' tests/tools/python/words.scene -o "$out/link" --link &&
    EXTRA=-D_POSIX_C_SOURCE=200809L program link/program "$out"/link/*.c $common port/host/*.c port/unix/*.c
result $? "the package of a plant, and its program with a link"
PYTHONPATH=$out/words words process env
result $? "the words hold on the plant in the process"

# Where numpy is not installed, the first line of what pytest says of it is why.
PYTHONPATH=$out/words pytest-3 -p no:cacheprovider -q -rs tests/tools/python/try_numpy.py >"$out/told" 2>&1
status=$?
case $status in
0) result 0 "numpy takes the arrays without a copy: $(tail -n 1 "$out/told")" ;;
5) result 0 "# SKIP $(sed -n 's/^SKIPPED .*: //p' "$out/told"): apt-get install python3-numpy" ;;
*)
    sed 's/^/# /' "$out/told"
    result $status "numpy takes the arrays without a copy"
    ;;
esac
export PYTHONPATH="$out/link"
words host "$out/join" "$out/link/program" -- && [ -s "$out/host" ] && diff "$out/process" "$out/host"
result $? "on the host over the link, with equal results: $(grep -c 'name="hash"' "$out/host") hashes"
# shellcheck disable=SC2086
EXTRA=-D_POSIX_C_SOURCE=200809L program link/real_time "$out"/link/*.c $common port/posix/*.c port/unix/*.c &&
    words real_time "$out/join" "$out/link/real_time" -- && [ -s "$out/real_time" ] && diff "$out/process" "$out/real_time"
result $? "on the host in real time, with equal results"
# shellcheck disable=SC2046,SC2086
arm-none-eabi-gcc $FLAGS $(of_port mps2 PORT_FLAGS) $(of_port mps2 PORT_LINK) "$out"/link/*.c $common port/mps2/*.c \
    -o "$out/firmware"
cat >"$out/qemu" <<S
#!/bin/sh
exec qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none -chardev \\
    socket,id=wire,fd=3 -serial chardev:wire -semihosting-config enable=on,target=native,arg=plant -kernel "$out/firmware"
S
chmod +x "$out/qemu"
words board "$out/join" "$out/qemu" -- &&
    [ -s "$out/board" ] && diff "$out/process" "$out/board"
result $? "on the board over the link, with equal results"
sed 's/wind=0.25)/wind=0.2500001)/' $file >"$out/test_planted.py"
file=$out/test_planted.py
PYTHONPATH=$out/words words planted env && [ -s "$out/planted" ] && ! cmp -s "$out/process" "$out/planted"
result $? "found: an input that is another"

# The wheel that pip makes: of this platform, with the library in it.
python3 -c 'import sys; sys.path.insert(0, sys.argv[1]); import words_plant_wheel; print(words_plant_wheel.build_wheel(sys.argv[2]))' \
    "$out/words" "$out" >"$out/wheel" && python3 -m zipfile -e "$out/$(cat "$out/wheel")" "$out/installed" &&
    PYTHONPATH=$out/installed python3 -c 'import words_plant; assert words_plant.Plant().start().cart == 0'
result $? "the wheel has the plant: $(cat "$out/wheel")"

# hash_of_run NAME SCENE [OPTION...]: in $real; the trace's summary is $out/ran.
hash_of_run()
{
    instances_name=$1
    shift
    isoc "$out/summary" "$out/errors" "$@" --real $real -o "$out/$instances_name/alone" &&
        EXTRA=-D_POSIX_C_SOURCE=200809L program "$instances_name/run" "$out/$instances_name/alone/plant.c" core/numbers/*.c \
            core/runtime/loop.c core/application/*.c port/host/*.c port/unix/console.c &&
        build/trace -o "$out/$instances_name" -- "$out/$instances_name/run" 1500000000 >"$out/ran"
}

# instances HASH NAME SCENE [OPTION...]: plants of a scene in $real, against this hash of 1500 ticks, or against that of
# one alone.
instances()
{
    instances_hash=$1
    instances_name=$2
    shift 2
    package "$instances_name" "$@" &&
        PYTHONPATH=$out/$instances_name python3 tests/tools/python/instances.py "$(basename "$out/$instances_name"/*_plant)" \
            "$instances_hash" 1500 >"$out/told" 2>&1 || {
        sed 's/^/# /' "$out/errors" "$out/told"
        return 1
    }
}
{
    cat models/cart_pole_drive.scene
    echo 'overrun degrade { drop rub; method heun; hold; after 9 ticks }; histogram; publish next_tick; at 0.3 s set drive.open = 1'
} | sed "s|\"parts/|\"$PWD/models/parts/|" >"$out/policies.scene"
instances alone policies "$out/policies.scene"
result $? "plants beside one another, with policies and a fault at a time, have the hash of one alone"
real double
{ cat models/hopper.scene; echo 'checked yes'; } >"$out/checked.scene"
hash_of_run checked "$out/checked.scene" --method abm4 && instances "$(sed -n 's/^hash //p' "$out/ran")" checked "$out/checked.scene" --method abm4
result $? "likewise in double, with steps that are made again: that of a run"

for option in --link --standalone --shape '--name cart'; do
    # shellcheck disable=SC2086
    build/isoc tests/tools/python/words.scene -o "$out/refused" --python $option >"$out/told" 2>&1 && break
done
[ ! -e "$out/refused" ] && grep -q -- '--python makes a whole program: leave out --name' "$out/told"
result $? "isoc refuses what a package cannot be beside"
finish
