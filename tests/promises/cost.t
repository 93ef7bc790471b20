#!/bin/sh
# isochron size and isochron stack: the double pendulum keeps its limits, and what breaks a limit or has no bound is
# found. The longest steps of the table of restarts: no other motion has a longer one.
. tests/host/test.sh
. tests/host/project.sh
begin check/cost
project

# By turns, with the argument `all` all: one of the two kinds of discontinuities, and one of three tolerances of adams.
turn=$(turn_of 6 "${1-}" core tools models)
echo "# turn $turn of the restarts and the tolerances"

# of_turn PARTS WORD...: of so many words that of this turn.
of_turn()
{
    of_turn_parts=$1
    shift
    [ "$turn" = all ] || shift $((turn % of_turn_parts))
    [ "$turn" = all ] && echo "$@" || echo "$1"
}

isochron size models/double_pendulum.scene && [ "$(value text | wc -w)" -gt 1 ]
expect $? "isochron size: the double pendulum's firmware keeps its limits"
case " $(value flags) " in *' -O2 -ffp-contract=off '*' -frename-registers '*) true ;; *) false ;; esac
expect $? "isochron size: the flags that its plant is compiled with: $(value flags)"
isochron size models/double_pendulum.scene --target host && ! printed step_text ''
expect $? "isochron size: on the host as well"
isochron stack models/double_pendulum.scene && [ "$(value stack_of_step)" -gt 0 ]
expect $? "isochron stack: the step's stack has a bound on the host"
isochron stack models/double_pendulum.scene --target cortex-m4f && [ "$(value stack_of_step)" -gt 0 ]
expect $? "isochron stack: and on the Cortex-M4F"

# size SYMBOL...: the verdict on a program of these sizes, given as lines of `nm -S`.
size()
{
    {
        printf '   text\t   data\t    bss\t    dec\t    hex\tfilename\n%s program\n' "$1"
        echo '00002000 A STACK_BYTES'
        echo '20000000 00000400 b trace_buffer'
        echo "00000100 $2 t step"
        echo "00000900 00000008 t derivative.constprop.0"
    } | awk -v limits=yes -f tools/measure/program_size.awk -f tools/measure/size.awk >"$out/output" 2>"$out/errors"
}

size '8192 100 9628 0 0' 000007f8
expect $? "at the limits: 8192 of text, 2048 of the step, 512 of data and bss"
! size '8193 100 9628 0 0' 000007f8
expect $? "found: a byte of text too many"
! size '8192 100 9628 0 0' 000007f9
expect $? "found: a byte of the step too many"
! size '8192 101 9628 0 0' 000007f8
expect $? "found: a byte of data too many"
! awk -v limits=yes -f tools/measure/program_size.awk -f tools/measure/size.awk </dev/null >/dev/null 2>"$out/errors"
expect $? "found: no sizes at all"

# deepest CODE: the verdict of isochron stack's second half on a step.
deepest()
{
    printf '%s\n' "$1" >"$out/step.c"
    $CC -std=c11 -O2 -fno-inline -fcallgraph-info=su -c "$out/step.c" -o "$out/step.o" &&
        awk -v function_name=step -f tools/measure/stack.awk "$out/step.ci" >"$out/output" 2>"$out/errors"
}

deepest 'static int leaf(volatile int *p) { volatile int a[256]; a[9] = *p; return a[9]; }
    static int other(volatile int *p) { volatile int a[16]; a[9] = *p; return a[9]; }
    int step(volatile int *p); int step(volatile int *p) { return leaf(p) + other(p); }'
expect $? "a step that calls two functions has a bound"
# An x86-64 leaf may keep 128 bytes below its stack, which isochron stack turns off.
[ "$(value stack_of_step)" -ge $((1024 - 128)) ] && [ "$(value stack_of_step)" -lt $((1024 + 64)) ]
expect $? "it is the deeper one's and not the sum"

# finds TEXT NAME CODE
finds()
{
    ! deepest "$3" && grep -q "$1" "$out/errors"
    expect $? "found: $2"
}

finds recursion recursion 'int step(volatile int *p); static int down(volatile int *p) { return *p ? step(p) + *p : 1; }
    int step(volatile int *p) { return down(p) * *p; }'
finds 'grows at run time' 'a frame that grows at run time' 'void use(char *); static void use_not(volatile char *p) { *p = 1; }
    void step(int n); void step(int n) { volatile char a[n]; use_not(a); }'
finds pointer 'a call through a pointer' 'extern int (*volatile f)(int); int step(int); int step(int n) { return f(n) + 1; }'
finds 'not known' 'a function of another file' 'int other(int); int step(int); int step(int n) { return other(n) + 1; }'
finds 'no function' 'no step at all' 'int leap(int n); int leap(int n) { return n; }'

# tables COMMAND...: in the copy, with the functions of the tables of costs; what they say is in $out/errors. `make
# stack` has made what programs share.
tables()
{
    (cd "$out/project" && export ISOCHRON_MADE=cortex-m4f/float && . tools/measure/board.sh && "$@") 2>"$out/errors"
}

# A restart has one number of instructions for every motion: from the horizontal, and from 10 deg with a push.
sed '0,/start 90 deg/s//start 10 deg\n    speed 3 rad\/s/' models/double_pendulum.scene >"$out/project/pushed.scene"
for method in ab4 abm4 abm4_pec abm4_pecece bdf4; do
    for discontinuity in $(of_turn 2 announced detected); do
        one=$(tables longest_step one models/double_pendulum.scene $method $discontinuity) &&
            other=$(tables longest_step other pushed.scene $method $discontinuity) && [ "$one" -eq "$other" ]
        result $? "$method, a discontinuity that is $discontinuity: $one instructions, and from another start $other"
    done
done

# noisy SIZE: the longest step of the plant that longest_step left in build/cost/adams, with noise of many sizes in its
# derivatives; where there is any, each tick begins at the same place, since the sum would leave the domain of the sine.
# Marsaglia (2003), Xorshift RNGs.
noisy()
{
    mkdir -p build/cost/noisy
    awk -v size="$1" '
        /^static void derivative\(/ && !noisy++ {
            print "extern real noise_size;\nreal noise_size = R(" size ");\nstatic real noise(void)\n{"
            print "    static uint32_t bits = 1;\n    bits ^= bits << 13;\n    bits ^= bits >> 17;\n    bits ^= bits << 5;"
            print "    return noise_size * (real)(int32_t)bits / (real)(UINT32_C(1) << (bits >> 8) % 32);\n}\n"
        }
        /^ *dx\[/ { sub(/;$/, " + noise();") }
        { print }
        /^static void forced\(/ { forced = 1 }
        forced && /plant_memory/ {
            print "    if (noise_size > R(0.0)) {\n        memory->x[0] = memory->x[1] = R(1.0);\n    }"
            forced = 0
        }' build/cost/adams/forced.c >build/cost/noisy/noisy.c
    cp build/cost/adams/plant.h build/cost/noisy
    seconds=5
    measure noisy/firmware build/cost/noisy/noisy.c ''
    awk '$1 == "execution" { most = $4 } $1 == "restart_execution" { print ($2 > most ? $2 : most) }' "$dir/measured"
}

# adams WHAT MOST LIMIT: a result.
adams()
{
    [ "${2:-0}" -gt 0 ] && [ "$2" -le "$3" ]
    result $? "adams, $1: ${2-} instructions, at most $3"
}

# The noise itself takes the same in every evaluation: the limit is that of a sub-step more, with noise of size 0.
forced=$(tables longest_step adams models/pendulum.scene adams announced) && silent=$(tables noisy 0.0) &&
    more=$(tables longest_step adams models/pendulum.scene adams announced 'tolerance 1e-30' 'substeps 9') && limit=$(tables noisy 0.0)
adams "the budget used in vain" "$forced" "$((more - 1))"
adams "the same with noise of size 0" "$silent" "$((limit - 1))"
for tolerance in $(of_turn 3 1e-4 1e-6 1e-8); do
    adams "a tolerance of $tolerance" "$(tables longest_step adams models/pendulum.scene adams announced "tolerance $tolerance")" "$forced"
    for size in 1e-10 1e-8 1e-7; do
        adams "and noise of $size" "$(tables noisy $size)" "$limit"
    done
done
finish
