#!/bin/sh
# make size and make stack: the double pendulum keeps its limits, and what breaks a limit or has no bound is found.
. tests/host/test.sh
. tests/host/project.sh
begin check/cost
project

call size && [ "$(value text | wc -w)" -gt 1 ]
expect $? "make size: the double pendulum's firmware keeps its limits"
call size TARGET=host && [ -n "$(value step_text)" ]
expect $? "make size: on the host as well"
call stack && [ "$(value stack_of_step)" -gt 0 ]
expect $? "make stack: the step's stack has a bound on the host"
call stack TARGET=cortex-m4f && [ "$(value stack_of_step)" -gt 0 ]
expect $? "make stack: and on the Cortex-M4F"

# size SYMBOL...: the verdict on a program of these sizes, given as lines of `nm -S`.
size()
{
    {
        printf '   text\t   data\t    bss\t    dec\t    hex\tfilename\n%s program\n' "$1"
        echo '00002000 A STACK_BYTES'
        echo '20000000 00000400 b trace_buffer'
        echo "00000100 $2 t step"
        echo "00000900 00000008 t derivative.constprop.0"
    } | awk -v limits=yes -f tools/build/size.awk >"$out/output" 2>"$out/errors"
}

size '8192 100 9628 0 0' 00000bf8
expect $? "at the limits: 8192 of text, 3072 of the step, 512 of data and bss"
! size '8193 100 9628 0 0' 00000bf8
expect $? "found: a byte of text too many"
! size '8192 100 9628 0 0' 00000bf9
expect $? "found: a byte of the step too many"
! size '8192 101 9628 0 0' 00000bf8
expect $? "found: a byte of data too many"
! awk -v limits=yes -f tools/build/size.awk </dev/null >/dev/null 2>"$out/errors"
expect $? "found: no sizes at all"

# deepest CODE: the verdict of make stack's second half on a step.
deepest()
{
    printf '%s\n' "$1" >"$out/step.c"
    $CC -std=c11 -O2 -fno-inline -fcallgraph-info=su -c "$out/step.c" -o "$out/step.o" &&
        awk -v root=step -f tools/build/stack.awk "$out/step.ci" >"$out/output" 2>"$out/errors"
}

deepest 'static int leaf(volatile int *p) { volatile int a[256]; a[9] = *p; return a[9]; }
    static int other(volatile int *p) { volatile int a[16]; a[9] = *p; return a[9]; }
    int step(volatile int *p); int step(volatile int *p) { return leaf(p) + other(p); }'
expect $? "a step that calls two functions has a bound"
# An x86-64 leaf may keep 128 bytes below its stack, which make stack turns off.
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
finish
