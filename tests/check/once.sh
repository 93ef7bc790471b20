#!/bin/sh
# What stands before the compilers in the tests keeps each object once, under all that it follows from: the object is
# that of the compiler itself, and any change that could change it makes another.
. tests/host/test.sh
begin check/once
mkdir -p "$out/once/real" "$out/once/store" "$out/a" "$out/b"
store=$out/once/store

# shellcheck disable=SC2086
"$CC" $FLAGS tests/host/once.c -o "$out/once/once"
result $? "it builds"
real=$(PATH=$(echo "$PATH" | tr : '\n' | grep -v '/once$' | paste -sd :) command -v gcc)
log=$PWD/$out/log
# The compiler, and the part of it that compiles, tell when they run; the compiler not when it says which its parts are.
part=$("$real" -print-prog-name=cc1)
printf '#!/bin/sh\necho "$*" >>"%s"\nexec "%s" "$@"\n' "$log" "$part" >"$out/cc1"
cat >"$out/logged" <<END
#!/bin/sh
case \$* in
*-'###'*) "$real" "\$@" 2>&1 | sed 's|^ $part | $PWD/$out/cc1 |' >&2 ;;
*)
    echo "\$*" >>"$log"
    exec "$real" "\$@"
    ;;
esac
END
chmod +x "$out/cc1" "$out/logged"
ln -s once "$out/once/gcc" && ln -s "$PWD/$out/logged" "$out/once/real/gcc"
once=$out/once/gcc

# kept: the number of objects in the store.
kept()
{
    find "$store" -name '*.o' ! -name any.o | wc -l
}

# header FOLDER FACTOR [DATE]: writes part.h there. What is as new as the command is not kept, so this waits for the
# next date.
header()
{
    printf '#ifndef FACTOR\n#define FACTOR %s\n#endif\n' "$2" >"$out/$1/part.h"
    [ -z "${3-}" ] || touch -d "$3" "$out/$1/part.h"
    sleep 0.05
}

# compiles NUMBER NAME ARGUMENT...: the object is what the compiler makes, and the store then has so many.
compiles()
{
    number=$1
    name=$2
    shift 2
    "$once" "$@" -o "$out/once.o" && "$real" "$@" -o "$out/real.o" && cmp -s "$out/once.o" "$out/real.o" &&
        [ "$(kept)" -eq "$number" ]
    result $? "$name: the compiler's object, $number kept"
}

for folder in a b; do
    header $folder 3
    printf '#include "part.h"\nint f(int x);\nint f(int x)\n{\n    return FACTOR * x;\n}\n' >"$out/$folder/part.c"
done
compiles 1 "a source" -O1 -c "$out/a/part.c"
compiles 1 "the same again" -O1 -c "$out/a/part.c"
compiles 1 "the same elsewhere" -O1 -c "$out/b/part.c"
compiles 2 "another optimisation" -O2 -c "$out/a/part.c"
header b 5
compiles 3 "another header" -O1 -c "$out/b/part.c"
compiles 4 "another macro" -O1 -DFACTOR=7 -c "$out/a/part.c"
compiles 4 "with debug information, which names its folder" -g -O1 -c "$out/a/part.c"
cp "$out/a/part.c" "$out/a/whole.c"
compiles 5 "another name" -O1 -c "$out/a/whole.c"

# unasked NUMBER NAME ARGUMENT...: the same, and no compiler ran for it.
unasked()
{
    : >"$log"
    compiles "$@"
    ! grep -q . "$log"
    result $? "$2: the compiler is not asked"
}

# asked NUMBER NAME ARGUMENT...: the same, and it ran.
asked()
{
    : >"$log"
    compiles "$@"
    grep -q . "$log"
    result $? "$2: the compiler is asked"
}

unasked 5 "the same again" -O1 -c "$out/a/part.c"
grep -q '^l .* part\.h$' "$store"/*.list
result $? "a list has the header beside the source"
header a 9 '1 minute ago'
asked 6 "its header is another" -O1 -c "$out/a/part.c"
header a 8 '1 minute ago'
asked 7 "and another of the same date" -O1 -c "$out/a/part.c"
header a 3 '2 minutes ago'
unasked 7 "the header is as it was" -O1 -c "$out/a/part.c"
header b 3
unasked 7 "the same elsewhere" -O1 -c "$out/b/part.c"
header a 3 'next minute'
unasked 7 "the same header, with a date to come" -O1 -c "$out/a/part.c"
header a 2 'next minute'
asked 7 "a header that may have changed meanwhile is not kept" -O1 -c "$out/a/part.c"
asked 7 "nor the next time" -O1 -c "$out/a/part.c"
header a 3

# A header in a folder of -I, and then one of its name beside the source.
mkdir -p "$out/c" "$out/d" "$out/i"
cp "$out/a/part.h" "$out/i/part.h"
cp "$out/a/part.c" "$out/c/part.c"
cp "$out/a/part.c" "$out/d/part.c"
sleep 0.05
asked 8 "a header in a folder of -I" -O1 "-I$out/i" -c "$out/c/part.c"
unasked 8 "the same elsewhere" -O1 "-I$out/i" -c "$out/d/part.c"
unasked 8 "the folder before another flag" "-I$out/i" -O1 -c "$out/d/part.c"
header d 5
asked 9 "another that is found before it" -O1 "-I$out/i" -c "$out/d/part.c"
unasked 9 "the source without that" -O1 "-I$out/i" -c "$out/c/part.c"

printf 'const char *name(void);\nconst char *name(void)\n{\n    return __FILE__;\n}\n' | tee "$out/c/name.c" >"$out/d/name.c"
sleep 0.05
asked 10 "a source that names its folder" -O1 -c "$out/c/name.c"
asked 11 "the same elsewhere" -O1 -c "$out/d/name.c"
unasked 11 "the same again" -O1 -c "$out/c/name.c"

"$once" -O1 -MMD -MP -c "$out/a/part.c" -o "$out/listed.o" && [ "$(kept)" -eq 11 ] && grep -q "^$out/listed.o:" "$out/listed.d" &&
    grep -q "$out/a/part.h" "$out/listed.d"
result $? "the list of headers is written for what was kept as well"
mv "$out/listed.d" "$out/first.d" && : >"$log" && "$once" -O1 -MMD -MP -c "$out/a/part.c" -o "$out/listed.o" && ! grep -q . "$log" &&
    grep -q "^$out/listed.o: $out/a/part.c $out/a/part.h\$" "$out/listed.d" && grep -qx "$out/a/part.h:" "$out/listed.d"
result $? "and so without the compiler"
printf 'int f(int x);\nint main(void)\n{\n    return f(2) - 6;\n}\n' >"$out/a/main.c"
"$once" -O1 "$out/a/main.c" "$out/a/part.c" -o "$out/program" -lm && "$out/program" && [ "$(kept)" -eq 12 ]
result $? "a command that links keeps the object of each source"
mkdir -p "$out/quoted" && echo '#define FACTOR 4' >"$out/quoted/factor.h"
printf '#include "factor.h"\nint main(void)\n{\n    return FACTOR - 4;\n}\n' >"$out/a/quoting.c"
"$once" -O1 -iquote "$out/quoted" "$out/a/quoting.c" -o "$out/program" && "$out/program" && [ "$(kept)" -eq 13 ]
result $? "an option is kept with its folder"
! "$once" -O1 -c -DFACTOR=g "$out/a/part.c" -o "$out/none.o" 2>/dev/null &&
    [ ! -e "$out/none.o" ] && [ "$(kept)" -eq 13 ]
result $? "what does not compile fails, and nothing is kept"

# What the compiler starts is started without it, once it has said what that is: the same program, and another plan
# another one.
cat "$out/a/part.c" >"$out/a/further.c"
"$once" -O1 "$out/a/main.c" "$out/a/further.c" -o "$out/program" -lm
: >"$log"
"$once" -O1 -DFACTOR=3 "$out/a/main.c" "$out/a/further.c" -o "$out/program" -lm && ! grep -qv '^-quiet ' "$log" && [ "$(grep -c . "$log")" -eq 2 ] &&
    "$real" -O1 -DFACTOR=3 "$out/a/main.c" "$out/a/further.c" -o "$out/real.program" -lm && cmp -s "$out/program" "$out/real.program"
result $? "two sources are compiled and linked by the compiler's parts alone: its program"
mkdir "$out/several" "$out/several/real"
: >"$log"
(cd "$out/several" && "../../../../../$once" -O1 -DFACTOR=3 -c ../a/main.c ../a/further.c && cd real && "$real" -O1 -DFACTOR=3 -c ../../a/main.c ../../a/further.c) &&
    ! grep -q . "$log" && cmp "$out/several/main.o" "$out/several/real/main.o" && cmp "$out/several/further.o" "$out/several/real/further.o"
result $? "several sources without a name for their objects: those that are there"

"$once" -O1 -c "$out/a/main.c" -o "$out/main.o" && : >"$log" && "$once" "$out/main.o" "$out/listed.o" -o "$out/program" && "$once" "$out/listed.o" "$out/main.o" -o "$out/program" &&
    ! grep -q . "$log" && "$real" "$out/listed.o" "$out/main.o" -o "$out/real.program" && cmp -s "$out/program" "$out/real.program"
result $? "so are objects: their program"
! "$once" "$out/main.o" -o "$out/program" 2>"$out/told" && grep -q 'undefined reference' "$out/told" && [ ! -e "$out/program" ]
result $? "what does not link fails, and there is no program"
# Six at once make each its own object.
mkdir -p "$out/many" && : >"$out/wrong"
for n in 1 2 3 4 5 6; do
    printf 'int f(int x);\nint f(int x)\n{\n    return %d * x;\n}\n' $n >"$out/many/$n.c"
    "$once" -O1 -c "$out/many/$n.c" -o "$out/many/$n.o" 2>>"$out/wrong" || echo "$n fails" >>"$out/wrong" &
done
wait
for n in 1 2 3 4 5 6; do
    "$real" -O1 -c "$out/many/$n.c" -o "$out/real.o" && cmp "$out/many/$n.o" "$out/real.o" >>"$out/wrong" 2>&1 || echo "$n differs" >>"$out/wrong"
done
[ ! -s "$out/wrong" ]
result $? "six compilations at once"

for file in "$store"/*.plan; do
    sed -i 's/-O1/-O0/' "$file"
done
"$once" -O1 -DFACTOR=6 -c "$out/a/part.c" -o "$out/once.o" && "$real" -O1 -DFACTOR=6 -c "$out/a/part.c" -o "$out/real.o" && ! cmp -s "$out/once.o" "$out/real.o"
result $? "found: a plan that is another"

# That the store is asked at all: another object in the place of one of its own is what is then handed out.
object=$(find "$store" -name '*.o' | head -n 1)
for file in "$store"/*.o; do
    echo planted >"$file"
done
"$once" -O1 -c "$out/a/part.c" -o "$out/taken.o" && grep -qx planted "$out/taken.o" && [ -n "$object" ]
result $? "found: an object in the store that is another"
finish
