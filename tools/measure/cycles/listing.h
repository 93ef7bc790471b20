/* A program as `objdump -d` lists it, with the cycles of each instruction on a core. */
#ifndef ISO_TOOLS_MEASURE_CYCLES_LISTING_H
#define ISO_TOOLS_MEASURE_CYCLES_LISTING_H

#include "tools/measure/cycles/core.h"

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

#endif
