/* The trace of a simulator, instruction by instruction, from the standard input. */
#ifndef ISO_TOOLS_MEASURE_CYCLES_TRACE_H
#define ISO_TOOLS_MEASURE_CYCLES_TRACE_H

#include <stdbool.h>
#include <stdint.h>

typedef struct executed {
    uint32_t address;
    bool has_stack; /* whether the stack pointer is known */
    uint32_t stack; /* before it */
    uint64_t cycle; /* likewise; 0 where the simulator counts none */
} executed;

/* Of QEMU, with -singlestep -d nochain,exec, lines `Trace 0: 0x... [flags/address/...]`; of simavr (build/simavr_trace)
 * lines
 * `=ADDRESS STACK CYCLE` in hexadecimal digits. Others are passed over. False at the end. */
bool trace_next(executed *e);

#endif
