#!/bin/sh
# Statements stand in any order, and none is read across the end of a line where it is complete: pairs of statements
# give the plant that they give with a semicolon between them, and in the other order. And names: each word of the
# language is a name where the grammar is not ambiguous.
. tests/host/test.sh
begin language/lines
python3 -B tests/isoc/scene/language/lines.py build/tests/requests "$out" 20261122 30
result $? 'pairs of statements, with a line between them, a semicolon, and in the other order'

# names SORT RESERVED SCENE: the words that can be names of it give the plant that another name gives; the others are
# refused.
names()
{
    printf '%s\n' "$3" | python3 -B tests/isoc/scene/language/names.py build/tests/requests "$out" "$2" >"$out/bad" && [ ! -s "$out/bad" ]
    names_status=$?
    [ ! -s "$out/bad" ] || sed "s/^/# $1: /" "$out/bad"
    result $names_status "$1 called like words of the language; reserved are $2"
}
begun='step 1 ms
body bob { mass 1 kg; com (0, -1, 0) m; inertia (1, 1, 1) kg*m^2 }'
hinge='joint pivot revolute { parent ground; child bob; axis z; start 1 deg }
output angle = position of pivot'
names 'a constant' 'ground pi time at about rotate quaternion' "$begun
constant NAME = 2
body more { mass NAME * 1 kg; com (1, 1, 0) m }
joint pivot revolute { parent ground; child bob; axis z; start NAME * 1 deg }
joint second revolute { parent bob at (NAME, 0, 0) m; child more; axis x; spring NAME * 1 N*m/rad rest NAME * 1 deg }
output angle = position of pivot
output number = NAME * 2"
names 'a body' 'ground pi time' "step 1 ms
body NAME { mass 1 kg; com (0, -1, 0) m; inertia (1, 1, 1) kg*m^2 }
joint pivot revolute { parent ground; child NAME at (0, 1, 0) m; axis z }
output tip = position of NAME at (0, 1, 0) m
output across = velocity of NAME along y
output square = dot(velocity of NAME, velocity of NAME in body)"
names 'a joint' 'ground pi time' "$begun
joint NAME revolute { parent ground; child bob; axis z; start 1 deg }
output angle = position of NAME
output other = 2 * speed of NAME"
names 'an input' 'ground pi time' "$begun
$hinge
input NAME V smooth = 1 V in 0 V to 2 V
output volts = 2 * NAME"
names 'a signal' 'ground pi time' "$begun
$hinge
signal NAME = speed of pivot
output fast = 2 * NAME"
names 'an operand of an effect' 'pi time substeps' "$begun
$hinge
effect kind { joint j; value NAME = 1; let twice = NAME * 2; effort on j = 1 N*m * twice * NAME }
effect use kind { j pivot
NAME 2 }"
# Of two words one is no name here, and the other is.
for reserved in 'ground pi time at' 'ground pi'; do
    echo "$begun
$hinge
signal NAME = speed of pivot" | python3 -B tests/isoc/scene/language/names.py build/tests/requests "$out" "$reserved" 'ground pi time at' | sed 's/:.*//'
done | paste -sd ' ' >"$out/bad"
[ "$(cut -d ' ' -f 1,2 "$out/bad")" = "at time" ]
result $? "found: a word that is a name, and one that is none"
finish
