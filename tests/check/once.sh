#!/bin/sh
# What stands before the compilers in the tests keeps each object once, under all that it follows from: the object is that of
# the compiler itself, and any change that could change it makes another.
. tests/host/test.sh
begin check/once
mkdir -p "$out/once/real" "$out/once/store" "$out/a" "$out/b"
store=$out/once/store

# shellcheck disable=SC2086
"$CC" $FLAGS tests/host/once.c -o "$out/once/once"
result $? "it builds"
real=$(PATH=$(echo "$PATH" | tr : '\n' | grep -v '/once$' | paste -sd :) command -v gcc)
log=$PWD/$out/log
printf '#!/bin/sh\necho "$*" >>"%s"\nexec "%s" "$@"\n' "$log" "$real" >"$out/logged" && chmod +x "$out/logged"
ln -s once "$out/once/gcc" && ln -s "$PWD/$out/logged" "$out/once/real/gcc"
once=$out/once/gcc

# kept: the number of objects in the store.
kept()
{
    find "$store" -name '*.o' | wc -l
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
    printf '#ifndef FACTOR\n#define FACTOR 3\n#endif\n' >"$out/$folder/part.h"
    printf '#include "part.h"\nint f(int x);\nint f(int x)\n{\n    return FACTOR * x;\n}\n' >"$out/$folder/part.c"
done
compiles 1 "a source" -O1 -c "$out/a/part.c"
compiles 1 "the same again" -O1 -c "$out/a/part.c"
compiles 1 "the same elsewhere" -O1 -c "$out/b/part.c"
compiles 2 "another optimisation" -O2 -c "$out/a/part.c"
printf '#define FACTOR 5\n' >"$out/b/part.h"
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
    result $? "$2: without the preprocessor"
}

# What is older than the command is known by its text.
cp "$out/a/part.h" "$out/first.h"
touch -d '1 minute ago' "$out"/a/part.[ch]
compiles 5 "the source once more, older" -O1 -c "$out/a/part.c"
unasked 5 "the same again" -O1 -c "$out/a/part.c"
grep -q "^p .* $out/a/part.h\$" "$store"/*.list
result $? "a list has the header"
printf '#define FACTOR 9\n' >"$out/a/part.h"
touch -d '1 minute ago' "$out/a/part.h"
compiles 6 "its header is another of the same date" -O1 -c "$out/a/part.c"
unasked 6 "the same again" -O1 -c "$out/a/part.c"
cp "$out/first.h" "$out/a/part.h"
touch -d '2 minutes ago' "$out/a/part.h"
unasked 6 "the header is as it was" -O1 -c "$out/a/part.c"
touch -d 'next minute' "$out/a/part.h"
: >"$log"
compiles 6 "a header that is newer than the command" -O1 -c "$out/a/part.c"
grep -q -- -E "$log"
result $? "control: then the preprocessor is asked"
touch -d '1 minute ago' "$out/a/part.h"

"$once" -O1 -MMD -MP -c "$out/a/part.c" -o "$out/listed.o" && [ "$(kept)" -eq 6 ] && grep -q "^$out/listed.o:" "$out/listed.d" &&
    grep -q "$out/a/part.h" "$out/listed.d"
result $? "the list of headers is written for what was kept as well"
mv "$out/listed.d" "$out/first.d" && : >"$log" && "$once" -O1 -MMD -MP -c "$out/a/part.c" -o "$out/listed.o" && ! grep -q . "$log" &&
    grep -q "^$out/listed.o: $out/a/part.c $out/a/part.h\$" "$out/listed.d" && grep -qx "$out/a/part.h:" "$out/listed.d"
result $? "and so without the preprocessor"
printf 'int f(int x);\nint main(void)\n{\n    return f(2) - 6;\n}\n' >"$out/a/main.c"
"$once" -O1 "$out/a/main.c" "$out/a/part.c" -o "$out/program" -lm && "$out/program" && [ "$(kept)" -eq 7 ]
result $? "a command that links keeps the object of each source"
mkdir -p "$out/quoted" && echo '#define FACTOR 4' >"$out/quoted/factor.h"
printf '#include "factor.h"\nint main(void)\n{\n    return FACTOR - 4;\n}\n' >"$out/a/quoting.c"
"$once" -O1 -iquote "$out/quoted" "$out/a/quoting.c" -o "$out/program" && "$out/program" && [ "$(kept)" -eq 8 ]
result $? "an option is kept with its folder"
! "$once" -O1 -c -DFACTOR=g "$out/a/part.c" -o "$out/none.o" 2>/dev/null &&
    [ ! -e "$out/none.o" ] && [ "$(kept)" -eq 8 ]
result $? "what does not compile fails, and nothing is kept"

# That the store is asked at all: another object in the place of one of its own is what is then handed out.
object=$(find "$store" -name '*.o' | head -n 1)
for file in "$store"/*.o; do
    echo planted >"$file"
done
"$once" -O1 -c "$out/a/part.c" -o "$out/taken.o" && grep -qx planted "$out/taken.o" && [ -n "$object" ]
result $? "found: an object in the store that is another"
finish
