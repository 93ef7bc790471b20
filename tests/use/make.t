#!/bin/sh
# What make does with its variables and with paths, and with many makes at once; that a program that is linked is there
# meanwhile, and that a test has the tools of its sources.
. tests/host/test.sh
. tests/host/project.sh
begin check/make
project
unoptimised

newline='
'

# told PATTERN ARGUMENT...: fails, and says that.
told()
{
    text=$1
    shift
    ! call "$@" && says "$text"
    status=$?
    name=$*
    expect $status "told, with '$text': make ${name%%"$newline"*}"
}

# told_inside PATTERN ARGUMENT...: the same of the make that has the recipe of run, whose folder is locked for it.
told_inside()
{
    ISOCHRON_LOCKED='run build/host/float/'$inside told "$@"
}

# runs NAME ARGUMENT...: the run ends, with a hash, $hash_now.
runs()
{
    name=$1
    shift
    call run SECONDS=0.1 "$@" && read_value hash && hash_now=$value && [ -n "$hash_now" ]
    expect $? "$name: runs"
}

# helped FILE...: whether make help lists every goal that these files name as a command.
helped()
{
    make --no-print-directory help >"$out/help" &&
        grep -oh '`make [a-z0-9-]*[` ]' "$@" | tr -d '`' | cut -d ' ' -f 2 | sort -u >"$out/goals" && [ -s "$out/goals" ] &&
        help=$newline$(cat "$out/help") &&
        while read -r goal; do
            case $help in
            *"$newline    make $goal "*) ;;
            *) echo "# make $goal" && return 1 ;;
            esac
        done <"$out/goals"
}
find . -path ./build -prune -o -name '*.md' -print >"$out/texts"
# shellcheck disable=SC2046
helped $(cat "$out/texts") && grep -qx test "$out/goals" && grep -qx check "$out/goals" && grep -qx monitor "$out/goals"
result $? "make help lists every goal that a text names: $(tr '\n' ' ' <"$out/goals")"
echo '`make tea`' >"$out/tea.md"
! helped "$out/tea.md" >"$out/output"
result $? "control: a goal that it does not list is noticed"

told "SCEEN is not known (did you mean SCENE?)" run SCEEN=models/pendulum.scene
told "STEPS is not known (did you mean STEP?)" STEPS=1ms
told "SCEEN is not known (did you mean SCENE?)" clean SCEEN=models/pendulum.scene
told "WEATHER is not known;" run WEATHER=fair
told "SECONDS has no effect on ?make size?" size SECONDS=3
told "METHOD has no effect on ?make cost?" cost METHOD=heun
told "make cost is of the cortex-m4f" cost TARGET=host
told "make chains is of the cortex-m4f" chains REAL=double
told "REAL=double is refused on TARGET=atmega1284p: its compiler has no double" run TARGET=atmega1284p REAL=double
call -n digits && grep -q 'build/tests/requests' "$out/output"
expect $? "the table of digits builds the programs that it calls"
call -n run TARGET=cortex-m0 REAL=double
expect $? "it is not where the compiler has it"
told "METHOD has no effect on ?make report?" report METHOD=heun
told "TOLERANCE has no effect on METHOD=rk4" run METHOD=rk4 TOLERANCE=1e-6
told "has no effect on rk4" run SCENE=models/pendulum.scene TOLERANCE=1e-6
told "TOLERANCE has no effect on METHOD=rk4" run SCENE=models/oscillator.c TOLERANCE=1e-6
told "TOLERANCE=0 is no tolerance" run SCENE=models/oscillator.c METHOD=adams TOLERANCE=0
inside=oscillator
for tolerance in -1e-6 fine 1e; do
    told_inside "TOLERANCE=$tolerance is no tolerance" run SCENE=models/oscillator.c METHOD=adams TOLERANCE=$tolerance
done
told "CHECKED is of a plant in C" run SCENE=models/pendulum.scene CHECKED=yes
told "INPUTS=some is unknown" run INPUTS=some
told "INPUTS has no effect on a plant in C" run SCENE=models/oscillator.c INPUTS=held
told "COMPENSATED=some is unknown" run SCENE=models/oscillator.c COMPENSATED=some
told "SCRIPT has no effect on TARGET=cortex-m4f" run TARGET=cortex-m4f SCRIPT=script
told "STEP=0 is no step" run SCENE=models/oscillator.c STEP=0
for step in 0.1us 2s 1.5ns 1e; do
    told_inside "STEP=$step is no step" run SCENE=models/oscillator.c STEP="$step"
done
told "SECONDS=0 is no time to run" run SECONDS=0
inside=double_pendulum
for seconds in 0.0 -1 1e-10 0x10 inf nan 1e300 '1 h' ''; do
    told_inside "SECONDS=$seconds is no time to run" run SECONDS="$seconds"
done
told "SCENE has a line break" run SCENE="$out/a
b.scene"
mkdir -p "$out/scenes"
cp models/pendulum.scene "$out/scenes/.scene"
told "has no name" run SCENE="$PWD/$out/scenes/.scene"

runs "TOLERANCE with METHOD=adams" METHOD=adams TOLERANCE=1e-6
runs "the environment has no effect" METHOD=rk4
hash=$hash_now
runs "PORT_CC is a compiler of the port's" PORT_CC=clang METHOD=rk4 && [ "$hash_now" = "$hash" ]
expect $? "with the same hash"
runs "SECONDS with a unit" METHOD=rk4 SECONDS='100 ms'
[ "$hash_now" = "$hash" ]
expect $? "it is as long as SECONDS=0.1"
TOLERANCE=1e-6 SCENE=models/absent.scene METHOD=absent TARGET=absent SECONDS=0 SCEEN=absent runs "variables of the environment" METHOD=rk4
[ "$hash_now" = "$hash" ]
expect $? "they have no effect"
LC_ALL=de_DE.UTF-8 LANG=de_DE.UTF-8 call -s --eval 'spoken: ; @echo "$$LC_ALL"' spoken && grep -qx C "$out/output"
expect $? "nor has the language of the user, by which an awk writes a comma in numbers"

strange="$PWD/$out/scenes/a \$b #c'd (e)"
mkdir -p "$strange"
for scene in models/pendulum.scene models/oscillator.c; do
    runs "$scene" SCENE=$scene
    hash=$hash_now
    name='x$y z'.${scene##*.}
    cp $scene "$strange/$name"
    runs "the same in $strange/$name" SCENE="$strange/$name" && [ "$hash_now" = "$hash" ]
    expect $? "with the same hash"
done
long=$(printf 'n%.0s' $(seq 130))
cp models/pendulum.scene "$out/scenes/$long.scene"
runs "a name of 130 characters on the Cortex-M4F" SCENE="$PWD/$out/scenes/$long.scene" TARGET=cortex-m4f

# Scenes of one file name in two folders have folders of their own, those of models/ the plain name.
mkdir -p "$out/scenes/a" "$out/scenes/b"
sed 's/start 90 deg/start 80 deg/' models/pendulum.scene >"$out/scenes/a/pendulum.scene"
sed 's/start 90 deg/start 70 deg/' models/pendulum.scene >"$out/scenes/b/pendulum.scene"
folders=
for scene in models "$PWD/$out/scenes/a" "$PWD/$out/scenes/b"; do
    runs "$scene/pendulum.scene" SCENE="$scene/pendulum.scene" && read_value trace && [ -s "$out/project/$value" ]
    folders="$folders ${value%/*}"
done
# shellcheck disable=SC2086
[ "$(printf '%s\n' $folders | sort -u | wc -l)" -eq 3 ] && case $folders in " build/host/float/pendulum "*) ;; *) false ;; esac
result $? "their folders differ, and that of the model has its name:$folders"

# What is run at once, from nothing built for it: one scene with other methods, steps and reals, and scenes of one name.
# A line is the arguments of make.
cat >"$out/runs" <<END
SCENE=models/pendulum.scene METHOD=rk4
SCENE=models/pendulum.scene METHOD=heun
SCENE=models/pendulum.scene METHOD=bdf4
SCENE=models/pendulum.scene STEP=2ms
SCENE=models/pendulum.scene STEP=4ms
SCENE=models/pendulum.scene REAL=double
SCENE=$PWD/$out/scenes/a/pendulum.scene
SCENE=$PWD/$out/scenes/b/pendulum.scene
END

# together ROUND...: all of the lines at once, once for each word; what a run printed stands in
# $out/together.ROUND.LINE.
together()
{
    rm -rf "$out/project/build/host" "$out"/together.*
    for round; do
        number=0
        while IFS= read -r line; do
            number=$((number + 1))
            # shellcheck disable=SC2086
            make -C "$out/project" --no-print-directory run SECONDS=0.2 $line >"$out/together.$round.$number" 2>&1 </dev/null &
        done <"$out/runs"
    done
    wait
}

# hash_in FILE: $hash is what a run printed there; fails where it has no 16 digits.
hash_in()
{
    hash=
    while read -r key rest; do
        [ "$key" != hash ] || hash=$rest
    done <"$1"
    case $hash in
    *[!0-9a-f]*) return 1 ;;
    ????????????????) ;;
    *) return 1 ;;
    esac
}

# own_hashes ROUND...: whether the runs of these rounds have the hashes of those that ran alone.
own_hashes()
{
    for round; do
        for number in 1 2 3 4 5 6 7 8; do
            hash_in "$out/alone.$number" && hash_alone=$hash && hash_in "$out/together.$round.$number" &&
                [ "$hash" = "$hash_alone" ] || return 1
        done
    done
}

hashes=
number=0
while IFS= read -r line; do
    number=$((number + 1))
    # shellcheck disable=SC2086
    make -C "$out/project" --no-print-directory run SECONDS=0.2 $line >"$out/alone.$number" 2>&1 </dev/null
    hash_in "$out/alone.$number" || continue
    case " $hashes " in
    *" $hash "*) ;;
    *) hashes="$hashes $hash" ;;
    esac
done <"$out/runs"
# shellcheck disable=SC2086
set -- $hashes
[ $# -eq 8 ] && [ $number -eq 8 ]
result $? "eight runs, one by one: eight hashes"
together 1 2 3
own_hashes 1 2 3
result $? "24 makes at once print each the hash of its own run"

# Without locks they meet.
printf '#!/bin/sh\nwhile [ "${1#-}" != "$1" ]; do [ "$1" != -E ] || shift; shift; done\nshift\nexec "$@"\n' >"$out/flock"
mkdir -p "$out/bin" && mv "$out/flock" "$out/bin/flock" && chmod +x "$out/bin/flock"
PATH=$PWD/$out/bin:$PATH
# Eight at once, and 24 where those did not meet.
together 1
! own_hashes 1 || { together 1 2 3 && ! own_hashes 1 2 3; }
result $? "found: makes that do not lock their folder"

# A linker that has begun to write, and waits until what stands at the tool's place has run; or that fails then.
compiler=${CC%% *}
cat >"$out/bin/${compiler##*/}" <<END
#!/bin/sh
for argument; do
    [ "\$before" != -o ] || output=\$argument
    before=\$argument
done
case \$output in
*.o | '') ;;
*)
    echo partly >"\$output"
    build/duration ns 3 1 1e18 >>"$PWD/$out/ran" 2>&1
    [ ! -e "$PWD/$out/fails" ] || exit 1
    ;;
esac
exec "$(command -v "$compiler")" "\$@"
END
chmod +x "$out/bin/${compiler##*/}"
# relinked: the tool is linked again; fails as make does.
relinked()
{
    : >"$out/ran"
    touch "$out/project/build/obj/tools/build/duration.o"
    call build/duration
}
# left: $left has the files of the tool, with what was left behind.
left()
{
    left=
    for file in "$out/project/build/duration"*; do
        left="$left ${file##*/}"
    done
}
call tools
before=$(ls -i "$out/project/build/duration")
relinked && read -r ran <"$out/ran" && [ "$ran" = 3000000000 ]
expect $? "while a tool is linked, the one before runs: $ran"
left && [ "$(ls -i "$out/project/build/duration")" != "$before" ] && [ "$left" = " duration" ]
result $? "the new one is another file, and nothing else is left:$left"
touch "$out/fails"
before=$(ls -i "$out/project/build/duration")
! relinked && left && [ "$(ls -i "$out/project/build/duration")" = "$before" ] && [ "$left" = " duration" ]
result $? "a tool that cannot be linked leaves the one before:$left"
rm "$out/fails"
sed 's|^link = .*|link = $(Q)$(1) -o $@|' Makefile >"$out/project/Makefile"
relinked
[ "$(cat "$out/ran")" != 3000000000 ]
result $? "found: a tool that is linked in place: $(sed 's/.*: //' "$out/ran" | tail -n 1)"
cp Makefile "$out/project/Makefile"

# Warnings are errors, but with flags of the user: gcc has other warnings with each optimisation.
{ cat tools/build/duration.c && echo "static int planted;"; } >"$out/project/tools/build/duration.c"
told planted build/duration
call build/duration CFLAGS=-O3 && grep -q 'warning.*planted' "$out/errors"
expect $? "with CFLAGS it is a warning"
finish
