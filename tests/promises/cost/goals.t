#!/bin/sh
# No step may take more instructions or cycles than its row of goals.txt has, by more than 1 %. Prints what each takes
# today beside its goal and the least that its equations need; and where there is one, how many times as long plain C
# takes (plain/), in nanoseconds of one run, which no test holds to a number. Both end at the same states.
. tests/host/test.sh
. tests/host/project.sh
begin goals
one_isoc
. tests/host/callgrind.sh
EXTRA='-fno-tree-ter -frename-registers'

mkdir -p "$out/scenes"
cp models/*.scene tests/promises/cost/masses*.scene "$out/scenes"
for n in 2 8 32; do
    python3 tools/lab/chain.py $n planar >"$out/scenes/chain$n.scene"
done
mv "$out/scenes/chain2.scene" "$out/scenes/dp_rod.scene"
sed 's/^step/gravity (0, 0, -9.81) m\/s^2\nstep/' models/rigid_body.scene >"$out/scenes/free_body.scene"
for name in bricard n_four_bar; do
    sed 's/^stabilisation lagrangian$/stabilisation lagrangian { omega 50 Hz }/' models/$name.scene >"$out/scenes/${name}_feedback.scene"
done
project
sed -i 's/^PORT_CYCLE_NS = .*/PORT_CYCLE_NS = 1/' "$out/project/port/mps2/board.mk"

# on_host NAME, on_board NAME [METHOD]: instructions of a step of the scene; on the board with a clock at which the step
# of each ends within its tick, so that no interrupt is among them.
on_host()
{
    isoc "$out/$1.summary" '' "$out/scenes/$1.scene" -o "$out/$1" --real double &&
        program "$1.run" tests/promises/handwritten/count.c "$out/$1/plant.c" && per_step "$out/$1.run"
}

on_board()
{
    isochron run "../scenes/$1.scene" --target cortex-m4f --method "${2-rk4}" --seconds 0.01 &&
        value instructions_per_step
}

# counted on_host|on_board NAME: $count is what it prints; each is run once.
counted()
{
    [ -f "$out/$1.$2" ] || "$1" "$2" >"$out/$1.$2"
    read -r count <"$out/$1.$2"
}

# over_feedback on_host|on_board NAME: $count is what the projection takes, which the plant with a feedback in its place
# has not.
over_feedback()
{
    counted "$1" "$2" && whole=$count && counted "$1" "$2_feedback" && count=$((whole - count))
}

rosenbrock()
{
    on_board "$1" rosenbrock
}

bdf4()
{
    on_board "$1" bdf4
}

# tick NAME, cycles NAME: what the timing tables of tools/measure say of the tick and of the step.
tick()
{
    isochron cycles "../scenes/$1.scene" --method rk4 --target cortex-m4f && sed -n 's/^tick  *\([0-9]*\) .*/\1/p' "$out/output"
}

cycles()
{
    isochron cycles "../scenes/$1.scene" --method rk4 --target cortex-m4f && sed -n 's/^step  *[0-9]*  *[0-9]* to \([0-9]*\) .*/\1/p' "$out/output"
}

# plain TARGET/NAME: sets hand to plain C of it, with what it is told; empty where there is none.
plain()
{
    case $1 in
    host/dp_rod) hand='tests/promises/cost/plain/chain.c -DRODS=2' ;;
    host/chain8) hand='tests/promises/cost/plain/chain.c -DRODS=8' ;;
    host/cart_pole | host/free_body | host/four_bar) hand=tests/promises/cost/plain/${1#host/}.c ;;
    *) hand= ;;
    esac
}

# beside NAME FILE [FLAG]: sets ratio; whether the plant of on_host and plain C end at the same states.
beside()
{
    name=$1
    plain_source=$2
    shift 2
    EXTRA="$EXTRA $* -D_POSIX_C_SOURCE=200809L" program "$name.beside" tests/promises/cost/plain/ratio.c "$out/$name/plant.c" "$plain_source" && ratio=$("$out/$name.beside")
}

# within COUNT BUDGET
within()
{
    [ "$1" -gt 0 ] && [ $((100 * $1)) -le $((101 * $2)) ]
}

# With the clock as it is, before the runs on the board with another.
while read -r row target _; do
    case $target in
    tick | cycles) counted "$target" "$row" ;;
    esac
done <tests/promises/cost/goals.txt

echo '# row target now budget goal floor; ns of a step, of plain C, ratio'
rows=0
besides=0
while read -r row target budget goal floor; do
    case $row in '#'*) continue ;; esac
    rows=$((rows + 1))
    count=
    case $target in
    host) counted on_host "$row" ;;
    rosenbrock | bdf4) counted "$target" "$row" ;;
    projection/host) over_feedback on_host "$row" ;;
    projection/*) over_feedback on_board "$row" ;;
    tick | cycles) counted "$target" "$row" ;;
    *) counted on_board "$row" ;;
    esac
    ratio=
    plain "$target/$row"
    if [ -n "$hand" ]; then
        besides=$((besides + 1))
        # shellcheck disable=SC2086
        beside "$row" $hand
        result $? "$row: the plant and plain C end at the same states"
    fi
    echo "# $row $target ${count:-?} $budget $goal $floor${ratio:+; $ratio}"
    within "${count:-0}" "$budget"
    result $? "$row, $target: ${count:-?}, at most $budget and 1 %"
done <tests/promises/cost/goals.txt
[ $rows -ge 15 ]
result $? "goals.txt has $rows rows"
[ $besides -eq 5 ]
result $? "$besides of them beside plain C"
! within 1011 1000 && within 1010 1000 && ! within 0 1000
result $? "control: a rise of 1.1 %, and no count, are found"
finish
