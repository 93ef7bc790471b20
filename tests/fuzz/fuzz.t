#!/bin/sh
# What comes from outside, tried by libFuzzer, which changes texts and packets so that they reach new branches: no error
# of memory, no undefined behaviour, no leak, no run without an end. NAME.c is a fuzzer, NAME/ what it begins with, with
# all that was found once. Of four turns that of scenes has two; the others have one each, of 5 s. `sh tests/fuzz/fuzz.t
# 3600` runs each for an hour, with the whole of isoc as one more.
. tests/host/test.sh
begin fuzz/fuzz
seconds=${1:-5}
case ${1:+all} in
all) turn=all ;;
*) turn=$(turn_of 4) ;;
esac
echo "# turn $turn of the fuzzers"
FUZZ="-std=gnu11 -O0 -g1 $NUMERICS -D_POSIX_C_SOURCE=200809L -DISO_REAL_DOUBLE -I.
    -fsanitize=address,undefined"

# objects FOLDER SOURCE...: compiled for a fuzzer into $out/FOLDER.
objects()
{
    folder=$out/$1
    shift
    mkdir -p "$folder"
    for source in "$@"; do
        # shellcheck disable=SC2086
        clang $FUZZ -fsanitize=fuzzer-no-link -c "$source" -o "$folder/$(echo "$source" | tr / _).o" || return 1
    done
}

# joint_source NAME SOURCE...: the file $out/NAME.c, which has them all, since most of what a compiler does is the same
# for each.
joint_source()
{
    joint_name=$1
    shift
    printf '#include "%s"\n' "$@" >"$out/$joint_name.c"
}

# linked NAME OBJECT...: the fuzzer $out/NAME.
linked()
{
    linked_name=$1
    shift
    # shellcheck disable=SC2086
    clang $FUZZ -fsanitize=fuzzer "$@" -o "$out/$linked_name" -lm
}

# fuzz NAME OPTION...: runs it; what it says stands in $out/said.
fuzz()
{
    fuzz_name=$1
    shift
    FUZZ_OUT=$out/plant "$out/$fuzz_name" -close_fd_mask=3 -timeout=300 -rss_limit_mb=1500 -artifact_prefix="$out/" "$@" \
        >"$out/said" 2>&1
}

# fuzzed NAME TURNS FOLDER [OPTION...]: all that was found once, which this folder has; then new ones, for so many
# seconds, if it has one of these turns.
fuzzed()
{
    name=$1
    turns=$2
    once=$3
    shift 3
    mkdir -p "$out/corpus_$name"
    fuzz "$name" -runs=0 "$once"
    result $? "$name: all that was found once"
    case " $turns all " in
    *" $turn "*) ;;
    *) return ;;
    esac
    fuzz "$name" "$@" -print_final_stats=1 -max_total_time="$seconds" "$out/corpus_$name" "$once"
    status=$?
    sed -n -e 's/^INFO: Seed/# seed/p' -e 's/^stat::number_of_executed_units/# runs/p' "$out/said"
    result $status "$name: for $seconds s"
    [ $status -eq 0 ] || tail -n 60 "$out/said" | sed 's/^/# /'
}

# Scenes. The fuzzer begins with those of models/, and knows the words that they are made of.
mkdir -p "$out/corpus_scene" && cp models/*.scene models/effects/*.scene tests/isoc/scene/*.scene "$out/corpus_scene" &&
    cat "$out"/corpus_scene/*.scene | grep -v '^ *#' | grep -oE '[A-Za-z_]{2,}' | sort | uniq -c |
    awk '$1 > 1 { print "\"" $2 "\"" }' >"$out/words" &&
    joint_source base tools/isoc/base/*.c && joint_source scene $(ls tools/isoc/scene/*.c | grep -v '/lexer\.c$\|/parse_output\.c$') &&
    objects scene_objects tests/fuzz/scene.c "$out/base.c" "$out/scene.c" tools/isoc/scene/lexer.c tools/isoc/scene/parse_output.c \
        build/obj/tools/isoc/*_files.c &&
    linked scene "$out"/scene_objects/*.o
result $? "the parser of scenes as a fuzzer"
fuzzed scene '0 1' tests/fuzz/scene -dict="$out/words" -max_len=4096

# A parser with two defects: a point that nothing follows is a name of no character, for ever, which the fuzzer found;
# and a list of words has room for one.
mkdir -p "$out/others" && cp "$out"/scene_objects/*.o "$out/others" && rm "$out"/others/*lexer.c.o "$out"/others/*parse_output.c.o &&
    sed 's/ && is_letter(look(&l, 1)))) {$/)) {/' tools/isoc/scene/lexer.c >"$out/lexer.c" &&
    sed 's/words\[QUANTITY_ROWS\]/words[1]/' tools/isoc/scene/parse_output.c >"$out/parse_output.c" &&
    objects planted "$out/lexer.c" "$out/parse_output.c"
result $? "two planted defects"

# control NAME OTHER ERROR [OPTION]: NAME.c with its defect, and the other file as it is; NAME.scene finds it.
control()
{
    linked "planted_$1" "$out"/others/*.o "$out"/planted/*"$1.c.o" "$out"/scene_objects/*"$2.c.o" &&
        ! fuzz "planted_$1" ${4-} "tests/fuzz/scene/$1.scene" && grep -q "ERROR: .*$3" "$out/said"
    result $? "control: the defect of $1 is found"
}
control lexer parse_output timeout -timeout=1
control parse_output lexer stack-buffer-overflow

# Packets and frames of XCP. A defect: the last packet of a block may be shorter than what it says.
slave="tests/fuzz/xcp.c core/xcp/access.c core/xcp/daq.c core/xcp/measure.c core/xcp/stimulation.c core/xcp/example_lock.c
    core/xcp/transport.c"
# shellcheck disable=SC2086
objects xcp_objects $slave core/xcp/slave.c && objects xcp_transfer core/xcp/transfer.c &&
    linked xcp "$out"/xcp_objects/*.o "$out"/xcp_transfer/*.o
result $? "the slave of XCP as a fuzzer"
fuzzed xcp 2 tests/fuzz/xcp -max_len=1024
sed 's/x->length < 2 + count/x->length < 2/' core/xcp/transfer.c >"$out/transfer.c" && objects xcp_planted "$out/transfer.c" &&
    linked planted_xcp "$out"/xcp_objects/*.o "$out"/xcp_planted/*.o && ! fuzz planted_xcp -runs=200000 tests/fuzz/xcp
result $? "control: the defect of a block is found"

# The link: its frames, its commands, and snapshots, of a plant by adams. A defect: a snapshot whose order grows beyond
# the last, which the fuzzer found.
plant="tests/fuzz/link.c core/link/link.c core/link/command.c core/link/frame.c core/runtime/loop.c core/runtime/control.c
    core/application/stream.c"
# shellcheck disable=SC2086
objects link_objects $plant && objects link_snapshot core/runtime/snapshot.c &&
    linked link "$out"/link_objects/*.o "$out"/link_snapshot/*.o
result $? "a plant with a link as a fuzzer"
fuzzed link 3 tests/fuzz/link -max_len=512
sed 's/order + \*starting <=/order <=/' core/runtime/snapshot.c >"$out/snapshot.c" && objects link_planted "$out/snapshot.c" &&
    linked planted_link "$out"/link_objects/*.o "$out"/link_planted/*.o && ! fuzz planted_link -runs=0 tests/fuzz/link &&
    grep -q 'out of bounds' "$out/said"
result $? "control: the defect of a snapshot is found"

# The whole of isoc, which takes clang a minute.
if [ "$seconds" -gt 60 ]; then
    # shellcheck disable=SC2086,SC2046
    mkdir -p "$out/corpus_compiler" "$out/compiler_objects" && cp "$out"/corpus_scene/*.scene "$out/corpus_compiler" &&
        objects compiler_objects tests/fuzz/compiler.c $(find tools/isoc -name '*.c' ! -name main.c) build/obj/tools/isoc/*_files.c &&
        clang $FUZZ -fsanitize=fuzzer-no-link -Dmain=isoc_main -c tools/isoc/main.c -o "$out/compiler_objects/main.o" &&
        linked compiler "$out"/compiler_objects/*.o
    result $? "isoc as a fuzzer"
    fuzzed compiler all tests/fuzz/scene -dict="$out/words" -max_len=4096
fi

finish
