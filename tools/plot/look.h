/* How a method is drawn: in the group of its family, in a colour and with a mark. All methods of core/methods/table.h are
 * known; a look differs from every other one. */
#ifndef ISO_TOOLS_PLOT_LOOK_H
#define ISO_TOOLS_PLOT_LOOK_H

#include <stddef.h>

typedef enum method_family { ONE_STEP, MULTISTEP, STIFF, VARYING_STEP, OTHERS, FAMILIES } method_family;

typedef struct look {
    const char *method;
    method_family family;
    const char *colour;
    int mark; /* gnuplot's pointtype */
} look;

/* The look of a method; `order` is its number among those of the picture, fewer than LOOKS_MOST. */
enum { LOOKS_MOST = 32 };
look look_of(const char *method, size_t order);

const char *family_name(method_family family);

#endif
