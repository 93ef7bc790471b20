/* The cycles of a processor's instructions: a table of published timings, as text (cores/). */
#ifndef ISO_TOOLS_MEASURE_CYCLES_CORE_H
#define ISO_TOOLS_MEASURE_CYCLES_CORE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Cycles are counted in halves: a core that issues two instructions at once takes half of one for each. */
enum { HALVES = 2 };

/* From the least to the most that the manual allows, in half cycles. */
typedef struct bound {
    int32_t least, most;
} bound;

typedef enum kind { FLOAT, INTEGER, LOAD, STORE, MOVE, BRANCH, KINDS_OF_RULES } kind;

/* How an instruction uses its operands: the first is written, the others are read, if nothing else is said. */
enum {
    READS = 1 << 0, /* the first operand too is only read */
    BOTH = 1 << 1,  /* the first operand is read and written */
    TWO = 1 << 2,   /* the first two operands are written */
    STACK = 1 << 3, /* works at the stack pointer without naming it */
    CALLS = 1 << 4, /* keeps where to return to */
    RESTS = 1 << 5, /* waits for an interrupt */
    SKIPS = 1 << 6, /* instead of a branch: over one instruction, of whose words each takes a cycle */
    LEADS = 1 << 7, /* one that FOLLOWS directly, without its result in the address, takes a cycle less */
    FOLLOWS = 1 << 8
};

typedef struct rule {
    const char *names; /* of instructions, separated by spaces */
    const char *where; /* in the manual it stands */
    kind kind;
    bound cycles;
    bound each;           /* for each word of a list of registers, beside these */
    bound taken;          /* where another instruction follows than the next one */
    bound late;           /* how much later than the next instruction another can take the result */
    bound late_addressed; /* likewise, in an address */
    bound indexed;        /* beside the cycles, where two registers make the address */
    bound literal;        /* likewise, where the program counter does */
    unsigned use;         /* of these */
} rule;

typedef struct core {
    const char *name;
    const char *source; /* where its timings are published */
    const char *note;   /* a caution for a reader of the numbers */
    const char *stack;  /* the operand that stands for the stack */
    bool is_thumb;      /* instructions have conditions and sizes behind their names, and registers are r0, s0, d0 */
    rule *rules;
    size_t count;
} core;

/* Exits with a message if the file is no table of a core. */
core core_read(const char *path);

/* The rule of an instruction, by its name in a listing; NULL if there is none. */
const rule *core_rule(const core *c, const char *name);

#endif
