#include "tools/isoc/plant/plant.h"

#include "tools/isoc/dynamics/reaction.h"
#include "tools/isoc/plant/cost.h"

static int turn_index(const mechanism *m, int link_wanted)
{
    int index = 0;
    for (int i = 0; i < link_wanted; i++) {
        index += m->links[i].continuous;
    }
    return index;
}

static node joint_output(const plant *p, graph *g, const output *o, int i)
{
    switch (o->kind) {
    case OUTPUT_POSITION:
        return p->d->k.motions[i].q[0];
    case OUTPUT_SPEED:
        return p->d->k.motions[i].qd[0];
    case OUTPUT_TURNS:
        return leaf(g, OP_TURNS, turn_index(p->m, i));
    default:
        return leaf(g, OP_DERIVATIVE, p->m->position_count + p->m->links[i].dof);
    }
}

static void add_output(plant *p, const char *label, node shown)
{
    p->output_names[p->output_count] = label;
    p->outputs[p->output_count++] = shown;
}

/* A vector, whole or along one axis. */
static void add_vector(plant *p, graph *g, const output *o, vector shown)
{
    for (int k = 0; k < 3; k++) {
        if (o->along < 0) {
            add_output(p, arena_format(g->memory, "%s_%c", o->name.text, "xyz"[k]), shown.at[k]);
        } else if (o->along == k) {
            add_output(p, o->name.text, shown.at[k]);
        }
    }
}

/* The orientation of a body as the product of those of all turns on the way to it. */
static void add_orientation(plant *p, graph *g, const output *o, const body_frame *frame)
{
    node q[4];
    body_orientation(&p->d->k, frame, q);
    for (int i = 0; i < 4; i++) {
        add_output(p, arena_format(g->memory, "%s_%c", o->name.text, "wxyz"[i]), q[i]);
    }
}

static void add_of_body(plant *p, graph *g, size_t i)
{
    const output *o = &p->m->outputs[i];
    const body_frame *frame = &p->m->frames[p->m->output_body[i]];
    const vector in_link = vector_add(g, matrix_apply(g, frame->turn, p->m->points[i]), frame->offset);
    if (o->kind == OUTPUT_ORIENTATION) {
        add_orientation(p, g, o, frame);
    } else if (o->kind == OUTPUT_SPIN) {
        const vector omega = frame->link == GROUND ? vector_zero(g) : p->d->k.motions[frame->link].omega;
        add_vector(p, g, o, matrix_apply(g, matrix_transpose(frame->turn), omega));
    } else if (o->kind == OUTPUT_POSITION) {
        add_vector(p, g, o, outward_point(&p->d->k, frame->link, GROUND, in_link));
    } else {
        const vector velocity = point_velocity(&p->d->k, frame->link, in_link);
        add_vector(p, g, o, outward_axes(&p->d->k, frame->link, GROUND, velocity));
    }
}

/* What a joint or a closure gives to its child. */
static void add_reaction(plant *p, graph *g, size_t i)
{
    const output *o = &p->m->outputs[i];
    const int body_shown = p->m->output_body[i], cut_shown = p->m->output_cut[i];
    wrench w;
    if (cut_shown >= 0) {
        w = closure_reaction(p->d, cut_shown);
    } else {
        p->accelerations = p->accelerations == NULL ? reaction_accelerations(p->d) : p->accelerations;
        graph_section(g, "Reactions");
        w = joint_reaction(p->d, p->accelerations, body_shown);
    }
    add_vector(p, g, o, o->kind == OUTPUT_FORCE ? w.force : w.moment);
}

static void build_outputs(plant *p, graph *g)
{
    const mechanism *m = p->m;
    kinematics_velocities(&p->d->k);
    const node energy = dynamics_energy(p->d);
    graph_section(g, "Points in the ground's frame");
    for (size_t i = 0; i < m->output_count; i++) {
        const output *o = &m->outputs[i];
        if (o->kind == OUTPUT_ENERGY) {
            add_output(p, o->name.text, energy);
        } else if (o->kind == OUTPUT_LOCAL_ERROR || o->kind == OUTPUT_RESIDUAL) {
            add_output(p, o->name.text, leaf(g, o->kind == OUTPUT_RESIDUAL ? OP_RESIDUAL : OP_LOCAL_ERROR, 0));
        } else if (o->kind == OUTPUT_VIOLATION || o->kind == OUTPUT_VIOLATION_RATE) {
            const bool of_rates = o->kind == OUTPUT_VIOLATION_RATE;
            add_output(p, o->name.text, largest_violation(&p->d->k, &p->d->loops.held, of_rates));
        } else if (o->kind == OUTPUT_FORCE || o->kind == OUTPUT_MOMENT) {
            add_reaction(p, g, i);
        } else if (o->kind == OUTPUT_EFFORT) {
            add_output(p, o->name.text, closure_effort(p->d, m->output_cut[i]));
        } else if (m->output_link[i] >= 0) {
            add_output(p, o->name.text, joint_output(p, g, o, m->output_link[i]));
        } else {
            add_of_body(p, g, i);
        }
    }
}

/* The derivative of the states, and what an implicit method solves with. */
static void build_derivatives(plant *p, graph *g, formulation chosen)
{
    const mechanism *m = p->m;
    p->derivatives = arena_take(g->memory, (size_t)state_count(m), sizeof *p->derivatives);
    p->d = dynamics_build(g, m, chosen);
    graph_section(g, "Rates of the positions");
    for (int i = 0; i < m->link_count; i++) {
        position_rates(&p->d->k, i, p->derivatives + m->links[i].position);
    }
    for (int i = 0; i < m->clocks.count; i++) {
        p->derivatives[m->clocks.first + i] = constant(g, m->clocks.all[i].rate);
    }
    for (int f = 0; f < m->dof_count; f++) {
        p->derivatives[m->position_count + f] = p->d->acceleration[f];
    }
    if (ISO_IS(m->recipe, ISO_SEMI_IMPLICIT) && m->position_count != m->dof_count) {
        p->rate_count = m->position_count;
    }
    if (ISO_IS_IMPLICIT(m->recipe)) {
        p->j = jacobian_build(g, p->d, p->derivatives);
    }
}

/* Builds every formulation that fits, each in a copy of the graph, and keeps the one that is wanted, or else the one
 * whose step takes least. */
static void build_cheapest(plant *p, graph *g, formulation wanted)
{
    const graph before = *g;
    const plant bare = *p;
    choice made = {.kept = FORMULATIONS};
    graph kept = before;
    int least = 0;
    for (formulation f = 0; f < FORMULATIONS; f++) {
        if (!formulation_fits(p->m, f)) {
            continue;
        }
        plant tried = bare;
        *g = graph_copy(&before);
        build_derivatives(&tried, g, f);
        made.of[f] = count_operations(g, tried.derivatives, (size_t)state_count(p->m));
        const int price = cycles_of(cost_of_step(&tried, g));
        if (f == wanted || (wanted == FORMULATIONS && (made.kept == FORMULATIONS || price < least))) {
            *p = tried;
            made.kept = f;
            kept = *g;
            least = price;
        }
    }
    *g = kept;
    p->formulations = made;
}

plant plant_build(graph *g, const mechanism *m, bool is_double, formulation wanted)
{
    plant p = {.m = m, .input_count = m->input_count, .is_double = is_double};
    p.output_names = arena_take(g->memory, 4 * m->output_count + 1, sizeof *p.output_names);
    p.outputs = arena_take(g->memory, 4 * m->output_count + 1, sizeof *p.outputs);
    for (int i = 0; i < m->link_count; i++) {
        p.turn_count += m->links[i].continuous;
    }
    build_cheapest(&p, g, wanted);
    p.after = settled_build(g, p.d);
    build_outputs(&p, g);
    p.violation = m->violation_limit > 0.0 && p.d->loops.held.count > 0
                      ? largest_violation(&p.d->k, &p.d->loops.held, false)
                      : -1;
    return p;
}
