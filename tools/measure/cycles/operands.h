/* The registers that an instruction of Thumb reads and writes, and its change of the stack. */
#ifndef ISO_TOOLS_MEASURE_CYCLES_OPERANDS_H
#define ISO_TOOLS_MEASURE_CYCLES_OPERANDS_H

#include "tools/measure/cycles/listing.h"

/* From the text of the operands; the instruction has its name and its rule. */
void operands_of_thumb(const char *text, instruction *i);

#endif
