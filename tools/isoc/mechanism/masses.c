#include <string.h>

#include "tools/isoc/mechanism/builder.h"
#include "tools/isoc/scene/names.h"

bool is_of_effects(const builder *b, const formula *f)
{
    bool is = f != NULL && f->kind == FORMULA_NAME &&
              (strchr(f->name, '.') != NULL || INDEX_OF(b->written->signals, f->name) >= 0);
    for (size_t i = 0; f != NULL && i < f->count; i++) {
        is = is || is_of_effects(b, f->parts[i]);
    }
    return is;
}

node mass_of_effects(builder *b, const formula *f)
{
    LIST_ADD(b->s->memory, b->masses, f);
    return leaf(b->g, OP_MASS, (int)b->masses.count - 1);
}

/* Whether the mass follows from states of effects, constants and tunables alone; else notes a problem. The start of
 * such a state is a number from here on: what follows looks at the mass at the start. */
static bool follows_states(builder *b, const formula *f, node mass)
{
    mechanism *m = &b->mechanism;
    for (reached r = reach(b->g, &mass, 1); reach_next(&r);) {
        const operation op = r.n->op;
        const int of_effect = r.n->index - m->effects.first_state;
        const bool is_state = op == OP_STATE && of_effect >= 0 && of_effect < m->effects.state_count;
        if ((op == OP_STATE && !is_state) || op == OP_INPUT || op == OP_QUERY || op == OP_DERIVATIVE) {
            return source_problem(b->s, f->at,
                                  "a mass follows from states of effects, constants and tunables; this reads an input, "
                                  "a memory, time or a quantity of the mechanism: let a state follow that, or set a "
                                  "tunable, 'at 1 s set NAME = VALUE'");
        }
        if (is_state && !is_parametric(&b->values, m->effects.states[of_effect].begin)) {
            return source_problem(b->s, f->at, "the state '%s' gives a mass: it starts with constants and tunables",
                                  m->effects.states[of_effect].about.name);
        }
        if (is_state) {
            m->effects.states[of_effect].about.start = value_now(&b->values, m->effects.states[of_effect].begin);
        }
    }
    return true;
}

static void put_masses(graph *g, composite *own, replacement *r)
{
    node *const of_tensor[] = {&own->inertia.xx, &own->inertia.yy, &own->inertia.zz,
                               &own->inertia.xy, &own->inertia.xz, &own->inertia.yz};
    replace_more_leaves(g, &own->mass, 1, r);
    replace_more_leaves(g, own->ms.at, 3, r);
    for (size_t i = 0; i < COUNT_OF(of_tensor); i++) {
        replace_more_leaves(g, of_tensor[i], 1, r);
    }
}

void build_masses(builder *b)
{
    mechanism *m = &b->mechanism;
    if (b->masses.count == 0) {
        return;
    }
    node *masses = arena_take(b->s->memory, b->masses.count, sizeof *masses);
    b->values.around = b->around;
    for (size_t i = 0; i < b->masses.count; i++) {
        const formula *f = b->masses.all[i];
        const value found = value_of(&b->values, f, kilogram, 1, "a mass");
        masses[i] = found.count == 1 && follows_states(b, f, found.parts[0]) ? found.parts[0] : constant(b->g, 1.0);
    }
    b->values.around = NULL;
    m->bodies.vary = true;
    replacement all = {.op = OP_MASS, .by = masses};
    FOR_ALL (segment, l, m->segments, m->segment_count) {
        put_masses(b->g, &l->own, &all);
    }
    FOR_ALL (member, one, m->bodies.members, m->bodies.count) {
        put_masses(b->g, &one->own, &all);
    }
    replace_more_leaves(b->g, &m->bodies.ground_mass, 1, &all);
    replace_more_leaves(b->g, m->bodies.ground_moment.at, 3, &all);
}
