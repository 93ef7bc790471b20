#include "tools/isoc/mechanism/builder.h"

static state state_of(state_kind kind, const char *called, const char *in, const char *quote, place at)
{
    return (state){.about = unlimited(called, in, quote), .kind = kind, .at = at};
}

/* A position has the name of its segment; the parts of a quaternion have an ending too. */
static void add_positions(const mechanism *m, const segment *l, arena *memory, state *all)
{
    static const char *const parts[] = {"w", "x", "y", "z"};
    const char *quote = source_quote(m->source, l->at);
    for (int n = 0; n < positions_of(l->kind); n++) {
        state *result = &all[l->position + n];
        if (l->kind == JOINT_SPHERICAL) {
            *result = state_of(STATE_QUATERNION, arena_format(memory, "%s_%s", l->name, parts[n]), "1", quote, l->at);
        } else {
            *result = state_of(l->continuous ? STATE_TURN : STATE_COORDINATE, l->name,
                               l->kind == JOINT_REVOLUTE ? "rad" : "m", quote, l->at);
        }
        /* The sine of an angle is taken, which has a domain. */
        if (result->kind == STATE_COORDINATE && l->kind == JOINT_REVOLUTE) {
            result->about.least = -largest_angle;
            result->about.most = largest_angle;
        }
        result->about.start = l->start[n];
        result->symbol = arena_format(memory, "q_%s", result->about.name);
    }
}

/* A speed has the name of its degree of freedom, with an ending. */
static void add_speeds(const mechanism *m, const segment *l, arena *memory, state *all)
{
    const char *quote = source_quote(m->source, l->at);
    for (int n = 0; n < dofs_of(l->kind); n++) {
        const char *called = m->dofs[l->dof + n].name;
        state *result = &all[m->position_count + l->dof + n];
        *result = state_of(STATE_SPEED, arena_format(memory, "%s_speed", called),
                           l->kind == JOINT_PRISMATIC ? "m/s" : "rad/s", quote, l->at);
        result->about.start = l->speed[n];
        result->symbol = arena_format(memory, "qd_%s", called);
    }
}

const state *mechanism_states(const mechanism *m, arena *memory)
{
    state *all = arena_take(memory, (size_t)state_count(m) + 1, sizeof *all);
    for (int i = 0; i < m->segment_count; i++) {
        add_positions(m, &m->segments[i], memory, all);
        add_speeds(m, &m->segments[i], memory, all);
    }
    for (int i = 0; i < m->clocks.count; i++) {
        state *result = &all[m->clocks.first + i];
        *result = state_of(STATE_CLOCK, arena_format(memory, "clock_%d", i + 1), m->clocks.all[i].unit, NULL,
                           m->clocks.all[i].at);
        result->about.start = m->clocks.all[i].start;
        result->symbol = arena_format(memory, "q_%s", result->about.name);
    }
    for (int i = 0; i < m->effects.state_count; i++) {
        state *result = &all[m->effects.first_state + i];
        *result = (state){.about = m->effects.states[i].about, .kind = STATE_OF_EFFECT, .at = m->effects.states[i].at};
        result->symbol = arena_format(memory, "z_%s", result->about.name);
    }
    return all;
}

name_list names_of_states(source *s, const mechanism *m)
{
    const state *all = mechanism_states(m, s->memory);
    name_list names = {0};
    for (int i = 0; i < state_count(m); i++) {
        listing_add(s, &names, (name){all[i].about.name, all[i].at});
    }
    return names;
}

void states_check(source *s, const mechanism *m)
{
    name_list names = names_of_states(s, m);
    listing_check(s, &names);
}

double *mechanism_start(const mechanism *m, arena *memory)
{
    const state *all = mechanism_states(m, memory);
    double *x = arena_take(memory, (size_t)state_count(m) + 1, sizeof *x);
    for (int i = 0; i < state_count(m); i++) {
        x[i] = all[i].about.start;
    }
    return x;
}

double input_in_row(const mechanism *m, int input, double drive)
{
    const variable *v = &m->inputs.all[input];
    return m->inputs.driven[input] ? fmin(fmax(drive, v->least), v->most) : v->start;
}

double *inputs_at_start(const graph *g, const mechanism *m)
{
    const size_t count = (size_t)m->inputs.count;
    double *u = arena_take(g->memory, (size_t)held_count(m) + 1, sizeof *u);
    node *drives = arena_take(g->memory, count + 1, sizeof *drives);
    graph part = graph_part(g, m->inputs.drives, count, drives);
    double *numbers = arena_take(g->memory, part.count + 1, sizeof *numbers);
    graph_evaluate(&part, 0, &(evaluation){.p = m->parameters.at_start}, numbers);
    for (int i = 0; i < m->inputs.count; i++) {
        u[i] = input_in_row(m, i, numbers[drives[i]]);
    }
    for (int i = 0; i < m->effects.memory_count; i++) {
        u[m->inputs.count + i] = m->effects.memories[i].about.start;
    }
    arena_return(g->memory, numbers, part.count + 1, sizeof *numbers);
    arena_return(g->memory, drives, count + 1, sizeof *drives);
    graph_free(&part);
    return u;
}

evaluation start_of(const graph *g, const mechanism *m)
{
    return (evaluation){.x = mechanism_start(m, g->memory), .u = inputs_at_start(g, m), .p = m->parameters.at_start};
}

double *numbers_at_start(const graph *g, const mechanism *m)
{
    const evaluation at = start_of(g, m);
    double *numbers = arena_take(g->memory, g->count, sizeof *numbers);
    graph_evaluate(g, 0, &at, numbers);
    return numbers;
}

void note_built_in(const graph *g, const mechanism *m, const node *roots, size_t count)
{
    mark_leaves(g, roots, count, OP_PARAMETER, m->parameters.is_built_in);
}
