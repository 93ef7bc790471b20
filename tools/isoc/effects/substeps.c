/* Effects whose states take sub-steps of their own in a step: core/methods/multirate.h. */
#include "tools/isoc/mechanism/builder.h"

enum { MOST_SUBSTEPS = 1000 };

/* Whether the method, or a rung below it, has stages in the middle of a step. */
static bool has_middle(const mechanism *m)
{
    bool has = ISO_IS(m->method.recipe, ISO_RK4);
    for (int i = 0; i < m->policies.rung_count; i++) {
        has = has || (m->policies.rungs[i] != ISO_METHODS && ISO_IS(m->policies.rungs[i], ISO_RK4));
    }
    return has;
}

/* Notes features of the scene that a step of two rates does not have. */
static void check_method(builder *b, const effect_use *use)
{
    const unsigned recipe = b->mechanism.method.recipe;
    const place at = use->substeps->at;
    if (!ISO_TAKES_SUBSTEPS(recipe)) {
        source_problem(
            b->s, at, "sub-steps of an effect are for the methods euler, heun and rk4; with %s leave them out%s",
            method_names[ISO_METHOD_OF(recipe)], ISO_IS_IMPLICIT(recipe) ? ", as it holds what is fast by itself" : "");
    }
    if (ISO_IS_CHECKED(recipe)) {
        source_problem(b->s, at, "the local error is that of steps of one rate: leave out substeps, or the check");
    }
    for (size_t i = 0; i < b->written->inputs.count; i++) {
        if (b->written->inputs.all[i].smooth) {
            source_problem(b->s, b->written->inputs.all[i].name.at,
                           "a smooth input is for steps of one rate: let it be held, or leave out the substeps of '%s'",
                           use->name.text);
        }
    }
    if (b->mechanism.effects.fast_substeps % 2 != 0 && has_middle(&b->mechanism)) {
        source_problem(b->s, at, "rk4 needs an even number of sub-steps: half of them lead to the middle of the step");
    }
}

static bool has_states(const mechanism *m, int effect)
{
    bool has = false;
    for (int i = 0; i < m->effects.state_count; i++) {
        has = has || m->effects.states[i].effect == effect;
    }
    return has;
}

void build_substeps(builder *b)
{
    mechanism *m = &b->mechanism;
    m->effects.is_fast = arena_take(b->s->memory, (size_t)m->effects.count + 1, sizeof *m->effects.is_fast);
    for (int i = 0; i < m->effects.count; i++) {
        const effect_use *use = &b->written->effects.all[i];
        if (use->substeps == NULL || use->left_out || use->dropped || use->broken || b->is_effect_broken) {
            continue;
        }
        const size_t problems = b->s->problem_count;
        const int count =
            (int)whole_number(b, use->substeps, "the number of sub-steps of an effect", "", 2.0, 2.0, MOST_SUBSTEPS);
        if (b->s->problem_count > problems) {
            continue;
        }
        const bool is_first = m->effects.fast_substeps == 0;
        if (!has_states(m, i)) {
            source_problem(b->s, use->substeps->at,
                           "'%s' has no states, which alone take sub-steps: leave out substeps", use->name.text);
        } else if (!is_first && count != m->effects.fast_substeps) {
            source_problem(b->s, use->substeps->at,
                           "effects with sub-steps have the same number of them: another has %d",
                           m->effects.fast_substeps);
        } else {
            m->effects.is_fast[i] = true;
            m->effects.fast_substeps = count;
            if (is_first) {
                check_method(b, use);
            }
        }
    }
}
