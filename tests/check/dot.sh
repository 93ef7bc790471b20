#!/bin/sh
# isoc --dot: graphviz draws every body, joint and closure of a scene, closures dashed, frames dotted, with their effects.
. tests/host/test.sh
begin check/dot

# counted SCENE: how many bodies, frames, joints, springs and closures it has; those of a repeat are counted by hand.
counted()
{
    case $1 in
    */stewart.scene) more='12 0 12 0 6' ;;
    */n_four_bar.scene) more='5 0 5 0 2' ;;
    *) more='0 0 0 0 0' ;;
    esac
    awk -v more="$more" '
        /^(body|frame|joint|spring|close) / { n[$1]++ }
        END {
            split(more, m, " ")
            print n["body"] + m[1], n["frame"] + m[2], n["joint"] + m[3], n["spring"] + m[4], n["close"] + m[5]
        }' "$1"
}

# drawn: how many nodes, edges, dashed and dotted lines the drawing has.
drawn()
{
    awk '
        /class="node"/ { nodes++ }
        /class="edge"/ { edges++ }
        /stroke-dasharray="5,2"/ { dashed++ }
        /stroke-dasharray="1,5"/ { dotted++ }
        END { print nodes + 0, edges + 0, dashed + 0, dotted + 0 }' "$out/drawing.svg"
}

for scene in models/*.scene tests/scenes/*.scene; do
    build/isoc --dot "$scene" >"$out/graph.dot" && dot -Tsvg "$out/graph.dot" >"$out/drawing.svg" 2>"$out/errors" &&
        [ ! -s "$out/errors" ]
    result $? "$scene is drawn, and nothing is said against it"
    # Of repeats and included files the number of words says nothing.
    ! grep -q '^ *\(include\|repeat\) ' "$scene" || continue
    counted "$scene" >"$out/counted"
    read -r bodies frames joints springs closures <"$out/counted"
    drawn >"$out/drawn"
    read -r nodes edges dashed dotted <"$out/drawn"
    [ "$nodes" -eq $((bodies + frames + 1)) ]
    result $? "$scene: a node for each of $((bodies + frames)) bodies and frames, and the ground"
    [ "$edges" -eq $((joints + closures + frames + springs)) ] && [ "$dashed" -eq "$closures" ] && [ "$dotted" -eq "$frames" ]
    result $? "$scene: an edge for each of $joints joints, $springs springs and $frames frames, a dashed one for each of $closures closures"
done

# Effects; the last drawing is that of good.scene.
for told in closed:'force jet: thrust' closed:chain closed:distance closed:gear closed:universal closed:damping \
    'closed:states: tube_slide, tube_turn, tube_slide_speed,' closed:tube_turn_speed closures:'states: clock_1' frames:finger 'frames:spring, damping' good:'drive: push' good:revolute; do
    build/isoc --dot "tests/scenes/${told%%:*}.scene" | dot -Tsvg >"$out/drawing.svg" && grep -qF ">${told#*:}</text>" \
        "$out/drawing.svg"
    result $? "${told%%:*}: ${told#*:}"
done
! grep -qF '>spring</text>' "$out/drawing.svg"
result $? "found: an effect that is not there"

# told FILE: the nodes, edges and texts of a drawing; where they stand is a matter of the machine's fonts.
told()
{
    grep -o '<title>.*</title>\|>[^<]*</text>' "$1"
}

build/isoc --dot models/squeezer.scene | dot -Tsvg >"$out/drawing.svg"
told "$out/drawing.svg" >"$out/told"
[ "$(grep -c . "$out/told")" -gt 40 ] && told models/pictures/squeezer.svg | cmp -s - "$out/told"
result $? "models/pictures/squeezer.svg is what graphviz draws"

! build/isoc --dot models/pendulum.scene | head -c 60 | dot -Tsvg >"$out/drawing.svg" 2>"$out/errors"
result $? "found: half a graph"
echo 'step 1 ms' >"$out/bad.scene"
! build/isoc --dot "$out/bad.scene" >"$out/graph.dot" 2>"$out/errors" && [ ! -s "$out/graph.dot" ] && [ -s "$out/errors" ]
result $? "a scene with mistakes has no graph"
finish
