#!/bin/sh
# isoc --dot: graphviz draws every body, joint and closure of a scene, closures dashed, frames dotted, with their effects.
. tests/host/test.sh
begin check/dot

# statements WORD...: how many the scene has of them; those of a repeat are counted by hand.
statements()
{
    more=0
    for word in "$@"; do
        case $scene:$word in
        */stewart.scene:body | */stewart.scene:joint) more=$((more + 12)) ;;
        */stewart.scene:close) more=$((more + 6)) ;;
        */n_four_bar.scene:body | */n_four_bar.scene:joint) more=$((more + 5)) ;;
        */n_four_bar.scene:close) more=$((more + 2)) ;;
        esac
    done
    echo $(($(grep -Ec "^($(echo "$*" | tr ' ' '|')) " "$scene") + more))
}

# drawn PATTERN: how many lines of the drawing have it.
drawn()
{
    grep -c -- "$1" "$out/drawing.svg"
}

for scene in models/*.scene tests/scenes/*.scene; do
    build/isoc --dot "$scene" >"$out/graph.dot" && dot -Tsvg "$out/graph.dot" >"$out/drawing.svg" 2>"$out/errors" &&
        [ ! -s "$out/errors" ]
    result $? "$scene is drawn, and nothing is said against it"
    # Of repeats and included files the number of words says nothing.
    ! grep -q '^ *\(include\|repeat\) ' "$scene" || continue
    [ "$(drawn 'class="node"')" -eq $(($(statements body frame) + 1)) ]
    result $? "$scene: a node for each of $(statements body frame) bodies and frames, and the ground"
    [ "$(drawn 'class="edge"')" -eq "$(statements joint close frame spring)" ] &&
        [ "$(drawn 'stroke-dasharray="5,2"')" -eq "$(statements close)" ] &&
        [ "$(drawn 'stroke-dasharray="1,5"')" -eq "$(statements frame)" ]
    result $? "$scene: an edge for each of $(statements joint) joints, $(statements spring) springs and $(statements frame) frames, a dashed one for each of $(statements close) closures"
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
