/* Random mechanisms, trees and closed loops, of all kinds of joints and closures: as tables of the independent
 * dynamics. One seed, one mechanism: the same on every machine. */
#ifndef ISO_TESTS_DYNAMICS_GENERATE_H
#define ISO_TESTS_DYNAMICS_GENERATE_H

#include "tests/isoc/dynamics/mechanism.h"

enum { GENERATED_INPUTS = 2, GENERATED_KINDS = 8, GENERATED_CLOSURES = 9 };

typedef struct generated {
    mechanism mechanism;
    joint_motion start; /* where the closures hold */
    int inputs;
    wide input[GENERATED_INPUTS]; /* held */
    const char *stabilisation;    /* of loops; NULL: the default */
    bool has_load;                /* the mass of the last body is a tunable */
    bool has_reach;               /* the length of the first closure, a distance, is one */
} generated;

static inline bool has_one_coordinate(const joint_kind kind)
{
    return kind == REVOLUTE || kind == PRISMATIC;
}

/* Whether coordinate k slides. */
static inline bool coordinate_slides(const joint_kind kind, const int k)
{
    return kind == PRISMATIC || (kind == CYLINDRICAL && k < 1) || (kind == PLANAR && k < 2) || (kind == FREE && k < 3);
}

/* Seeds from 1 on. Kind (seed - 1) % GENERATED_KINDS of joint is there and hangs on a moving body; in a loop, kind
 * (seed - 1) % GENERATED_CLOSURES of closure. False if none can be drawn. */
bool generate(bool closed, int seed, generated *out);

#endif
