/* Declarations shared by the files of `cycles`. */
#ifndef ISO_TOOLS_MEASURE_CYCLES_CYCLES_H
#define ISO_TOOLS_MEASURE_CYCLES_CYCLES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* core.c: the cycles of a processor's instructions: a table of published timings, as text (cores/). */

/* Cycles are counted in halves: a core that issues two instructions at once takes half of one for each. */
enum { HALVES = 2 };

/* From the least to the most that the manual allows, in half cycles. */
typedef struct bound {
    int32_t least, most;
} bound;

typedef enum kind { FLOAT, INTEGER, LOAD, STORE, MOVE, BRANCH, KINDS_OF_RULES } kind;

/* The kinds of cycles: those of rules, beside these. */
enum { SPILL = KINDS_OF_RULES, WAIT, KINDS };
extern const char *const kind_names[KINDS];

/* How an instruction uses its operands. By default the first is written, and the others are read. */
enum {
    READS = 1 << 0, /* the first operand too is only read */
    BOTH = 1 << 1,  /* the first operand is read and written */
    TWO = 1 << 2,   /* the first two operands are written */
    STACK = 1 << 3, /* works at the stack pointer without naming it */
    CALLS = 1 << 4, /* keeps where to return to */
    RESTS = 1 << 5, /* waits for an interrupt */
    SKIPS = 1 << 6, /* instead of a branch: over one instruction, of whose words each takes a cycle */
    LEADS = 1 << 7, /* one that FOLLOWS directly, without its result in the address, takes a cycle less */
    FOLLOWS = 1 << 8,
    WIDE = 1 << 9 /* the words of the first operand count as those of a list: s0 is one, d0 two */
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

/* Whether a name stands in a list with these separators; one that ends with * stands for all that begin so. */
bool is_listed(const char *names, const char *separators, const char *name);

/* listing.c: a program as `objdump -d` lists it, with the cycles of each instruction on a core. */

enum { NAME_CHARACTERS = 16, REGISTERS = 48 };

/* A set of registers: r0 to r15 are the bits 0 to 15, s0 to s31 those from 16 on. */
typedef uint64_t registers;

typedef struct instruction {
    const rule *rule;           /* NULL: the table of the core has none */
    uint32_t bytes;             /* 0: there is no instruction here */
    char name[NAME_CHARACTERS]; /* for messages */
    registers reads, writes, addresses;
    int32_t words;     /* registers of a list, each of 32 bits */
    int32_t pushes;    /* bytes that the stack grows by, beside register `grows_by` */
    int8_t grows_by;   /* the register that the stack pointer falls by, -1: none */
    int8_t loads;      /* the register that a constant is loaded into, -1: none */
    uint32_t constant; /* where that stands in the program */
    bool at_stack;     /* its address is at the stack pointer */
    bool is_indexed;   /* that has two registers */
    bool is_literal;   /* that is the program counter's */
    bool leaves;       /* returns from an interrupt, if it is in one */
    int8_t part;       /* that the function which begins here is of, from 1 on; 0: none that was asked for */
} instruction;

typedef struct listing {
    instruction *code;  /* by half of the address */
    uint32_t *constant; /* likewise: words in the text */
    uint32_t words;     /* of both */
    uint32_t entry;     /* of the function that was asked for; 0: it is not there */
} listing;

/* A set of functions that are counted together. */
typedef struct part {
    const char *name;
    const char *functions; /* separated by commas; NAME* stands for all that begin so */
} part;

/* Reads the output of objdump. The parts are those of instruction.part. Exits with a message if the file is no such
 * output, or has no function `entry`. */
listing listing_read(const char *path, const core *c, const char *entry, const part *parts, size_t count);

/* NULL beyond the program. */
const instruction *listing_at(const listing *l, uint32_t address);

/* operands.c: the registers that an instruction of Thumb reads and writes, and its change of the stack. */

/* From the text of the operands; the instruction has its name and its rule. */
void operands_of_thumb(const char *text, instruction *i);

/* trace.c: the trace of a simulator, instruction by instruction, from the standard input. */

typedef struct executed {
    uint32_t address;
    bool has_stack; /* whether the stack pointer is known */
    uint32_t stack; /* before it */
    uint64_t cycle; /* likewise; 0 where the simulator counts none */
} executed;

/* Of QEMU, with -singlestep -d nochain,exec, lines `Trace 0: 0x... [flags/address/...]`; of simavr (build/simavr_trace)
 * lines `=ADDRESS STACK CYCLE` in hexadecimal digits. Others are passed over. False at the end. */
bool trace_next(executed *e);

/* walk.c: instructions and cycles of the calls of one function, by the functions that it calls. */

enum { PARTS_MOST = 64 };

typedef struct amount {
    uint64_t instructions;
    int64_t least, most; /* half cycles */
    uint64_t counted;    /* cycles by the simulator; 0 where it counts none */
} amount;

typedef struct call {
    uint64_t number;                       /* from 1 on, in the order of the trace */
    amount amounts[PARTS_MOST + 1][KINDS]; /* of each part, from 1 on; 0 is the rest */
    amount interrupt;                      /* the dearest in it, which is no part of it */
    int32_t stack;                         /* bytes, at its deepest */
    int32_t stack_of[PARTS_MOST + 1];      /* likewise, of a part alone */
} call;

typedef struct walk_plan {
    const core *core;
    const listing *listing;
    const part *parts;
    size_t count;
    size_t left_out;  /* the number of the part that is not counted, from 1 on; 0: none */
    size_t interrupt; /* likewise, that of interrupts */
} walk_plan;

typedef struct walk_result {
    uint64_t calls;
    call last, dearest;
    uint64_t least, most; /* instructions of a call */
    uint64_t longest;     /* the number of the first call that takes so many */
    uint64_t all;         /* instructions of all calls */
    int64_t sum;          /* half cycles at most, of all calls */
} walk_result;

/* Reads the trace to its end. All calls of the listing's entry that return count, each with the functions that it
 * calls. Exits with a message if an instruction has no rule. */
void walk(const walk_plan *plan, walk_result *result);

/* Of a call: all parts but that which is left out. */
amount call_total(const walk_plan *plan, const call *c);
amount part_total(const call *c, size_t number);

#endif
