#!/bin/sh
# isochron show: the page of a scene in a browser without a window (browser.py). It plays, scrubs, turns, has its plots
# with a cursor, in light and dark, narrow and wide; its bodies are where the outputs of the scene have them; a still
# has the same polygons; a page with a fault, and a machine without a browser, are found.
. tests/host/test.sh
. tests/host/project.sh
begin show/show
project

# page NAME WORD...: isochron show; the page goes to $out/NAME.html.
page()
{
    page_name=$1
    shift
    isochron show "$@" && cp "$out/project/build/host/float/double_pendulum/show.html" "$out/$page_name.html"
}

page several models/double_pendulum.scene --seconds 2 --against '--real double | --method heun --step "4 ms"'
expect $? "three runs on one page, of which one is in double"
page single models/double_pendulum.scene --seconds 2
expect $? "one run"
grep -q '^include "\.\./' "$out/project/build/host/float/double_pendulum/show/1/double_pendulum.scene"
result $? "a scene with poses names the folder of the project nowhere, whose name may be no ASCII text"
! grep -q '://\|src=\|@import\|fetch(' "$out/single.html"
result $? "a page needs nothing but itself"
isochron show models/double_pendulum.scene --seconds 2 --still 0.3 &&
    cp "$out/project/build/host/float/double_pendulum/show.svg" "$out/single.svg"
expect $? "a still"
isochron run models/double_pendulum.scene --step 4ms --seconds 1 --keep before && page kept models/double_pendulum.scene --seconds 2 --against 'before | --real double'
expect $? "a run that was kept"
! isochron show models/double_pendulum.scene --against 'rub' && grep -q "'rub' is no option of a run" "$out/errors"
expect $? "told: what is no option"
! isochron show models/oscillator.c && grep -q 'show is for scenes' "$out/errors"
expect $? "told: a plant in C"

# A run that its guard ends is shown until then, and why: a state that is not finite, or a singular position.
sed '/^stabilisation/d' models/parallelogram.scene >"$out/flat.scene"
echo 'stabilisation projection { near stop }' >>"$out/flat.scene"
isochron show "$PWD/$out/flat.scene" --seconds 1 &&
    grep -q 'the run ends at 0[.]5.* s: the guard stopped it: near a singular position of closure follower_pin$' "$out/errors"
expect $? "told: a run that ends near a singular position"
sed 's/^method .*/method euler/; s/^step .*/step 0.3 s/' models/double_pendulum.scene >"$out/long.scene"
isochron show "$PWD/$out/long.scene" --seconds 60 && grep -q 'the run ends at .* s: the guard stopped it: state ' "$out/errors"
expect $? "told: a run that ends with a state that is not finite"

# The same outputs, to the last bit, as of the scene without poses: the hash is over the states.
isochron run models/double_pendulum.scene --seconds 2
hash=$(value hash)
build/trace -o "$out" -- "$out/project/build/host/float/double_pendulum/show/1/program" 2000000000 >"$out/summary"
[ -n "$hash" ] && grep -qx "hash $hash" "$out/summary"
result $? "what is shown is the run of the scene, bit for bit"

sed 's/^setPlaying(false);/setPlaying(false); missing();/' "$out/single.html" >"$out/fault.html"
joined browser python3 tests/tools/show/pages.py "$out"
mkdir -p "$out/bin"
python=$(python3 -c 'import sys; print(sys.executable)')
! PATH=$PWD/$out/bin "$python" tests/tools/show/pages.py "$out" >"$out/found" 2>&1 && grep -q 'apt-get install chromium-headless-shell' "$out/found"
result $? "found: a machine without a browser, which is no reason to skip"
finish
