/* Instructions and cycles of the calls of one function, by the functions that it calls. */
#ifndef ISO_TOOLS_MEASURE_CYCLES_WALK_H
#define ISO_TOOLS_MEASURE_CYCLES_WALK_H

#include "tools/measure/cycles/listing.h"

enum { PARTS_MOST = 64 };

/* The kinds of cycles: those of rules, beside these. */
enum { SPILL = KINDS_OF_RULES, WAIT, KINDS };

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
    int64_t sum;          /* half cycles at most, of all calls */
} walk_result;

/* Reads the trace to its end. All calls of the listing's entry that return count, each with the functions that it
 * calls. Exits with a message if an instruction has no rule. */
void walk(const walk_plan *plan, walk_result *result);

/* Of a call: all parts but that which is left out. */
amount call_total(const walk_plan *plan, const call *c);
amount part_total(const call *c, size_t number);

#endif
