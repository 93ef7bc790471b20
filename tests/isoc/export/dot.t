#!/bin/sh
# isoc --dot: graphviz draws every body, joint and closure of a scene, closures dashed, frames dotted, with their
# effects.
. tests/host/test.sh
begin check/dot
one_isoc

# counted SCENE DRAWING ...: of each pair a line: the scene; 1 where it repeats or includes something; how many bodies,
# frames, joints, springs and closures it has, of which those of a repeat are counted by hand; how many nodes, edges,
# dashed and dotted lines the drawing has.
counted()
{
    awk '
        FNR == 1 && ++files % 2 == 1 {
            if (files > 1) ended()
            scene = FILENAME
        }
        function ended() {
            split(scene ~ /\/stewart[.]scene$/ ? "12 0 12 0 6" : scene ~ /\/n_four_bar[.]scene$/ ? "5 0 5 0 2" : "0 0 0 0 0", more, " ")
            print scene, repeats + 0, n["body"] + more[1], n["frame"] + more[2], n["joint"] + more[3], n["spring"] + more[4], \
                n["close"] + more[5], nodes + 0, edges + 0, dashed + 0, dotted + 0
            nodes = edges = dashed = dotted = repeats = 0
            for (word in n) n[word] = 0
        }
        files % 2 == 1 && /^(body|frame|joint|spring|close) / { n[$1]++ }
        files % 2 == 1 && /^ *(include|repeat) / { repeats = 1 }
        files % 2 == 1 { next }
        /class="node"/ { nodes++ }
        /class="edge"/ { edges++ }
        /stroke-dasharray="5,2"/ { dashed++ }
        /stroke-dasharray="1,5"/ { dotted++ }
        END { ended() }' "$@"
}

set --
for scene in models/*.scene tests/isoc/scene/*.scene; do
    drawing=${scene##*/}
    drawing=$out/${drawing%.scene}.svg
    isoc "$out/graph.dot" '' --dot "$scene" && dot -Tsvg "$out/graph.dot" >"$drawing" 2>"$out/errors" && [ ! -s "$out/errors" ]
    result $? "$scene is drawn, and nothing is said against it"
    set -- "$@" "$scene" "$drawing"
done
counted "$@" >"$out/counted"
while read -r scene repeats bodies frames joints springs closures nodes edges dashed dotted; do
    # Of repeats and included files the number of words says nothing.
    [ "$repeats" -eq 0 ] || continue
    [ "$nodes" -eq $((bodies + frames + 1)) ]
    result $? "$scene: a node for each of $((bodies + frames)) bodies and frames, and the ground"
    [ "$edges" -eq $((joints + closures + frames + springs)) ] && [ "$dashed" -eq "$closures" ] && [ "$dotted" -eq "$frames" ]
    result $? "$scene: an edge for each of $joints joints, $springs springs and $frames frames, a dashed one for each of $closures closures"
done <"$out/counted"
[ $((2 * $(wc -l <"$out/counted"))) -eq $# ]
result $? "each scene has its drawing"

# Effects.
for told in closed:'force jet: thrust' closed:chain closed:distance closed:gear closed:universal closed:damping \
    'closed:states: tube_slide, tube_turn, tube_slide_speed,' closed:tube_turn_speed closures:'states: clock_1' frames:finger 'frames:spring, damping' good:'drive: push' good:revolute; do
    grep -qF ">${told#*:}</text>" "$out/${told%%:*}.svg"
    result $? "${told%%:*}: ${told#*:}"
done
! grep -qF '>spring</text>' "$out/good.svg"
result $? "found: an effect that is not there"

# told FILE: the nodes, edges and texts of a drawing; where they stand is a matter of the machine's fonts.
told()
{
    grep -o '<title>.*</title>\|>[^<]*</text>' "$1"
}

told "$out/squeezer.svg" >"$out/told"
[ "$(grep -c . "$out/told")" -gt 40 ] && told models/pictures/squeezer.svg | cmp -s - "$out/told"
result $? "models/pictures/squeezer.svg is what graphviz draws"

! build/isoc --dot models/pendulum.scene | head -c 60 | dot -Tsvg >"$out/drawing.svg" 2>"$out/errors"
result $? "found: half a graph"
echo 'step 1 ms' >"$out/bad.scene"
! isoc "$out/graph.dot" "$out/errors" --dot "$out/bad.scene" && [ ! -s "$out/graph.dot" ] && [ -s "$out/errors" ]
result $? "a scene with mistakes has no graph"
finish
