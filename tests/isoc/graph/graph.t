#!/bin/sh
# The operators of isoc's expressions: each has its derivative, or it does not compile; and a new one is a row and the
# function that makes its nodes. Large scenes take little memory and time.
. tests/host/test.sh
begin graph
optimised -O0

FLAGS="$FLAGS -D_POSIX_C_SOURCE=200809L"
sources="tools/isoc/graph/*.c tools/isoc/base/*.c tests/isoc/graph/operators.c tests/tap.c port/host/*.c port/unix/console.c"

# shellcheck disable=SC2086
program operators $sources
result $? "the program builds"
joined "operators" "$out/operators"

# A copy of the tree, to change.
tree=$out/tree
mkdir -p "$tree"
cp -r --parents tools/isoc/graph tools/isoc/base tests/isoc/graph tests/tap.[ch] port core "$tree"
list=$tree/tools/isoc/graph/operators.h

# builds: what the copy's test program says goes to $out/copied.
builds()
{
    # shellcheck disable=SC2086
    (cd "$tree" && "$host_compiler" $FLAGS $REAL_FLAG $sources -o copied -lm) >"$out/said" 2>&1 && "$tree/copied" >"$out/copied"
}

# without WHAT EDIT: the edit, which takes a cell out of a row, changes the list, and then it does not compile.
without()
{
    cp "$list" "$out/list"
    sed "$2" "$out/list" >"$list"
    ! cmp -s "$list" "$out/list" && ! builds && grep -q "operators" "$out/said"
    result $? "$1 does not compile"
    cp "$out/list" "$list"
}
without "a row without its derivative" '/derivative_of_magnitude/d'
without "a row whose derivative is empty" 's/derivative_of_magnitude([^,]*,[^,]*,[^,]*),/,/'

cp "$list" "$out/list"
sed 's/\(derivative_of_magnitude([^,]*,[^,]*,[^,]*)\),/mul(g, constant(g, 0.0), \1),/' "$out/list" >"$list"
! builds && grep -q '^not ok .* ABS has its derivative' "$out/copied"
result $? "found: |v| with a derivative of zero"
cp "$out/list" "$list"

sed 's/^    OPERATION(ADD, 2,/    OPERATION(TWICE, 1, a + a, add(g, da, da), twice(g, a), "iso_twice(@a)", WHOLE, SUM, SUM, DECLARED, 0, 1, 0, 0) \\\n&/' \
    "$list" >"$out/list" && cp "$out/list" "$list"
echo 'node twice(graph *g, node a) { return graph_put(g, (graph_node){.op = OP_TWICE, .a = a}); }' \
    >>"$tree/tools/isoc/graph/graph.c"
sed 's/^node add(/node twice(graph *g, node a);\n&/' tools/isoc/graph/graph.h >"$tree/tools/isoc/graph/graph.h"
builds && grep -q '^ok .* TWICE has its derivative' "$out/copied" && ! grep -q '^not ok' "$out/copied"
result $? "a new operator is a row and a function"

# within MEGABYTES SECONDS SCENE METHOD: isoc compiles it within this memory and this time of a processor.
within()
{
    (ulimit -v $(($1 * 1024)) && ulimit -t "$2" && build/isoc "$3" -o "$out/large" --method "$4") >"$out/said" 2>&1
    result $? "$3 with $4 takes at most $1 MB and $2 s"
}
for links in 32 200; do
    python3 tools/lab/chain.py $links planar >"$out/chain_$links.scene"
done
within 100 4 models/stewart.scene bdf4
within 100 4 "$out/chain_32.scene" bdf4
within 100 4 "$out/chain_200.scene" rk4
! (ulimit -v 20480 && build/isoc models/stewart.scene -o "$out/large" --method bdf4) >"$out/said" 2>&1 &&
    grep -q 'out of memory' "$out/said"
result $? "found: what takes more"
finish
