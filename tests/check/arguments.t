#!/bin/sh
# The nodes of isoc's graph are made in an order that C defines, so that each compiler's isoc writes the same bytes: of
# the arguments of a call, and of an initialiser, at most one makes nodes (tools/isoc/graph/graph.h).
. tests/host/test.sh
begin check/arguments

# found FOLDER: $out/found has the calls and initialisers with more, $makers the number of functions that make nodes.
found()
{
    python3 tests/check/arguments.py "$1" >"$out/listed" 2>"$out/errors" || return
    makers=$(tail -n 1 "$out/listed")
    makers=${makers%% *}
    sed '$d' "$out/listed" >"$out/found"
}

found tools/isoc && [ ! -s "$out/found" ] && [ "$makers" -gt 100 ]
result $? "of the arguments of a call in isoc at most one makes nodes; $makers functions make some"
sed 's/^/# /' "$out/found"

# planted WHAT LINE: a function with this line in the sources is found.
mkdir -p "$out/planted/graph"
cp tools/isoc/graph/graph.c "$out/planted/graph"
planted()
{
    printf 'node planted(graph *g, node a, node b)\n{\n    %s\n}\n' "$2" >"$out/planted/planted.c"
    found "$out/planted" && grep -q "/planted.c:3: planted: " "$out/found" && [ "$(wc -l <"$out/found")" -eq 1 ]
    result $? "found: $1"
}
planted 'a sum of two products' 'return add(g, mul(g, a, b), mul(g, b, b)); /* add( */'
planted 'products in an initialiser' 'const node both[] = {mul(g, a, b), mul(g, b, b)};'
planted 'a product within another argument' 'return add(g, helped(g, a), divide(g, a, larger(g, b, a))); } node helped(graph *g, node a) { return neg(g, a);'
printf 'node one(graph *g, node a)\n{\n    const node b = neg(g, a);\n    return add(g, constant(g, 1.0), mul(g, constant(g, 2.0), b));\n}\n' \
    >"$out/planted/planted.c"
found "$out/planted" && [ ! -s "$out/found" ]
result $? "constants beside another argument are none"
finish
