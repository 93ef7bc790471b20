#!/bin/sh
# One process that carries out many calls of isoc (tests/host/requests.c) writes the same files and messages as
# build/isoc, with the same status, whichever calls came before.
. tests/host/test.sh
begin scenes/requests

{ sed 's/kg/kgg/; s/step .*/step 1 kg ?/' tests/isoc/scene/good.scene && echo 'output y = position of nothing'; } >"$out/bad.scene"
# Where the output goes, if not to a file; arguments of isoc, with a folder behind an -o that ends them.
awk '{ print NR, $0 }' >"$out/requests" <<END
- tests/isoc/scene/good.scene -o
- $out/bad.scene -o
/dev/full --methods
- --help
- tests/isoc/scene/closed.scene --method bdf4 --real double -o
- tests/isoc/scene/good.scene --fast -o
/dev/full tests/isoc/scene/effect.scene -o
- tests/isoc/scene/effect.scene --link --xcp open -o
- $out/absent.scene -o
- tests/isoc/scene/loop.scene --standalone --name loop --step 500us -o
- tests/isoc/scene/loop.scene --formulation articulated --factors sparse -o
- tests/isoc/scene/good.scene --method rk5 -o
- models/cart_pole.scene --python -o
- models/cart_pole.scene --fmu --fmi 2 -o
- models/cart_pole.scene --fmu --exchange -o
- models/cart_pole.scene --lanes --method euler -o
- models/cart_pole.scene --linear -o
- models/four_bar.scene --equations latex
- models/four_bar.scene --dot
- models/double_pendulum.scene --mjcf
- models/cart_pole_drive.scene --set rod_mass=-1kg -o
- models/cart_pole_drive.scene --effects
- models/cart_pole_drive.scene --files
- models/cart_pole_drive.scene --shape
- models/cart_pole_drive.scene --method adams --tolerance 1e-9 -o
END
sort -nr "$out/requests" >"$out/reversed"

# each LIST COMMAND...: carries out all requests of the list by the command, which has the arguments of `isoc` of
# tests/host/test.sh; what comes of them stands in $out/now.
each()
{
    rm -rf "$out/now"
    mkdir "$out/now"
    while read -r number output arguments; do
        [ "$output" != - ] || output=$out/now/$number.output
        case $arguments in
        *-o) arguments="$arguments $out/now/$number" ;;
        esac
        # shellcheck disable=SC2086
        "$command" "$output" "$out/now/$number.messages" $arguments
        echo $? >"$out/now/$number.status"
    done <"$out/$1"
}

command=isoc
each requests
mv "$out/now" "$out/alone"
good=0 bad=0 others=0
for file in "$out"/alone/*.status; do
    read -r status <"$file"
    case $status in
    0) good=$((good + 1)) ;;
    1) bad=$((bad + 1)) ;;
    *) others=$((others + 1)) ;;
    esac
done
[ $good -gt 10 ] && [ $bad -gt 5 ] && [ $others -eq 0 ]
result $? "build/isoc accepts $good of the requests, and refuses $bad"
one_isoc
for list in requests reversed; do
    each $list
    diff -r "$out/alone" "$out/now" >"$out/$list.other"
    result $? "the same by one process, $list"
done

# Control: a request keeps the options of the one before it.
request()
{
    printf '%s\0' "$@"
    echo
}
mkdir -p "$out/planted/tools/isoc"
sed 's/^    request r = {0};$/    static request r;/' tools/isoc/main.c >"$out/planted/tools/isoc/main.c"
command=request
each requests >"$out/asked"
# shellcheck disable=SC2046
"$CC" -I"$out/planted" $FLAGS -O0 -D_POSIX_C_SOURCE=200809L -DISO_REAL_DOUBLE tests/host/requests.c \
    build/obj/tools/isoc/pipeline.o build/obj/tools/isoc/products.o build/obj/tools/isoc/request.o $(isoc_parts o) -lm -o "$out/planted/requests" && "$out/planted/requests" <"$out/asked" >"$out/answered"
cmp -s "$out/alone/1.messages" "$out/now/1.messages" && grep -q '^isoc: error: more than one scene' "$out/now/2.messages" &&
    ! diff -r -x '*.status' "$out/alone" "$out/now" >"$out/planted.other"
result $? "found: a request that keeps what the one before it was told"
finish
