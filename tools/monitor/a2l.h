/* The quantities of a plant, by its A2L (ASAP2 1.6), as far as isoc writes it: quantities with their addresses, types,
 * units and limits. */
#ifndef ISO_TOOLS_MONITOR_A2L_H
#define ISO_TOOLS_MONITOR_A2L_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { A2L_TEXT_BYTES = 128 };

typedef enum a2l_type { A2L_FLOAT, A2L_DOUBLE, A2L_UNSIGNED, A2L_SIGNED } a2l_type;

typedef struct a2l_quantity {
    char name[A2L_TEXT_BYTES];
    char unit[A2L_TEXT_BYTES];
    double least, most;
    uint32_t address;
    a2l_type type;
    bool is_tunable;
} a2l_quantity;

typedef struct a2l {
    a2l_quantity *quantities; /* [count], in the order of the file */
    size_t count;
    double step; /* s; 0 where the file does not say it */
    char epk[A2L_TEXT_BYTES];
} a2l;

/* Reads a file. False: problem[] has FILE:LINE, the problem and the right form. */
bool a2l_read(a2l *to, const char *path, char *problem, size_t problem_bytes);

size_t a2l_bytes(a2l_type type);

/* The number that the bytes at `from` are. */
double a2l_value(a2l_type type, const uint8_t *from);

/* The quantity of a name, which may lack its prefix (`pole` for `y.pole`); NULL if there is none. */
const a2l_quantity *a2l_find(const a2l *in, const char *name);

#endif
