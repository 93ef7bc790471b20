#!/bin/sh
# Many plants side by side in Python: each lane has the outputs and the hash of the same plant alone, in float with 8
# lanes and in double with 4; without inputs; inputs that are functions of time; what is planted is found.
. tests/host/test.sh
begin python/lanes
optimised -O0
export PYTHONDONTWRITEBYTECODE=1
library="core/numbers/self_check.c core/runtime/*.c core/link/command.c core/link/frame.c tools/python/instance.c"

# tried NAME: pytest with the library of NAME says how many passed, in $out/told.
tried()
{
    PYTHONPATH=tools/python:$out/alone_$real LANES_LIBRARY=$out/$1/lanes.so pytest-3 -p no:cacheprovider -q -rsf tests/tools/python/try_lanes.py \
        >"$out/told" 2>&1
}

for row in 'float 8' 'double 4'; do
    real "${row% *}"
    # shellcheck disable=SC2086
    build/isoc tests/core/xcp/masters/cart.scene --real $real -o "$out/alone_$real" --python >"$out/summary" &&
        $CC $FLAGS $REAL_FLAG -fPIC -fvisibility=hidden -shared "$out/alone_$real/plant.c" $library -o "$out/alone_$real/cart_plant/plant.so" &&
        tools/isochron python tests/core/xcp/masters/cart.scene --out "$out/$real" --lanes "${row#* }" --real $real >"$out/summary" && tried "$real/lanes" || {
        sed 's/^/# /' "$out/told"
        false
    }
    result $? "${row#* } lanes in $real: $(tail -n 1 "$out/told")"
done

# A restart that leaves the fault of a lane, and a hash of another lane.
sed 's/side->lanes.plant.lane_bytes, mask/sizeof(real), mask/' tools/python/lanes.c >"$out/lanes.c"
! cmp -s tools/python/lanes.c "$out/lanes.c" && mkdir -p "$out/planted" &&
    $CC -std=c11 -O1 $NUMERICS -Wno-psabi -fPIC -shared -DISO_REAL_DOUBLE -DISO_LANES=4 -iquote "$out/double/lanes" -I. \
        "$out/lanes.c" core/numbers/self_check.c -o "$out/planted/lanes.so" && ! tried planted && grep -q 'FAILED.*test_steps_and_restarts' "$out/told"
result $? "found: a restart of one row"

sed '/^input /d; /drive /d' models/pendulum.scene >"$out/free.scene"
tools/isochron python "$out/free.scene" --out "$out/free" --lanes 16 >"$out/summary" &&
    tools/isochron python tests/tools/python/words.scene --out "$out/words" --lanes 2 >>"$out/summary" &&
    PYTHONPATH=tools/python python3 -c '
import sys, lanes
free, words = (lanes.Lanes(path) for path in sys.argv[1:])
assert free.count == 16 and not free.inputs and not free.tunables and free.record(9)["theta"].shape == (10, 16)
assert list(words.inputs) == ["force"] and words.step(force=1.5)
' "$out/free/lanes/lanes.so" "$out/words/lanes/lanes.so"
result $? "plants without inputs and tunables, and with inputs that are functions of time"
finish
