/* The outputs of a plant: one function for all, or for those of each rate, which a tick calls when they are due. */
#include "tools/isoc/emit/parts.h"
#include "tools/isoc/plant/rates.h"

/* A function of this name that computes these outputs; `head` stands before it. */
static void emit_outputs_of(emission *e, const char *head, const char *function, const output_rate *o)
{
    const char **targets = arena_take(e->out->memory, (size_t)o->count + 1, sizeof *targets),
               **quotes = arena_take(e->out->memory, (size_t)o->count + 1, sizeof *quotes);
    for (int i = 0; i < o->count; i++) {
        targets[i] = arena_format(e->out->memory, "y[%s]", e->names->outputs[o->which[i]]);
        quotes[i] = e->names->output_quotes[o->which[i]];
    }
    code result = code_of(e, targets, o->roots, o->count);
    result.quotes = quotes;
    text_add(e->out, "%sstatic void %s%s(void *const instance)\n{\n", head, function, e->suffix);
    text_add(e->out, "    %s_memory *const memory = instance;\n    real *const y = memory->y;\n", e->names->prefix);
    emit_arrays(e, &result);
    emit_code(e, &result);
    text_add(e->out, "}\n\n");
}

/* An output that is not due stays as it is. The branch follows from the number of the tick alone. */
static void emit_due(emission *e, const output_rates *rates)
{
    text_add(e->out, "/* Those of the end of a tick. */\nstatic void output_due%s(void *const instance)\n{\n",
             e->suffix);
    text_add(e->out, "    const %s_memory *const memory = instance;\n", e->names->prefix);
    for (int i = 0; i < rates->count; i++) {
        const double every = rates->all[i].every;
        if (every > 1.0) {
            text_add(e->out,
                     "    if (iso_tick_modulo(memory->row, UINT32_C(%.0f)) == 0) {\n        "
                     "output_every_%.0f%s(instance);\n    }\n",
                     every, every, e->suffix);
        } else {
            text_add(e->out, "    output_every_1%s(instance);\n", e->suffix);
        }
    }
    text_add(e->out, "}\n\n");
}

/* Those of a rate stand apart: two functions call them. */
void emit_output(emission *e)
{
    const output_rates rates = output_rates_of(e->p, e->out->memory);
    if (!has_slow_outputs(e->p->m)) {
        emit_outputs_of(e, "", "output", &rates.all[0]);
        return;
    }
    for (int i = 0; i < rates.count; i++) {
        emit_outputs_of(e, "ISO_APART ", arena_format(e->out->memory, "output_every_%.0f", rates.all[i].every),
                        &rates.all[i]);
    }
    text_add(e->out, "/* All of them, as at the start. */\nstatic void output%s(void *const instance)\n{\n", e->suffix);
    for (int i = 0; i < rates.count; i++) {
        text_add(e->out, "    output_every_%.0f%s(instance);\n", rates.all[i].every, e->suffix);
    }
    text_add(e->out, "}\n\n");
    emit_due(e, &rates);
}
