/* The equations of motion, as nodes: M(q) q'' + bias(q, q') + Phi_q' lambda = effort, Phi_q q'' = gamma.
 *
 * A tree of segments alone needs the first, which either formulation solves; closed loops need both, and the factors of
 * M (tools/isoc/closure/augmented.c).
 */
#ifndef ISOC_DYNAMICS_DYNAMICS_H
#define ISOC_DYNAMICS_DYNAMICS_H

#include "tools/isoc/closure/closure.h"

/* springs.c: springs and dampers between points, as nodes. With r from the first end to the second, d = |r| and d' =
 * r . r' / d, the tension is T = k (d - length) + c d'; a degree of freedom feels -T / d times g = r . dr/dq.
 *
 * 1 / d is finite for r = 0 (core/numbers/root.h), and r and g are zero there: a spring whose ends meet exerts no
 * force, and no number overflows on the way.
 */

typedef struct stretched {
    vector apart;                   /* r, in base axes */
    node square, inverse, distance; /* d^2, 1 / d, d */
    node rate;                      /* d' */
    node *row;                      /* [degrees of freedom] g */
    node by_length;                 /* T / d */
} stretched;

/* All springs of the mechanism. */
stretched *springs_build(const kinematics *k);

/* The force on the second end, in base axes; the first has the opposite. */
vector spring_force(graph *g, const stretched *s);

/* T, larger than zero where it pulls. */
node spring_tension(graph *g, const point_spring *p, const stretched *s);

/* Its potential energy. */
node spring_energy(graph *g, const point_spring *p, const stretched *s);

/* How the accelerations are found: from the factors of the mass matrix of composite bodies
 * (tools/isoc/tree/mass_matrix.c), or, of a tree, by articulated bodies (tools/isoc/tree/articulated.c). The closures
 * of loops, which are always composite, stand in the axes of their base, or of either side
 * (tools/isoc/closure/constraints.c); and where they are those of legs, they can be eliminated leg by leg
 * (tools/isoc/closure/legs.c).
 */
typedef enum formulation {
    FORMULATION_COMPOSITE,
    FORMULATION_ARTICULATED,
    FORMULATION_PARENT_AXES,
    FORMULATION_CHILD_AXES,
    FORMULATION_LEGS,
    FORMULATION_LEGS_IN_PARENT_AXES,
    FORMULATION_LEGS_IN_CHILD_AXES,
    FORMULATIONS
} formulation;

extern const char *const formulation_names[FORMULATIONS];

/* Whether the formulation is possible: some are for trees, some for closed loops. */
bool formulation_fits(const mechanism *m, formulation f);

/* Whether it eliminates closures leg by leg. */
bool formulation_is_by_legs(formulation f);

/* holds.c: the efforts of holds, as nodes: with the rows J of their speeds, the mobility A = J M^-1 J' and the
 * accelerations a of these speeds without holds, A effort = -a for those that are stuck, and a given effort of those
 * that slip. (core/methods/hold.h has the same for events.)
 */
typedef struct hold_equations {
    node *free;     /* [holds] a */
    node *mobility; /* [holds holds] A, with closures by what they leave */
    node *effort;   /* [holds] */
} hold_equations;

/* From x = D^-1 L'^-1 (effort - bias) to the same with the efforts of the holds. With closures, `loops`, x has their
 * part, and their multipliers get that of the holds; without them NULL. */
hold_equations holds_build(const mass_matrix *mass, augmented *loops, node *x);

/* x[degrees of freedom], changes of speeds, or of positions: that of a stuck one exactly zero, or that of the other
 * joint. */
void holds_stop(graph *g, const mechanism *m, node *x);

typedef struct dynamics {
    const mechanism *m;
    graph *g;
    kinematics k;
    mass_matrix mass;            /* where closures or an implicit method need it */
    acceleration *accelerations; /* of the segments, at q'' = 0 */
    node *acceleration;          /* [degrees of freedom] q'' */
    const stretched *springs;    /* between points */
    augmented loops;             /* without constraints where nothing is closed */
    hold_equations holds;
} dynamics;

/* A lower bound of the products that composite bodies cost in the accelerations of a tree; above `most` not the
 * largest. The graph stays as it is. */
int composite_products(const graph *g, const mechanism *m, int most);

/* Makes the nodes of the accelerations, in a formulation that fits. The parts have pointers to one another: the result
 * must not be copied. */
const dynamics *dynamics_build(graph *g, const mechanism *m, formulation chosen);

/* effort[degrees of freedom]: u - d q' - k (q - rest) + those of effects and of springs between points - bias. */
void efforts_less(const dynamics *d, const node *bias, node *effort);

/* reaction.c: reactions of joints and closures on their children, as nodes: force and moment in the ground's axes, the
 * moment about the origin of the joint's frame on the child.
 *
 * Of a joint it is all that passes through it: its constraint force, and the efforts of drive, damping and spring, gear
 * and motion. It is the wrench that the child needs for its motion, less all others on it: recursive
 * Newton-Euler with the accelerations that the mechanism has, over bodies, since the parameters of segments are
 * regrouped. Of a closure it is the sum of the wrenches of its constraints; a constraint that no joint changes has
 * none.
 */

/* Accelerations of the segments, from those that `derivative` returns; for joint_reaction. */
acceleration *reaction_accelerations(const dynamics *d);

/* The reaction of the joint whose child is body `index`. */
wrench joint_reaction(const dynamics *d, const acceleration *accelerations, int index);

wrench closure_reaction(const dynamics *d, int index);

/* The effort of a gear or a motion on its first joint, in N*m or N; a gear has -ratio times that on the second. Its one
 * constraint has the factor 1 in the first joint's row of M q'' + Phi_q' lambda = effort. */
node closure_effort(const dynamics *d, int index);

/* balance.c: the equations of motion before they are solved, as nodes: the forces minus the forces that given
 * accelerations q'' and multipliers lambda need,
 *
 *     left = effort - bias - M q'' - Phi_q' lambda    and    -(Phi_dd + Phi_q q'' + 2 alpha Phi' + beta^2 Phi),
 *
 * which is zero in the motion. Its derivatives take far fewer operations than those of the solution. */

typedef struct balance {
    int rows;                          /* degrees of freedom and constraints */
    node *left;                        /* [rows] by leaves OP_DERIVATIVE of the accelerations and OP_MULTIPLIER */
    node *weights;                     /* [rows rows] their coefficients: [M Phi_q'; Phi_q -1/penalty] */
    const acceleration *accelerations; /* [segments] accelerations of Newton-Euler, from segment to segment, outward */
    wrench *wrenches;                  /* [segments] and inward: of a segment with its descendants */
} balance;

balance balance_build(const dynamics *d);

/* resistance.c: the resistance to a push within a step, as nodes: the mass matrix; with an implicit method, its matrix
 *
 *     M - h b dQ/dq' - (h b)^2 dQ/dq,
 *
 * with the efforts Q of dampers, springs and effects, of which the symmetric part is taken.
 */

/* Factorised; d->mass itself where nothing is added to it. */
const mass_matrix *resistance_build(graph *g, const dynamics *d);

/* impulse.c: the speeds behind an impulse, as nodes. */

/* The speed of a degree of freedom, or the component of a velocity, behind an impulse on it. */
typedef struct given_speed {
    int dof;    /* or -1: */
    node speed; /* of this one, linear in the speeds of all joints */
    node to;
} given_speed;

/* [degrees of freedom] the speeds behind the impulse that gives some of them; -1 of one that does not change. */
node *impulse_build(const dynamics *d, const given_speed *wanted, int count);

/* phasors.c: nodes that turn with the positions, as sines and cosines of angles and of sums of angles do. */

/* With small changes of the states the node changes by rate times the other node of its pair, which changes by -rate
 * times this one. */
typedef struct phasor {
    node other; /* or -1: the node is of no pair */
    node rate;
} phasor;

/* The phasors of the first `count` nodes, where the states change by along[states]. */
phasor *phasors_find(graph *g, const node *along, size_t count);

/* settled.c: the states at the end of a step, from those that the method computed, as nodes: quaternions of length one,
 * and with projection, positions and speeds that satisfy the closures. Where sums are compensated, the changes of the
 * states, so that these are added with the compensation too: a sum that is rounded without it, once a step, would undo
 * its gain. With projection, also the pivots that it divides by. */

typedef struct settled {
    int count;
    int *states; /* which */
    node *values;
    node *equations; /* the values as equations of the states, also where `values` read kept factors */
    bool adds;       /* the values are added to the states */
    node *pivots; /* of each closure the product, where it varies, which each step compares (core/methods/pivots.h) */
    int *pivot_closures; /* whose */
    int pivot_count;
    node *factors; /* of the projection, and the pivots: nodes that the last stage of a step may have computed */
    int factor_count;
    node *kept; /* factors that the derivative keeps for the projection (tools/isoc/plant/kept.c) */
    int kept_count;
} settled;

settled settled_build(graph *g, const dynamics *d);

/* account.c: the account of energy, as nodes: the energy of the mechanism, and the power of all that changes it.
 *
 *     E = T + V + energy of springs and effects
 *     P = inputs - dampers + closures + effects
 *
 * In the motion E' = P. An effect that declares work and loss counts with work less loss, so that these must fit its
 * stored energy and its power on the mechanism. Another effect counts with its power on the mechanism and its stored
 * energy. A closure has -lambda Phi_q q': the power of a motion, and for other closures the power of a violated rate.
 *
 * All need kinematics_velocities.
 */

/* E: kinetic, of gravity (zero at the ground's origin), of the springs and of effects; and of it the kinetic energy and
 * that of springs, which is not negative. */
node account_energy(const dynamics *d);
node account_motion(const dynamics *d);

/* What becomes of E in an exact motion: it is constant where no input, damping, motion, effect, event or change of a
 * tunable has a part in it; only dampings let it fall; else it may do anything. */
typedef enum energy_course { ENERGY_STAYS, ENERGY_FALLS, ENERGY_UNKNOWN } energy_course;

energy_course account_course(const dynamics *d);

/* P. */
node account_power(const dynamics *d);

/* E' - P, with the derivatives of the states. */
node account_balance(const dynamics *d);

/* assembly.c: start values that satisfy the closures, computed at compile time. */

/* Newton's method moves the coordinates and speeds with no start, or a rough one, until the closures hold. Given starts
 * are kept, up to the rounding of their digits. Changes the segments' start and speed; the graph stays as it is. Notes
 * a problem with residual and rank if the closures cannot hold, if coordinates stay undetermined, or if constraints are
 * redundant and the stabilisation does not allow that. */
void assemble(source *s, const graph *g, const mechanism *m);

/* closing.c: Newton's method over the coordinates and speeds of closed loops, at compile time. */

typedef struct closing {
    const dynamics *d;
    const mechanism *m;
    const constraints *phi;
    arena *memory;
    double *x, *numbers; /* states, and the values of all nodes at them */
    double *jacobian;    /* [constraints][degrees of freedom] */
} closing;

/* The largest gap, its constraint, and the rank of the constraints in the free coordinates. */
typedef struct gap {
    double size;   /* m or rad, or per second */
    int row;       /* which constraint */
    int rank, all; /* for rates all constraints count, for positions those that constrain positions */
} gap;

/* Whether the constraint counts. */
bool closing_counts(const closing *c, bool rates, int row);

closing closing_start(arena *memory, const dynamics *d);

/* Evaluates all nodes and the Jacobian at c->x. */
void closing_evaluate(const closing *c);

/* A copy of c->x, and back to it. */
double *closing_keep(const closing *c);
void closing_restore(const closing *c, const double *kept);

/* Moves the positions, or the speeds, by a change of each degree of freedom. */
void closing_move(const closing *c, bool rates, const double *by);

/* The gap of a constraint, or its rate. */
double closing_gap(const closing *c, bool rates, int row);

/* Moves the free positions, or the free speeds, until the closures hold, as far as possible. */
gap closing_run(const closing *c, bool rates, const bool *is_free);

/* The same for positions, from their present values; if the gap stays above `enough`, also from other values. */
gap closing_search(const closing *c, const bool *is_free, double enough);

/* branches.c: where a loop can be assembled in several ways that meet: the constraints lose rank there. At compile
 * time. */

/* Returns how many coordinates are undetermined at the solution c->x: the freedoms of all that is_free. If none is, but
 * the constraints have lost rank, it is a multiple root: two ways to close the loops meet. Such a root is accurate only
 * to the square root of the rounding; it is moved to where the constraints lose rank. `meets` [degrees of freedom]
 * becomes true for those that take part in that. */
int branches_look(const closing *c, const bool *is_free, bool *meets);

/* The rank of the constraints' rates in all coordinates, at a position that is a little farther on. */
int branches_rank_nearby(const closing *c);

#endif
