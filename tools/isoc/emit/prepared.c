#include "tools/isoc/emit/parts.h"

/* Whether the outputs of each tick have the states of the next step's first evaluation, in which all but little follows from
 * them. Clocks move between the two; a ladder has several derivatives; inlined calls share it already. */
static bool can_prepare(const plant *p, const graph *g)
{
    const mechanism *m = p->m;
    return ISO_TAKES_SUBSTEPS(m->method.recipe) && !p->is_flat && p->held.count == 0 && p->fast.count == 0 &&
           m->clocks.count == 0 && m->policies.rung_count == 0 && !has_slow_outputs(m) &&
           uses_operation(g, p->outputs.roots, (size_t)p->outputs.count, OP_DERIVATIVE);
}

/* Of which states the outputs ask for sine and cosine. */
static const bool *turned_by_outputs(const plant *p, const graph *g)
{
    bool *result = arena_take(g->memory, (size_t)state_count(p->m), sizeof *result);
    for (reached r = reach(g, p->outputs.roots, (size_t)p->outputs.count); reach_next(&r);) {
        if ((r.n->op == OP_SIN || r.n->op == OP_COS) && g->nodes[r.n->a].op == OP_STATE) {
            result[g->nodes[r.n->a].index] = true;
        }
    }
    return result;
}

const code_cut *cut_of(const plant *p, graph *g, const naming *names)
{
    enum { MOST = 3000, STATEMENTS_OF_ONE = 4 };
    text unused = {.memory = g->memory};
    const emission e = {.p = p, .g = g, .names = names, .out = &unused, .suffix = ""};
    if (!can_prepare(p, g)) {
        return NULL;
    }
    const code whole = derivative_code(&e);
    code_cut *result = arena_take(g->memory, 1, sizeof *result);
    double out_of_range_value;
    const code_pieces pieces = code_in_pieces(&whole, &out_of_range_value);
    *result = code_cut_by_states(&pieces, turned_by_outputs(p, g), state_count(p->m));
    result->out_of_range_value = out_of_range_value;
    return pieces.count <= MOST && result->statements >= STATEMENTS_OF_ONE * result->count ? result : NULL;
}

void emit_cut_derivative(emission *e)
{
    const code_cut *cut = e->names->cut;
    e->out_of_range_value = cut->out_of_range_value != 0.0 ? cut->out_of_range_value : e->out_of_range_value;
    put(e, "/* What follows from the states alone. */\n");
    put(e, "static void prepare(real *restrict const s, const real *restrict const x)\n{\n%s}\n\n", cut->of_states);
    put(e, "/* The rest of the derivative. */\n");
    emit_head(e, "", "complete", "dx", "", ", const real *restrict const s");
    emit_unread(e, cut->reads, "");
    put(e, "%s}\n\n", cut->rest);
    emit_head(e, "", "derivative", "dx", "", "");
    put(e, "    real s[%d];\n    prepare(s, x);\n    complete(dx, x, u, p, s);\n}\n\n", cut->count);
    put(e, "/* At the states of the memory, for which a step has prepared it. */\n");
    emit_head(e, "", "prepared_derivative", "dx", "", "");
    put(e, "    complete(dx, x, u, p, x + %s);\n}\n\n", method_state_size(e));
}

const char *const *prepared_turns(const emission *e)
{
    const code_cut *cut = e->names->cut;
    const int states = state_count(e->p->m);
    const char **result = arena_take(e->out->memory, (size_t)states, sizeof *result);
    for (int i = 0; cut != NULL && i < states; i++) {
        const int at = cut->turns[i];
        result[i] =
            at < 0 ? NULL : form(e, "x[%s + %d], x[%s + %d]", method_state_size(e), at, method_state_size(e), at + 1);
    }
    return cut == NULL ? NULL : result;
}

void emit_preparing_output(const emission *e)
{
    if (e->names->cut != NULL) {
        put(e, "/* For states that no step has made. */\nstatic void output(void *const instance)\n{\n");
        put(e, "    $p_memory *const memory = instance;\n");
        emit_preparing(e);
        put(e, "    prepared_output(instance);\n}\n\n");
    }
}

void emit_preparing(const emission *e)
{
    put_if(e, e->names->cut != NULL, "    prepare(memory->x + %s, memory->x);\n", method_state_size(e));
}
