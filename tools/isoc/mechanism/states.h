/* The states of a plant, in their order: what the equations, the header, the guard and the stream know of each. */
#ifndef ISOC_MECHANISM_STATES_H
#define ISOC_MECHANISM_STATES_H

#include "tools/isoc/mechanism/mechanism.h"

typedef enum state_kind {
    STATE_COORDINATE, /* of a joint: an angle or a distance */
    STATE_TURN,       /* an angle that is kept within a turn, its whole turns beside it */
    STATE_QUATERNION, /* a part of one: w, x, y, z */
    STATE_CLOCK,      /* that a motion is a function of; every tick sets it */
    STATE_OF_EFFECT,
    STATE_SPEED,
} state_kind;

typedef struct state {
    variable about; /* within its limits, or the guard stops the plant */
    state_kind kind;
    const char *symbol; /* in the equations */
    place at;           /* of the joint, the motion or the effect that has it */
} state;

/* All of them: state_count(m). Their starts are those of now: the assembly of closed loops moves them. */
const state *mechanism_states(const mechanism *m, arena *memory);

/* Notes names that two states have, or that differ only in case. */
void states_check(source *s, const mechanism *m);

/* The states at the start. */
double *mechanism_start(const mechanism *m, arena *memory);

#endif
