/* Reference solutions: a start, and the solution at some times. */
#ifndef ISO_TESTS_REFERENCE_REFERENCE_H
#define ISO_TESTS_REFERENCE_REFERENCE_H

enum { REFERENCE_STATES_MAX = 4, REFERENCE_ROWS_MAX = 6 };

typedef struct reference_row {
    int ms; /* time in milliseconds */
    long double y[REFERENCE_STATES_MAX];
} reference_row;

typedef struct reference_case {
    const char *name;
    long double start[REFERENCE_STATES_MAX];
    int rows;
    reference_row row[REFERENCE_ROWS_MAX];
} reference_case;

/* The cases of one plant; the program links one set. */
typedef struct reference_set {
    int states;
    int cases;
    const reference_case *first;
    /* The plant's state x of the reference's coordinates y. */
    void (*to_plant)(long double *x, const long double *y);
} reference_set;

extern const reference_set the_reference;

#endif
