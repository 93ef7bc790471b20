#!/bin/sh
# The harness counts what it must: passed, failed, crashed, without a plan, skipped; and tells a failure by its status.
. tests/host/test.sh
begin check/harness
mkdir -p "$out/tests"
# What the harness that runs this test was told is no concern of the one that is tried.
unset TEST_TAKES TEST_KEPT TEST_STATE TALLY_MOST

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

cp tests/conftest.py "$out/tests" && printf 'import pytest\n\n\ndef test_good(seed):\n    assert seed\n\n\ndef test_bad():\n    assert 1 == 2\n\n\ndef test_skip():\n    pytest.skip("no need")\n' >"$out/tests/test_three.py"
TALLY_LOG="$out/log" PERL5LIB=tests prove --harness Tally --merge --exec tests/exec.sh "$out/tests/test_three.py" >"$out/output" 2>&1
[ $? -ne 0 ] && [ "$(tail -n 1 "$out/output")" = "1 passed, 1 failed, 1 skipped" ] && grep -q 'not ok 3 - test_bad$' "$out/output" &&
    grep -q '# E *assert 1 == 2' "$out/output" && grep -q 'ok 2 - test_skip # SKIP .*no need' "$out/log"
result $? "a test in Python: what passes, fails, and is skipped"

tally good bad
grep -q 'not ok 2 - this one fails' "$out/output" && grep -q '# for a reason' "$out/output"
result $? "what failed is shown, with its comments"
grep -qx 'ok 2 - b' "$out/log" && grep -qx 'not ok 2 - this one fails' "$out/log"
result $? "everything printed stands in the log"

# Times: the longest of the list first, before it what is not in it; of quick ones, none that took longer or is not in
# it.
one slow 'echo "ok 1 - a"; i=0; while [ $i -lt 300000 ]; do i=$((i + 1)); done; echo 1..1'
printf '%s\n' "9.5 $out/tests/skip.t" "20 $out/tests/good.t" "0.5 $out/tests/slow.t" >"$out/known"
export TALLY_TIMES="$out/known" TEST_TAKES="$PWD/$out/takes" TEST_KEPT="$PWD/$out/kept" TEST_STATE=
# order: in which they began, by what `prove` says.
order()
{
    sed -n 's|^.*/tests/\([a-z]*\)\.t \.\..*|\1|p' "$out/output" | paste -sd ' '
}
tally slow skip good bad
[ "$(order)" = "bad good skip slow" ]
result $? "tests begin in the order of their times, and before them what has none: $(order)"
[ "$(awk 'NR == 1 { print ($1 > 0.02), $2 }' "$out/takes.txt")" = "1 $out/tests/slow.t" ] && [ "$(wc -l <"$out/takes.txt")" -eq 4 ]
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

unset TEST_TAKES TEST_KEPT TEST_STATE

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
