/* Effects whose states take sub-steps of their own in a step: core/methods/multirate.h. */
#include "tools/isoc/effects/effects.h"

enum { MOST_SUBSTEPS = 1000 };

/* The least number of sub-steps, and its multiples, whose ends have the stages of this method in a step; 0 where they
 * cannot be found so: the stages go forward, and the last one, which has a weight, ends the step. */
static int unit_of_substeps(unsigned recipe)
{
    const iso_tableau *table = iso_tableau_of(recipe);
    double before = 0.0;
    int least = 1;
    for (uint8_t i = 1; i + 1 < table->stages; i++) {
        const double at = iso_stage_at(table, i);
        const int multiple = least;
        int parts = 0; /* of the step, of which a_over are the whole */
        for (uint8_t j = 0; j < i; j++) {
            parts += table->a[i][j];
        }
        while (parts * least % table->a_over[i] != 0) {
            least += multiple;
        }
        if (at < before || at > 1.0) {
            return 0;
        }
        before = at;
    }
    return table->b[table->stages - 1] != 0 ? least : 0;
}

/* Notes a number of sub-steps that does not fit to a method of the scene. */
static void check_number(builder *b, place at, unsigned recipe)
{
    const int multiple = unit_of_substeps(recipe);
    const char *method = method_names[ISO_METHOD_OF(recipe)];
    if (multiple == 0) {
        source_problem(b->s, at, "the stages of %s are not in the order of time: leave out substeps, or take rk4",
                       method);
    } else if (b->mechanism.effects.fast_substeps % multiple != 0) {
        source_problem(b->s, at,
                       "with %s the number of sub-steps is a multiple of %d: a sub-step ends at each of its stages",
                       method, multiple);
    }
}

/* Notes features of the scene that a step of two rates does not have. */
static void check_method(builder *b, const effect_use *use)
{
    const unsigned recipe = b->mechanism.method.recipe;
    const place at = use->substeps->at;
    if (!ISO_IS_EXPLICIT(recipe)) {
        source_problem(b->s, at, "sub-steps of an effect are for the methods %s; with %s leave them out%s",
                       explicit_methods(b->s->memory), method_names[ISO_METHOD_OF(recipe)],
                       ISO_IS_IMPLICIT(recipe) ? ": it is stable without them" : "");
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
    const policies *ladder = &b->mechanism.policies;
    for (int i = -1; i < ladder->rung_count; i++) {
        const unsigned of_rung = i < 0 ? recipe : ladder->rungs[i];
        if (of_rung != ISO_METHODS && ISO_IS_EXPLICIT(of_rung)) {
            check_number(b, at, of_rung);
        }
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
