#include "tools/isoc/plant/outputs.h"

#include "tools/isoc/dynamics/account.h"
#include "tools/isoc/plant/accelerations.h"

/* --- one function for each kind, or for a few that differ little --- */

typedef void show_function(plant *p, graph *g, const shown *o);

/* The unit of an output: a coordinate that turns has another than one that slides. */
static const char *unit_of(const plant *p, const shown *o)
{
    const output_row *row = &output_rows[o->kind];
    if (o->kind == OUTPUT_FORMULA) {
        return o->unit;
    }
    if (o->point_spring >= 0) {
        return row->unit;
    }
    const int index = o->closure >= 0 ? p->m->closures[o->closure].parent.segment : o->segment;
    return index >= 0 && slides(&p->m->segments[index]) ? row->unit : row->turning_unit;
}

static void show_as(plant *p, const shown *o, const char *label, node n)
{
    p->outputs.names[p->outputs.count] = label;
    p->outputs.units[p->outputs.count] = unit_of(p, o);
    p->outputs.shows[p->outputs.count] = o;
    p->outputs.roots[p->outputs.count++] = n;
}

static void show(plant *p, const shown *o, node n)
{
    show_as(p, o, o->name.text, n);
}

/* A vector, whole or along one axis. */
static void show_vector(plant *p, graph *g, const shown *o, vector v)
{
    for (int k = 0; k < 3; k++) {
        if (o->along < 0) {
            show_as(p, o, arena_format(g->memory, "%s_%c", o->name.text, "xyz"[k]), v.at[k]);
        } else if (o->along == k) {
            show(p, o, v.at[k]);
        }
    }
}

static void show_position(plant *p, graph *g, const shown *o)
{
    (void)g;
    show(p, o, p->d->k.motions[o->segment].q[0]);
}

static void show_speed(plant *p, graph *g, const shown *o)
{
    (void)g;
    show(p, o, p->d->k.motions[o->segment].qd[0]);
}

static void show_acceleration(plant *p, graph *g, const shown *o)
{
    show(p, o, leaf(g, OP_DERIVATIVE, p->m->position_count + p->m->segments[o->segment].dof));
}

static void show_turns(plant *p, graph *g, const shown *o)
{
    int index = 0;
    for (int i = 0; i < o->segment; i++) {
        index += p->m->segments[i].continuous;
    }
    show(p, o, leaf(g, OP_TURNS, index));
}

/* The point that an output is at, in the frame of its body's segment. */
static vector point_in_segment(const plant *p, graph *g, const shown *o)
{
    const body_frame *frame = &p->m->bodies.frames[o->body];
    return vector_add(g, matrix_apply(g, frame->turn, o->point), frame->offset);
}

static void show_point(plant *p, graph *g, const shown *o)
{
    show_vector(p, g, o,
                outward_point(&p->d->k, p->m->bodies.frames[o->body].segment, GROUND, point_in_segment(p, g, o)));
}

static void show_velocity(plant *p, graph *g, const shown *o)
{
    const int segment_shown = p->m->bodies.frames[o->body].segment;
    const vector velocity = point_velocity(&p->d->k, segment_shown, point_in_segment(p, g, o));
    show_vector(p, g, o, outward_axes(&p->d->k, segment_shown, GROUND, velocity));
}

/* The product of the orientations of all segments from the ground to the body. */
static void show_orientation(plant *p, graph *g, const shown *o)
{
    node q[4];
    body_orientation(&p->d->k, &p->m->bodies.frames[o->body], q);
    for (int i = 0; i < 4; i++) {
        show_as(p, o, arena_format(g->memory, "%s_%c", o->name.text, output_rows[o->kind].components[i]), q[i]);
    }
}

static void show_spin(plant *p, graph *g, const shown *o)
{
    const body_frame *frame = &p->m->bodies.frames[o->body];
    const vector omega = frame->segment == GROUND ? vector_zero(g) : p->d->k.motions[frame->segment].omega;
    show_vector(p, g, o, matrix_apply(g, matrix_transpose(frame->turn), omega));
}

static void show_force(plant *p, graph *g, const shown *o)
{
    show_vector(p, g, o, reaction_of(p, g, o->body, o->closure).force);
}

static void show_moment(plant *p, graph *g, const shown *o)
{
    show_vector(p, g, o, reaction_of(p, g, o->body, o->closure).moment);
}

static void show_effort(plant *p, graph *g, const shown *o)
{
    show(p, o,
         o->point_spring >= 0
             ? spring_tension(g, &p->m->forces.springs[o->point_spring], &p->d->springs[o->point_spring])
             : closure_effort(p->d, o->closure));
}

static void show_energy(plant *p, graph *g, const shown *o)
{
    (void)g;
    show(p, o, p->energy);
}

static void show_power(plant *p, graph *g, const shown *o)
{
    (void)g;
    show(p, o, account_power(p->d));
}

static void show_balance(plant *p, graph *g, const shown *o)
{
    (void)g;
    show(p, o, account_balance(p->d));
}

static void show_local_error(plant *p, graph *g, const shown *o)
{
    show(p, o, leaf(g, OP_LOCAL_ERROR, 0));
}

static void show_residual(plant *p, graph *g, const shown *o)
{
    show(p, o, leaf(g, OP_RESIDUAL, 0));
}

static void show_violation(plant *p, graph *g, const shown *o)
{
    (void)g;
    show(p, o, largest_violation(&p->d->k, &p->d->loops.held, false));
}

static void show_violation_rate(plant *p, graph *g, const shown *o)
{
    (void)g;
    show(p, o, largest_violation(&p->d->k, &p->d->loops.held, true));
}

/* What the multipliers leave of the closures' equations for the accelerations: rounding, but where an augmented Lagrangian
 * does not reach. */
static void show_violation_acceleration(plant *p, graph *g, const shown *o)
{
    const constraints *closures = &p->d->loops.held;
    node largest = constant(g, 0.0);
    graph_section(g, "Residuals of the closures' equations for the accelerations");
    for (int r = 0; r < closures->count; r++) {
        node left = demand_of(g, p->m, &closures->all[r]);
        for (int f = 0; f < p->m->dof_count; f++) {
            left = add(g, left, mul(g, closures->all[r].row[f], p->d->acceleration[f]));
        }
        largest = r == 0 ? magnitude(g, left) : larger(g, largest, magnitude(g, left));
    }
    show(p, o, largest);
}

static void show_formula(plant *p, graph *g, const shown *o)
{
    (void)g;
    show(p, o, o->formula);
}

static show_function *const functions[OUTPUT_ROWS] = {
    [OUTPUT_POSITION] = show_position,
    [OUTPUT_POINT] = show_point,
    [OUTPUT_SPEED] = show_speed,
    [OUTPUT_ACCELERATION] = show_acceleration,
    [OUTPUT_VELOCITY] = show_velocity,
    [OUTPUT_TURNS] = show_turns,
    [OUTPUT_ORIENTATION] = show_orientation,
    [OUTPUT_SPIN] = show_spin,
    [OUTPUT_FORCE] = show_force,
    [OUTPUT_MOMENT] = show_moment,
    [OUTPUT_EFFORT] = show_effort,
    [OUTPUT_ENERGY] = show_energy,
    [OUTPUT_POWER] = show_power,
    [OUTPUT_BALANCE] = show_balance,
    [OUTPUT_LOCAL_ERROR] = show_local_error,
    [OUTPUT_RESIDUAL] = show_residual,
    [OUTPUT_VIOLATION] = show_violation,
    [OUTPUT_VIOLATION_RATE] = show_violation_rate,
    [OUTPUT_VIOLATION_ACCELERATION] = show_violation_acceleration,
    [OUTPUT_FORMULA] = show_formula,
};

/* --- all of them --- */

void outputs_build(plant *p, graph *g)
{
    enum { MOST_COMPONENTS = 4 };
    const mechanism *m = p->m;
    const size_t room = MOST_COMPONENTS * m->output_count + 1;
    p->outputs.names = arena_take(g->memory, room, sizeof *p->outputs.names);
    p->outputs.units = arena_take(g->memory, room, sizeof *p->outputs.units);
    p->outputs.shows = arena_take(g->memory, room, sizeof *p->outputs.shows);
    p->outputs.roots = arena_take(g->memory, room, sizeof *p->outputs.roots);
    kinematics_velocities(&p->d->k);
    p->energy = account_energy(p->d);
    graph_section(g, "Points in the ground's frame");
    for (size_t i = 0; i < m->output_count; i++) {
        functions[m->outputs[i].kind](p, g, &m->outputs[i]);
    }
}
