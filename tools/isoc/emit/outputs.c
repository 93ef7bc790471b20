/* The outputs of a plant: one function for all, or for those of each rate, which a tick calls when they are due. */
#include "tools/isoc/emit/parts.h"

/* A function of this name that computes these outputs; `head` stands before it. */
static void emit_outputs_of(emission *e, const char *head, const char *function, const output_rate *o)
{
    assignments all = room_for(e->out->memory, o->count);
    for (int i = 0; i < o->count; i++) {
        const leaf_name *y = &e->names->y.leaves[o->which[i]];
        assign(&all, form(e, "y[%s]", y->place), y->quote, o->roots[i]);
    }
    code result = code_of_assignments(e, &all);
    result.turns = prepared_turns(e);
    const char *statements =
        emit_statements(e, form(e, "%s$s", function), form(e, "real *const y, %s", array_scope), &result);
    begin_function(e, form(e, "%sstatic void %s$s", head, function));
    put(e, "    real *const y = memory->y;\n");
    emit_arrays(e, &result, e->names->cut != NULL && e->p->held.count == 0 ? "derivative_prepared" : "derivative");
    put(e, "%s}\n\n", statements);
}

/* An output that is not due stays as it is. The branch follows from the number of the tick alone. */
static void emit_due(emission *e, const output_rates *rates)
{
    put(e, "/* Those of the end of a tick. */\nstatic void output_due$s(void *const instance)\n{\n");
    put(e, "    const $p_memory *const memory = instance;\n");
    for (int i = 0; i < rates->count; i++) {
        const row_rate rate = rates->all[i].rate;
        put_when_due(e, rate, form(e, "output_%s$s(instance);", rate_words(e->out->memory, rate)));
    }
    put(e, "}\n\n");
}

/* The outputs of a rate have a function of their own: two functions call it. */
void emit_output(emission *e)
{
    const output_rates rates = output_rates_of(e->p, e->out->memory);
    if (!has_slow_outputs(e->p->m)) {
        emit_outputs_of(e, "", e->names->cut == NULL ? "output" : "output_prepared", &rates.all[0]);
        emit_preparing_output(e);
        return;
    }
    for (int i = 0; i < rates.count; i++) {
        const char *words = rate_words(e->out->memory, rates.all[i].rate);
        emit_outputs_of(e, "ISO_APART ", form(e, "output_%s", words), &rates.all[i]);
    }
    put(e, "/* All of them, as at the start. */\nstatic void output$s(void *const instance)\n{\n");
    for (int i = 0; i < rates.count; i++) {
        put(e, "    output_%s$s(instance);\n", rate_words(e->out->memory, rates.all[i].rate));
    }
    put(e, "}\n\n");
    emit_due(e, &rates);
}
