#include "tools/isoc/plant/plant.h"

static const char *without_history(unsigned recipe)
{
    return ISO_IS_IMPLICIT(recipe) ? "rosenbrock" : "rk4";
}

static void check_inputs(const source *s, const scene *written, unsigned recipe)
{
    const char *method = method_names[ISO_METHOD_OF(recipe)];
    FOR_EACH (const quantity, q, written->inputs) {
        if (!q->smooth && ISO_PAST_KEPT(recipe) > 0) {
            source_warn(s, q->name.at,
                        "the input '%s' is held, and %s has a history: where the input changes at every tick, %s is of "
                        "order %s; take %s, or 'input %s smooth' for samples of a continuous signal",
                        q->name.text, method, method, ISO_IS_VARYING(recipe) ? "two" : "one", without_history(recipe),
                        q->name.text);
            return;
        }
        if (q->smooth && ISO_IS_CHECKED(recipe) && ISO_TELLS_NO_INPUTS(recipe)) {
            source_warn(s, q->name.at,
                        "the local error that %s tells is without that of the extrapolated input '%s'; take %s", method,
                        q->name.text, ISO_IS_IMPLICIT(recipe) ? "rosenbrock" : "abm4");
            return;
        }
    }
}

/* A function that jumps starts a new history at each jump; all others change at every tick. */
static bool is_restarting(const char *word)
{
    const function_row *row = function_called(word);
    return row != NULL && row->kind == OF_JUMPS;
}

/* The first function of time that these depend on, given that of each input and memory in `known`; -1: none. */
static int time_input_called(const graph *g, const node *roots, size_t count, const int *known)
{
    int first = -1;
    for (reached r = reach(g, roots, count); reach_next(&r);) {
        const int index = r.n->op == OP_INPUT ? known[r.n->index] : -1;
        first = index >= 0 && (first < 0 || index < first) ? index : first;
    }
    return first;
}

/* A memory depends on one if another does that it follows: as many passes as that takes. */
static void check_time_inputs(const source *s, const graph *g, const plant *p)
{
    const mechanism *m = p->m;
    int *known = arena_take(g->memory, (size_t)held_count(m) + 1, sizeof *known);
    for (int i = 0; i < held_count(m); i++) {
        const int index = i < m->inputs.count ? m->inputs.time_input_of[i] : -1;
        known[i] = index >= 0 && !is_restarting(m->inputs.time_inputs[index].word) ? index : -1;
    }
    for (bool more = true; more;) {
        more = false;
        for (int i = 0; i < m->effects.memory_count; i++) {
            int *index = &known[m->inputs.count + i];
            const int found = *index < 0 ? time_input_called(g, &m->effects.memories[i].next, 1, known) : -1;
            more = more || found >= 0;
            *index = found >= 0 ? found : *index;
        }
    }
    const int which = time_input_called(g, p->derivatives, (size_t)state_count(m), known);
    if (which >= 0) {
        const char *method = method_names[ISO_METHOD_OF(m->method.recipe)];
        const time_input_origin *index = &m->inputs.time_inputs[which];
        const char *effect = index->origin.text;
        const char *where = effect == NULL ? "" : arena_format(g->memory, " of the effect '%s'", effect);
        source_warn(
            s, index->origin.at,
            "the %s%s changes at every tick and is held in between, and %s has a history: %s is of order %s; take %s",
            index->word, where, method, method, ISO_IS_VARYING(m->method.recipe) ? "two" : "one",
            without_history(m->method.recipe));
    }
}

/* A delay of a moving quantity of which the steps have no samples. */
static void check_delays(const source *s, const mechanism *m)
{
    for (int i = 0; i < m->effects.memory_count; i++) {
        if (m->effects.memories[i].lags) {
            source_warn(s, m->effects.memories[i].at,
                        "this delay is constant within a step, and so half a step longer in the mean: to act at each "
                        "stage it is of states alone, without inputs and memories, in a scene without sub-steps and "
                        "without a ladder");
        }
    }
}

void samples_check(const source *s, const graph *g, const scene *written, const plant *p)
{
    check_inputs(s, written, p->m->method.recipe);
    check_delays(s, p->m);
    if (ISO_PAST_KEPT(p->m->method.recipe) > 0 && p->m->inputs.time_input_count > 0) {
        check_time_inputs(s, g, p);
    }
}
