/* The mechanisms of models/NAME.scene, typed anew; each program links one. */
#ifndef ISO_TESTS_DYNAMICS_TABLES_H
#define ISO_TESTS_DYNAMICS_TABLES_H

#include <stddef.h>

#include "tests/isoc/dynamics/mechanism.h"

/* A number of the table that the comparison must notice when it is a little off. */
typedef struct table_control {
    const char *name;
    size_t offset; /* of a wide in the mechanism */
} table_control;

typedef struct table {
    mechanism mechanism;
    int inputs;
    bool overconstrained; /* it moves only because its lengths are exact */
    double spread;        /* rad and tenths of m: how far from the scene's start states are drawn, with closures */
    int controls;
    table_control control[8];
} table;

extern const table the_table;

#endif
