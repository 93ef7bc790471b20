#!/bin/sh
# A plant beside other firmware, by what its scene says of the loop and by what it is called. Each policy is refused
# with its place, with and without --name; what is accepted compiles alone in an empty folder, by gcc and by clang, and
# moves bit for bit as with make run, also where there are two. A name is refused, or hides nothing: names of the
# headers of three compilers, keywords, headers of core, and words that the generated code itself begins with.
. tests/host/test.sh
. tests/host/project.sh
begin firmware_alone
one_isoc
project
root=$PWD
strict="-std=c11 -Wall -Wextra -Wpedantic -Werror $NUMERICS"

# of_scene FILE: the scene of what follows; $name is its name.
of_scene()
{
    base=$1
    name=${1##*/}
    name=${name%.scene}
    base_text=$(cat "$base")
    base_lines=$(wc -l <"$base")
}

# policy NAME LINE...: the scene with these lines, $out/NAME.scene.
policy()
{
    policy_name=$1
    shift
    printf '%s\n' "$base_text" "$@" >"$out/$policy_name.scene"
}

# standalone NAME [OPTION...]: isoc on that scene, into an empty folder, $out/alone.
standalone()
{
    standalone_scene=$out/$1.scene
    shift
    [ ! -e "$out/alone" ] || rm -r "$out/alone"
    isoc "$out/summary" "$out/errors" "$standalone_scene" -o "$out/alone" --standalone "$@"
}

# error_at LINE COLUMN: whether isoc found an error there of what --standalone has no place for.
error_at()
{
    while IFS= read -r error; do
        case $error in
        *"refused.scene:$1:$2: error: "*--standalone*) return 0 ;;
        esac
    done <"$out/errors"
    return 1
}

# moves COMPILER FLAGS INSTANCES: the folder compiles alone, and each instance ends with the hash of make run.
moves()
{
    cp tests/use/firmware/alone.c core/runtime/hash.h "$out/alone"
    # shellcheck disable=SC2086
    (cd "$out/alone" && $1 $strict -O1 $2 -I. ./*.c -o alone && exec ./alone >hashes) 2>"$out/errors" || return
    instances=0
    while read -r moved; do
        [ "$moved" = "$hash" ] || return
        instances=$((instances + 1))
    done <"$out/alone/hashes"
    [ $instances -eq "$3" ]
}

while read -r scene seconds; do
    of_scene "$scene"
    policy accepted ''
    isochron run "$root/$out/accepted.scene" --seconds $seconds && [ "$(value ticks)" = 1000 ]
    good=$?
    hash=$(value hash)
    expect $good "$name: make run, $hash"
    for compiler in gcc clang; do
        standalone accepted && moves $compiler '' 1
        result $? "the same alone, by $compiler"
        standalone accepted --name swing && moves $compiler -DNAMED 2
        result $? "twice with a name, by $compiler"
    done
    [ -e "$out/swinging" ] || echo "$hash" >"$out/swinging"
    for named in '' '--name swing'; do
        # shellcheck disable=SC2086
        policy accepted '' && standalone accepted $named && rm -rf "$out/without" && mv "$out/alone" "$out/without" &&
            policy accepted 'overrun count; publish at_once' && standalone accepted $named &&
            diff -r "$out/without" "$out/alone" >"$out/errors"
        result $? "${named:-without --name}: what the defaults say adds no byte"
    done
    while read -r column line; do
        policy refused "$line"
        for named in '' '--name swing'; do
            # shellcheck disable=SC2086
            ! standalone refused $named && [ ! -e "$out/alone" ] && error_at $((base_lines + 1)) "$column"
            expect $? "$name ${named:-without --name}: refused with its place: $line"
        done
    done <<POLICIES
1 overrun catch_up 3
1 overrun stop
1 overrun degrade { method euler; after 9 ticks }
1 overrun degrade { hold; after 9 ticks }
7 grace 10 ticks
1 publish next_tick
1 histogram
POLICIES
done <<END
models/pendulum.scene 1
models/dc_motor_bench.scene 0.1
END
of_scene models/pendulum.scene
policy refused histogram 'publish next_tick'
! standalone refused && [ "$(grep -c ': error: ' "$out/errors")" -eq 2 ]
result $? "two policies are two errors"
! isoc "$out/summary" "$out/errors" "$out/refused.scene" -o "$out/alone" --name swing && [ ! -e "$out/alone" ]
result $? "refused also with --name alone"

# A plant that is other than the program's own is found.
policy other 'substeps 2'
read -r hash <"$out/swinging" && standalone other --name swing && ! moves gcc -DNAMED 2 && [ -s "$out/alone/hashes" ]
result $? "found: a plant that moves otherwise"

# taken: $taken are those of the words that are read which isoc takes as names, by the function that says so.
program names tests/use/firmware/names.c tools/isoc/emit/prefix.c tools/isoc/base/arena.c build/obj/tools/isoc/core_files.o
result $? "what tells names of plants builds"
taken()
{
    taken=$("$out/names")
}

# refused WORD: as a name, and nothing is written.
refused()
{
    ! isoc "$out/summary" "$out/errors" models/pendulum.scene -o "$out/named" --name "$1" &&
        IFS= read -r refused_by <"$out/errors" && [ ! -e "$out/named" ] || return
    case $refused_by in
    *--name*) ;;
    *) return 1 ;;
    esac
}

# all_refused WHAT: each of the words in $out/words; the first of them by isoc itself.
all_refused()
{
    read -r first <"$out/words" && refused "$first" && taken <"$out/words" && [ -z "$taken" ]
    all_refused=$?
    read_words=0
    while read -r _; do
        read_words=$((read_words + 1))
    done <"$out/words"
    [ $all_refused -eq 0 ] && [ "$read_words" -gt 0 ]
    result $? "refused: $read_words $1${taken:+, but for $taken}"
}

# What the headers of C need, of each compiler, as far as a file beside the program could hide it.
c_headers="assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign stdarg stdatomic
    stdbool stddef stdint stdio stdlib stdnoreturn string tgmath threads time uchar wchar wctype"
echo "$c_headers" | tr -s ' ' '\n' >"$out/headers"
for header in $c_headers; do
    printf '#if __has_include(<%s.h>)\n#include <%s.h>\n#endif\n' "$header" "$header"
done >"$out/c.c"
for compiler in gcc clang arm-none-eabi-gcc; do
    roots=$($compiler -xc -E -v - </dev/null 2>&1 | sed -n '/^#include </,/^End/s/^ //p' | xargs realpath)
    $compiler -M -MG "$out/c.c" | tr -s ' \\' '\n\n' | grep '\.h$' | xargs realpath -q | while read -r path; do
        folder=${path%/*}
        name=${path##*/}
        case "
$roots
" in
        *"
$folder
"*) echo "${name%.h}" ;;
        esac
    done
done | grep -xE '[a-z][a-z0-9_]*' >>"$out/headers"
sort -u "$out/headers" >"$out/words"
all_refused "names of headers that gcc, clang and the board's compiler read for those of C"
[ "$read_words" -gt 33 ] && grep -qx features "$out/words"
result $? "among them those that others include"
for path in core/numbers/*.h core/methods/*.h core/runtime/plant.h core/runtime/tick.h; do
    path=${path##*/}
    echo "${path%.h}"
done >"$out/words"
all_refused "headers of core"
# A word is a keyword where it cannot be the name of a variable.
tr -cs 'a-z0-9_' '\n' <tools/isoc/emit/prefix.c | grep -xE '[a-z][a-z0-9_]*[a-z0-9]' | sort -u >"$out/candidates"
sed 's/.*/int &;/' "$out/candidates" >"$out/word.c"
{
    gcc -std=c11 -fsyntax-only "$out/word.c" 2>&1
    clang++ -std=c++20 -ferror-limit=0 -xc++ -fsyntax-only "$out/word.c" 2>&1
} | sed -n 's/.*word\.c:\([0-9]*\):.*error: .*/\1p/p' | sort -u >"$out/lines"
sed -n -f "$out/lines" "$out/candidates" >"$out/words"
[ "$(wc -l <"$out/words")" -gt 80 ]
result $? "gcc and clang++ know $(wc -l <"$out/words") keywords"
all_refused "of them"
printf '%s\n' main cart_ a__b iso isolated >"$out/words"
all_refused "other words"

# Words that the code of a plant begins with.
isoc "$out/summary" "$out/errors" models/cart_pole_drive.scene -o "$out/words.d" --name swing
grep -ohE '\b[a-z][a-z0-9]*_' "$out/words.d/swing.c" "$out/words.d/swing.h" | sort -u | sed 's/_$//' | grep -v '^iso\|^swing' >"$out/words"
bad=
tried=0
taken <"$out/words"
# shellcheck disable=SC2086
for word in $taken; do
    tried=$((tried + 1))
    isoc "$out/summary" "$out/errors" models/cart_pole_drive.scene -o "$out/named_$word" --name "$word" --standalone &&
        printf '#include "%s.h"\n#include "core/runtime/tick.h"\n#include <stdio.h>\n#include <stdlib.h>\nint main(void) { return 0; }\n' \
            "$word" >"$out/named_$word/user.c" &&
        (cd "$out/named_$word" && exec clang $strict -fsyntax-only -I. "$word.c" user.c) 2>"$out/errors" ||
        bad="$bad $word"
done
[ -z "$bad" ] && [ $tried -gt 0 ]
expect $? "$tried words that the generated code begins with are good names${bad:+, but for$bad}"

# The count of turns around its limit, in a plant that a sanitizer watches.
mkdir -p "$out/turns"
sed 's/^    axis z.*/&; continuous; speed 3000 rpm/' models/pendulum.scene | sed 's/^    start.*//' >"$out/turns.scene"
echo 'output turned = turns of pivot' >>"$out/turns.scene"
isoc "$out/summary" "$out/errors" "$out/turns.scene" -o "$out/turns" --name swing --standalone &&
    cat >"$out/turns/turns.c" <<'END' &&
#include "swing.h"
#include "core/runtime/tick.h"
int main(void)
{
    static swing_memory memory;
    const iso_plant swing = swing_plant(&memory);
    iso_plant_start(&swing);
    memory.turns[0] = INT32_MAX - 1;
    for (uint32_t tick = 0; tick < 100; tick++) {
        if (iso_plant_tick(&swing, tick) < SWING_STATES) {
            return 1;
        }
    }
    return !(memory.turns[0] < INT32_MIN + 8 && memory.turns[0] > INT32_MIN && swing.y[SWING_Y_TURNED] < (real)-2e9);
}
END
    (cd "$out/turns" && gcc $strict -fsanitize=undefined -fno-sanitize-recover=all -I. ./*.c -o turns && ./turns) 2>"$out/errors"
expect $? "turns go on behind the largest count"
sed -i 's/iso_counted_turns(\(memory->turns\[0\]\), /(\1 + /' "$out/turns/swing.c"
! (cd "$out/turns" && gcc $strict -fsanitize=undefined -fno-sanitize-recover=all -I. ./*.c -o turns && ./turns) 2>"$out/errors" &&
    grep -q 'signed integer overflow' "$out/errors"
expect $? "found: a count that overflows"
finish
