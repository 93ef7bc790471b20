#include <string.h>

#include "tools/isoc/emit/parts.h"

/* Whether the outputs of each tick can have values in common with the next step's first evaluation, which has the same
 * states. Clocks move between the two, and events can; a ladder has several derivatives. */
static bool can_prepare(const plant *p)
{
    const mechanism *m = p->m;
    return ISO_IS_EXPLICIT(m->method.recipe) && p->fast.count == 0 && m->clocks.count == 0 && !has_events(m) &&
           m->policies.rung_count == 0 && !has_slow_outputs(m);
}

static bool outputs_derive(const plant *p, const graph *g)
{
    return uses_operation(g, p->outputs.roots, (size_t)p->outputs.count, OP_DERIVATIVE);
}

/* The derivative in two, where outputs ask for it; inlined calls share it already. NULL where it is not worth it. */
static code_cut *cut_derivative(const plant *p, graph *g, const naming *names)
{
    enum { MOST = 1200, STATEMENTS_OF_ONE = 4 };
    text unused = {.memory = g->memory};
    const emission e = {.p = p, .g = g, .names = names, .out = &unused, .suffix = ""};
    if (p->is_flat || p->held.count > 0 || !outputs_derive(p, g)) {
        return NULL;
    }
    code whole = derivative_code(&e);
    whole.turns = given_sines(&e, "sines[");
    code_cut *result = arena_take(g->memory, 1, sizeof *result);
    double out_of_range_value = 0.0;
    const code_pieces pieces = code_in_pieces(&whole, &out_of_range_value);
    *result = code_cut_by_states(&pieces, turned_states(g, p->m, p->outputs.roots, (size_t)p->outputs.count),
                                 state_count(p->m));
    result->out_of_range_value = out_of_range_value;
    return pieces.count <= MOST && result->statements >= STATEMENTS_OF_ONE * result->count ? result : NULL;
}

/* A derivative that is whole, and is given the sines of its angles, where outputs read some of these; else NULL. */
static code_cut *share_sines(const plant *p, graph *g)
{
    const bool *is_turned = turned_states(g, p->m, p->outputs.roots, (size_t)p->outputs.count);
    bool any = outputs_derive(p, g) && p->held.count == 0;
    for (int i = 0; i < p->angles.count; i++) {
        any = any || is_turned[p->angles.all[i]];
    }
    if (!any || p->angles.count == 0) {
        return NULL;
    }
    code_cut *result = arena_take(g->memory, 1, sizeof *result);
    result->turns = arena_take(g->memory, (size_t)state_count(p->m), sizeof *result->turns);
    memset(result->turns, -1, (size_t)state_count(p->m) * sizeof *result->turns);
    return result;
}

const code_cut *cut_of(const plant *p, graph *g, const naming *names)
{
    code_cut *result = can_prepare(p) ? cut_derivative(p, g, names) : NULL;
    return result == NULL && can_prepare(p) ? share_sines(p, g) : result;
}

/* The place of the prepared values behind the states in x: of the sines, or of the others behind these. */
static const char *prepared_place(const emission *e, const char *x, bool behind_sines)
{
    const int sines = behind_sines ? 2 * e->p->angles.count : 0;
    return form(e, sines > 0 ? "%s + %s + %d" : "%s + %s", x, method_state_size(e), sines);
}

void emit_derivative_at_sines(emission *e)
{
    const char *prefix = e->p->held.count > 0 ? "held_" : "";
    put(e, "/* At the states of the memory, of which a step has found the sines. */\n");
    put_if(e, e->p->is_flat, "ISO_INLINE iso_derivative derivative_prepared;\n");
    emit_head(e, "derivative_prepared", equation_parameters(e, "dx", ""));
    put(e, "    %sderivative_by_sines(dx, x, u, %s, %s, NULL);\n}\n\n", prefix, held_or_tunables(e),
        prepared_place(e, "x", false));
}

void emit_cut_derivative(emission *e)
{
    const code_cut *cut = e->names->cut;
    const bool by_sines = e->p->angles.count > 0;
    const char *sines = by_sines ? ", const real *restrict const sines" : "", *addition = by_sines ? ", sines" : "";
    const char *both = form(e, "    real s[%d];\n    prepare(s, x%s);\n    complete(dx, x, u, p, s%s);\n", cut->count,
                            addition, addition);
    *e->out_of_range_value = cut->out_of_range_value != 0.0 ? cut->out_of_range_value : *e->out_of_range_value;
    emit_angles(e);
    put(e, "/* What follows from the states alone. */\n");
    put(e, "static void prepare(real *restrict const s, const real *restrict const x%s)\n{\n%s}\n\n", sines,
        cut->of_states);
    put(e, "/* The rest of the derivative. */\n");
    const char *parameters = equation_parameters(e, "dx", form(e, ", const real *restrict const s%s", sines));
    emit_head(e, "complete", parameters);
    emit_unread(e, parameters, cut->rest);
    put(e, "%s}\n\n", cut->rest);
    if (by_sines) {
        emit_head(e, "derivative_by_sines", equation_parameters(e, "dx", sines_parameter(e)));
        put(e, "    (void)kept;\n%s}\n\n", both);
    }
    emit_head(e, "derivative", equation_parameters(e, "dx", ""));
    put_if(e, by_sines, "    real sines[%d];\n", 2 * e->p->angles.count);
    emit_found_sines(e, "x", "sines");
    put(e, "%s}\n\n", by_sines ? "    derivative_by_sines(dx, x, u, p, sines, NULL);\n" : both);
    put(e, "/* At the states of the memory, for which a step has prepared it. */\n");
    emit_head(e, "derivative_prepared", equation_parameters(e, "dx", ""));
    put(e, "    complete(dx, x, u, p, %s", prepared_place(e, "x", true));
    put_if(e, by_sines, ", %s", prepared_place(e, "x", false));
    put(e, ");\n}\n\n");
}

const char *const *prepared_turns(const emission *e)
{
    const code_cut *cut = e->names->cut;
    const int states = state_count(e->p->m);
    const char *const *sines = given_sines(e, form(e, "x[%s + ", method_state_size(e)));
    const char **result = arena_take(e->out->memory, (size_t)states, sizeof *result);
    for (int i = 0; cut != NULL && i < states; i++) {
        const int at = cut->turns[i] + 2 * e->p->angles.count;
        const char *kept = form(e, "x[%s + %d], x[%s + %d]", method_state_size(e), at, method_state_size(e), at + 1);
        result[i] = cut->turns[i] >= 0 ? kept : sines[i];
    }
    return cut == NULL ? NULL : result;
}

void emit_preparing_output(const emission *e)
{
    if (e->names->cut != NULL) {
        begin_function(e, "/* For states that no step has made. */\nstatic void output");
        emit_preparing(e);
        put(e, "    output_prepared(instance);\n}\n\n");
    }
}

void emit_preparing(const emission *e)
{
    if (e->names->cut != NULL) {
        const char *sines = prepared_place(e, "memory->x", false);
        emit_found_sines(e, "memory->x", sines);
        put_if(e, e->names->cut->of_states != NULL, "    prepare(%s, memory->x%s);\n",
               prepared_place(e, "memory->x", true), e->p->angles.count > 0 ? form(e, ", %s", sines) : "");
    }
}
