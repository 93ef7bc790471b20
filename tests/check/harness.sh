#!/bin/sh
# The harness counts what it must: passed, failed, crashed, without a plan, skipped; and tells a failure by its status.
. tests/host/test.sh
begin check/harness
mkdir -p "$out/tests"
# What the harness that runs this test was told is no concern of the one that is tried.
unset TEST_MEASURED TEST_TAKES TEST_KEPT TEST_STATE TEST_BEGAN TALLY_MOST
program measured tests/host/measured.c
result $? "what measures builds"

# one NAME TEXT: a test script of that name in the small set that the harness is tried on.
one()
{
    printf '%s\n' "$2" >"$out/tests/$1.t"
}

# tally NAME...: runs them; fails as the harness does.
tally()
{
    files=
    for file in "$@"; do
        files="$files $out/tests/$file.t"
    done
    # shellcheck disable=SC2086
    TALLY_LOG="$out/log" PERL5LIB=tests prove --harness Tally --merge --exec tests/exec.sh $files >"$out/output" 2>&1
}

# counts LINE NAME FILE...: the last line of what the harness prints is LINE, and no other looks like it; the status is
# 0 only without a failure.
counts()
{
    line=$1
    name=$2
    shift 2
    tally "$@"
    status=$?
    last=
    counted=0
    while IFS= read -r output_line; do
        last=$output_line
        case $last in
        [0-9]*' passed, '*) counted=$((counted + 1)) ;;
        esac
    done <"$out/output"
    expected=1
    case $line in
    *", 0 failed"*) expected=0 ;;
    esac
    [ "$last" = "$line" ] && [ $counted -eq 1 ] &&
        { [ $status -eq 0 ] || [ $expected -eq 1 ]; } && { [ $status -ne 0 ] || [ $expected -eq 0 ]; }
    good=$?
    [ $good -eq 0 ] || sed 's/^/# /' "$out/output"
    result $good "$name"
}

one good 'echo "ok 1 - a"; echo "ok 2 - b"; echo 1..2'
one bad 'echo "ok 1 - a"; echo "not ok 2 - this one fails"; echo "# for a reason"; echo 1..2; exit 1'
one crash 'echo "ok 1 - a"; echo 1..1; kill -SEGV $$'
one noplan 'echo "ok 1 - a"'
one silent 'exit 0'
one short 'echo "ok 1 - a"; echo 1..3'
one status 'echo "ok 1 - a"; echo 1..1; exit 3'
one skip 'echo "ok 1 - a"; echo "ok 2 # SKIP no need"; echo 1..2'

counts "2 passed, 0 failed" "two tests that pass" good
counts "3 passed, 1 failed" "a test that fails" good bad
counts "1 passed, 1 failed" "a program that crashes after its plan" crash
counts "1 passed, 1 failed" "a program without a plan" noplan
counts "0 passed, 1 failed" "a program that prints nothing" silent
counts "1 passed, 1 failed" "fewer tests than planned" short
counts "1 passed, 1 failed" "a status that is not 0" status
counts "1 passed, 0 failed, 1 skipped" "a skipped test" skip
counts "0 passed, 1 failed" "a test that does not exist" absent

tally good bad
grep -q 'not ok 2 - this one fails' "$out/output" && grep -q '# for a reason' "$out/output"
result $? "what failed is shown, with its comments"
grep -qx 'ok 2 - b' "$out/log" && grep -qx 'not ok 2 - this one fails' "$out/log"
result $? "everything printed stands in the log"

# The number of processes, if the machine tells it, stands before the last line.
# many_of NUMBER: a test that starts so many, and two more, its shell and seq.
many_of()
{
    one many "for i in \$(seq $1); do cat /dev/null; done; echo 'ok 1 - a'; echo 1..1"
}
one many 'for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do cat /dev/null; done; echo "ok 1 - a"; echo 1..1'
started=$(awk '$1 == "processes" { print $2 }' /proc/stat)
export TEST_BEGAN="$started"
tally many
ended=$(awk '$1 == "processes" { print $2 }' /proc/stat)
told=$(tail -n 2 "$out/output" | sed -n '1s/^\([0-9]*\) processes were started meanwhile on this machine$/\1/p')
[ "${told:-0}" -gt 20 ] && [ "$told" -lt $((ended - started)) ] && [ "$(tail -n 1 "$out/output")" = "1 passed, 0 failed" ]
result $? "the number of processes is told: $told"
unset TEST_BEGAN

# Times: the longest of the list first, before it what is not in it; of quick ones, none that took longer or is not in
# it.
one slow 'echo "ok 1 - a"; i=0; while [ $i -lt 300000 ]; do i=$((i + 1)); done; echo 1..1'
printf '%s\n' "9.5 $out/tests/skip.t" "20 $out/tests/good.t" "0.5 $out/tests/slow.t" >"$out/known"
export TALLY_TIMES="$out/known" TALLY_STARTS="$out/budgets" TEST_MEASURED="$PWD/$out/measured" TEST_TAKES="$PWD/$out/takes" TEST_KEPT="$PWD/$out/kept" TEST_STATE=
# order: in which they began, by what `prove` says.
order()
{
    sed -n 's|^.*/tests/\([a-z]*\)\.t \.\..*|\1|p' "$out/output" | paste -sd ' '
}
tally slow skip good bad
[ "$(order)" = "bad good skip slow" ]
result $? "tests begin in the order of their times, and before them what has none: $(order)"
[ "$(awk 'NR == 1 { print ($1 > 0.02), $3 }' "$out/takes.txt")" = "1 $out/tests/slow.t" ] && [ "$(wc -l <"$out/takes.txt")" -eq 4 ]
result $? "what each took is written down, the longest first"
TALLY_MOST=9 tally slow skip good bad
[ "$(order)" = slow ] && grep -q '^1 of the tests are not in tests/times, and left out$' "$out/output"
result $? "what takes longer than it may is left out, and what has no time, which is told: $(order)"
unset TALLY_TIMES

# What passed is not run again as long as nothing has changed; what failed is.
TEST_STATE=first
one good "echo run >>$out/runs; echo 'ok 1 - a'; echo 1..1"
one bad "echo run >>$out/bad_runs; echo 'ok 1 - a'; echo 'not ok 2 - b'; echo 1..2; exit 1"
one short "echo run >>$out/short_runs; echo 'ok 1 - a'; echo 1..2"
# ran GOOD BAD SHORT: how often they were run since the start.
ran()
{
    ran=
    for file in runs bad_runs short_runs; do
        times=0
        while read -r _; do
            times=$((times + 1))
        done <"$out/$file"
        ran="$ran$times "
    done
    [ "$ran" = "$1 $2 $3 " ]
}
tally good bad short
ran 1 1 1 && ! grep -q 'not run again' "$out/output"
result $? "the first time all are run: $ran"
tally good bad short
ran 1 2 2 && grep -q '^1 of 3 tests were not run again' "$out/output"
result $? "what passed was not run again, what failed or was incomplete was, and that is told: $ran"
[ "$(grep -c '^ok 1 - a$' "$out/log")" -eq 3 ]
result $? "what it printed is printed again"
TEST_STATE=second tally good
ran 2 2 2
result $? "found: a change, after which it is run again: $ran"
grep -q 'tests/good.t$' "$out/takes.txt"
result $? "what it took is written down each time"
TEST_STATE=

# Processes, counted where the kernel lets us: twenty of `many` and its shell, whatever runs beside it and is left
# behind.
one left 'sleep 100 & cat /dev/null; echo "ok 1 - a"; echo 1..1'
tally many left
many=$(awk '/many/ { print $2 }' "$out/takes.txt")
if [ "$many" = - ]; then
    echo "ok $((tests += 1)) # SKIP neither root nor a user may have a namespace of processes here"
else
    [ "$(awk '{ print $2, $3 }' "$out/takes.txt" | sort -n | tr '\n' ' ')" = "3 $out/tests/left.t 21 $out/tests/many.t " ]
    result $? "the processes of each test are counted: $many"
    many_of 139
    # budget TEXT LINE...: by this table the harness says this of the budgets, and fails if it says any.
    budget()
    {
        printf '%s\n' "${1%;*}" "${1#*;}" >"$out/budgets"
        shift
        tally many left
        budget_status=$?
        sed -n 's/^budget: //p' "$out/output" >"$out/said"
        printf '%s\n' "$@" | grep . | sed "s|^[a-z]*\.t|$out/tests/&|" | cmp -s - "$out/said" && [ $((budget_status != 0)) -eq $(($# != 0)) ]
    }
    budget "" "many.t started 141 processes; its budget in tests/starts is 100"
    result $? "found: one without a budget that starts many"
    # What these start is counted once: they passed, and are not run again.
    TEST_STATE=third
    many_of 29
    budget "10 $out/tests/many.t"
    result $? "one may start a tenth and 20 more than its budget"
    budget "9 $out/tests/many.t" "many.t started 31 processes; its budget in tests/starts is 9"
    result $? "found: one more"
    budget "10 $out/tests/many.t;33 all"
    result $? "all together may start a twentieth more than theirs"
    budget "10 $out/tests/many.t;32 all" "all tests started 34 processes; their budget in tests/starts is 32"
    result $? "found: one more"
fi
printf '#!/bin/sh\necho "0.1 -" >"$2"\nshift 2\nexec "$@"\n' >"$out/unmeasured" && chmod +x "$out/unmeasured"
TEST_STATE=
TEST_MEASURED=$PWD/$out/unmeasured tally good && grep -q '^processes are not counted: ' "$out/output" &&
    [ "$(tail -n 1 "$out/output")" = "1 passed, 0 failed, 1 skipped" ]
result $? "where they cannot be counted that is told, and skipped"
unset TALLY_STARTS TEST_MEASURED TEST_TAKES TEST_KEPT TEST_STATE

# What a turn is told by, and which a commit has.
turn()
{
    (cd "$out/turns" && turn_of 97 "" core)
}
mkdir -p "$out/turns/core/__pycache__"
echo a >"$out/turns/core/a.c"
unset TEST_TURN TEST_WHOLE
first=$(turn)
echo b >"$out/turns/core/__pycache__/a.pyc"
echo b >"$out/turns/core/README.md"
[ "$(turn)" = "$first" ] && echo b >"$out/turns/core/a.c" && [ "$(turn)" != "$first" ]
result $? "a turn follows from sources, not from texts and from what is left beside them"
[ "$(TEST_TURN=100 turn)" = 3 ] && [ "$(TEST_WHOLE=yes turn)" = all ] && [ "$(cd "$out/turns" && turn_of 97 all core)" = all ]
result $? "a turn can be told, and all"

# `quick` refuses the type that tcc compiles wrongly, and no other.
quick_source()
{
    echo "$1 number(const $1 x) { return x * x; }" >"$out/quick.c"
    (quick && program quick.o -c "$out/quick.c") 2>"$out/errors"
}
quick_source double && quick_source float && ! quick_source 'long double'
result $? "found: long double in what tcc compiles"

# unlike TABLE: its rows of tests with turns that are measured over too few of them: fewer than there are, and than take
# a minute by tests/times. Of a test whose turn takes more than 9 s nothing is asked.
unlike()
{
    awk '
        FILENAME == table { rows[++count] = $0; next }
        FILENAME == "tests/times" { seconds[$2] = $1; next }
        match($0, /^turns=[0-9]+$|turn=\$\(turn_of [0-9]+ /) {
            parts = substr($0, RSTART, RLENGTH)
            gsub(/[^0-9]/, "", parts)
            most[FILENAME] = parts + 0 > most[FILENAME] ? parts + 0 : most[FILENAME]
        }
        function least(a, b) { return a < b ? a : b }
        END {
            for (i = 1; i <= count; i++) {
                split(rows[i], row, " ")
                if (seconds[row[2]] > 9) continue
                affordable = int(60 / (seconds[row[2]] > 6 ? seconds[row[2]] : 6))
                if (row[3] + 0 < least(most[row[2]], affordable)) print rows[i]
            }
        }' table="$1" "$1" tests/times tests/*/*.t tests/check/*.sh
}
unlike tests/starts >"$out/unlike"
sed 's/^/# /' "$out/unlike"
[ ! -s "$out/unlike" ]
result $? "the budget of each test with turns is measured over them"
awk '{ print $1, $2, 1 }' tests/starts >"$out/fewer"
unlike "$out/fewer" >"$out/unlike"
[ "$(wc -l <"$out/unlike")" -gt 15 ] && grep -q ' tests/choose/choose.t 1$' "$out/unlike" && ! grep -q ' tests/check/layers.sh ' "$out/unlike"
result $? "found: those that are measured over one turn"

# state: the hash of a small folder, with a compiler of its own.
mkdir -p "$out/state/core" "$out/state/build" "$out/compiler"
printf '#!/bin/sh\n' >"$out/compiler/gcc" && chmod +x "$out/compiler/gcc"
state()
{
    (cd "$out/state" && PATH="$root/$out/compiler:$PATH" sh "$root/tests/host/state.sh")
}
root=$PWD
echo a >"$out/state/core/a"
before=$(state)
touch "$out/state/core/a" "$out/state/build/made"
[ "$(state)" = "$before" ] && [ ${#before} -eq 64 ]
result $? "the state of a folder does not change with a date, or what is built"
# changes NAME: it is another one than before.
changes()
{
    after=$(state)
    [ "$after" != "$before" ]
    result $? "found: $1"
    before=$after
}
echo b >"$out/state/core/a"
changes "a changed file"
mv "$out/state/core/a" "$out/state/core/b"
changes "another name"
chmod +x "$out/state/core/b"
changes "another mode"
echo >>"$out/compiler/gcc"
changes "another compiler"
CFLAGS=-O1
export CFLAGS
changes "another flag"
unset CFLAGS

# Two variants of the unit tests that differ in number. The files stand where the harness knows them by their place.
for variant in plain asan; do
    mkdir -p "$out/variants/build/tests/$variant/float"
    printf '#!/bin/sh\necho "ok 1 - a"; echo 1..1\n' >"$out/variants/build/tests/$variant/float/one"
    chmod +x "$out/variants/build/tests/$variant/float/one"
done
# variants: runs them.
variants()
{
    (cd "$out/variants" && TEST_BUILT=yes TALLY_LOG=log PERL5LIB="$root/tests" prove --harness Tally --exec "$root/tests/exec.sh" \
        build/tests/*/float/one >"$root/$out/output" 2>&1)
}
variants && [ "$(tail -n 1 "$out/output")" = "3 passed, 0 failed" ]
result $? "equal numbers of tests in two variants are one more test that passes"
printf '#!/bin/sh\necho "ok 1 - a"; echo "ok 2 - b"; echo 1..2\n' >"$out/variants/build/tests/asan/float/one"
! variants && [ "$(tail -n 1 "$out/output")" = "3 passed, 1 failed" ] && grep -q 'asan 2, plain 1' "$out/output"
result $? "found: a variant with another number of tests"

# A machine that lacks one of the tools that are asked for, clang, with a package manager and a user that are made up.
mkdir -p "$out/bin"
asked=$(sed -n 's|^    have \([a-z0-9+-]*\) .*echo .*|\1|p' tests/tools.sh | grep -vx clang)
# shellcheck disable=SC2046
ln -sf $(for tool in sh cut tr cat uname env ln mkdir tail perl grep flock as ld "$CC" $asked; do
    command -v "$tool"
done) "$out/bin"

# tools USER COMMAND: looks for the tools as the user of that number, where apt-get does COMMAND.
tools()
{
    printf '#!/bin/sh\necho %s\n' "$1" >"$out/bin/id"
    printf '#!/bin/sh\necho "$@" >>"%s/asked"\n[ "$1" = update ] || %s\n' "$out" "$2" >"$out/bin/apt-get"
    chmod +x "$out/bin/id" "$out/bin/apt-get"
    rm -f "$out/asked"
    PATH="$PWD/$out/bin" sh tests/tools.sh >"$out/output" 2>&1
}

! tools 1000 true && [ ! -f "$out/asked" ]
result $? "a user who may not install: fails, and installs nothing"
grep -q 'install it with: sudo apt-get install .* clang libclang-rt-dev *$' "$out/output"
result $? "it names the command that installs what is missing, and no more"
! tools 0 false && grep -q 'the installation failed: apt-get install .* clang' "$out/output"
result $? "an installation that fails is told"
! tools 0 true && grep -q 'still missing after the installation: clang' "$out/output"
result $? "an installation that brings nothing is told"
tools 0 "ln -s $(command -v clang) $out/bin/clang" && grep -q '^install .* clang' "$out/asked"
result $? "root installs what is missing"
[ "$(sed -n '1s/.*\(some minutes\).* [0-9]*\( MB\).*/\1\2/p; 2s/.* \(apt-get install\) .* clang .*/ \1/p' "$out/output" | tr -d '\n')" = \
    "some minutes MB apt-get install" ]
result $? "and says before what, how much and how long"
tools 0 false && [ ! -f "$out/asked" ]
result $? "nothing missing: nothing asked for"
finish
