#include <string.h>

#include "tools/isoc/emit/parts.h"

void emit_calls_included(const text *rest, text *out)
{
    const char *last = "core/numbers/real.h"; /* which every other includes */
    for (operation op = 0; op < OPERATIONS; op++) {
        const operator_row *row = &operators[op];
        if (row->call != NULL && strcmp(row->header, "core/numbers/real.h") != 0 && strcmp(row->header, last) != 0 &&
            strstr(rest->bytes, row->call) != NULL) {
            text_add(out, "#include \"%s\"\n", row->header);
            last = row->header;
        }
    }
}

static bool uses_waveform(const emission *e)
{
    static const operation waveforms[] = {OP_FROM,  OP_SQUARE, OP_SQUARE_OF_PHASE, OP_CYCLE, OP_PRBS,
                                          OP_CHIRP, OP_LINES};
    const mechanism *m = e->p->m;
    bool any = keeps_rows(e->p);
    for (size_t i = 0; i < COUNT_OF(waveforms); i++) {
        any = any || uses_operation(e->g, m->inputs.drives, (size_t)m->inputs.count, waveforms[i]);
    }
    return any;
}

/* The methods of all steps, and what calls them. */
static void emit_methods(const emission *e)
{
    const mechanism *m = e->p->m;
    unsigned steps = 1U << ISO_METHOD_OF(m->method.recipe);
    steps |= has_events(m) ? 1U << ISO_METHOD_OF(m->events.rest) : 0U;
    for (int i = 0; i < m->policies.rung_count; i++) {
        steps |= m->policies.rungs[i] == ISO_METHODS ? 0 : 1U << ISO_METHOD_OF(m->policies.rungs[i]);
    }
    const char *rows = "";
    for (unsigned method = 0; method < ISO_METHODS; method++) {
        if ((steps & 1U << method) != 0) {
            const char *method_name = method_names[method];
            put(e, "#include \"core/methods/%s.h\"\n", method_name);
            rows = form(e, "%s X(r, ISO_%s, %s)", rows, capitals_of(e->out->memory, method_name), method_name);
        }
    }
    put(e, "#ifndef ISO_METHOD_LIST\n#define ISO_METHOD_LIST(X, r)%s\n#endif\n#include \"core/methods/%s.h\"\n", rows,
        ISO_IS_PRIMED(m->method.recipe) ? "primed" : "method");
}

static void emit_beginning(const emission *e, const text *rest)
{
    const mechanism *m = e->p->m;
    if (m->segment_count > 0) {
        put(e, "/* $p: equations of motion of a tree of %d joint%s. Made by isoc from %s.scene.\n *\n",
            m->segment_count, m->segment_count == 1 ? "" : "s", m->name);
        put(e, " * M(q) q'' + bias(q, q') = effort, solved for q''; all in SI units.\n */\n");
    } else {
        put(e, "/* $p: equations of effects alone, in SI units. Made by isoc from %s.scene. */\n", m->name);
    }
    put(e, "#include \"$p.h\"\n\n");
    emit_methods(e);
    put_if(e, e->p->fast.count > 0, "#include \"core/methods/multirate.h\"\n");
    put_if(e, has_events(m), "#include \"core/methods/event.h\"\n");
    put_if(e, strstr(rest->bytes, "iso_method_settled(") != NULL, "#include \"core/methods/settled.h\"\n");
    put(e, "%s",
        e->p->after.pivot_count == 0 ? ""
        : m->drift.near_holds        ? "#include \"core/methods/hold_energy.h\"\n"
                                     : "#include \"core/methods/pivots.h\"\n");
    put_if(e, e->p->j.looped != NULL, "#include \"core/methods/sparse.h\"\n");
    put(e, "%s#include \"core/runtime/tick.h\"\n", m->policies.any ? "#include \"core/runtime/policy.h\"\n" : "");
    put_if(e, m->parameters.change_count > 0, "#include \"core/runtime/changes.h\"\n");
    emit_calls_included(rest, e->out);
    put_if(e, e->names->is_checked, "#include \"core/numbers/self_check.h\"\n");
    put_if(e, strstr(rest->bytes, "iso_noise(") != NULL, "#include \"core/numbers/noise.h\"\n");
    put_if(e, uses_waveform(e), "#include \"core/numbers/waveform.h\"\n");
    put(e, "%s#include \"core/numbers/sincos.h\"\n%s\n",
        uses_time(e->g, m->inputs.drives, (size_t)(m->inputs.count + m->clocks.count))
            ? "#include \"core/numbers/signal.h\"\n"
            : "",
        e->p->rests.turn_count > 0 ? "#include \"core/numbers/turns.h\"\n" : "");
}

bool emit_source(const plant *p, graph *g, const naming *names, text *out, double *out_of_range_value)
{
    text rest = {.memory = out->memory};
    emission e = {.p = p, .g = g, .names = names, .out = &rest, .suffix = "", .in_step = true};
    e.out_of_range_value = out_of_range_value;
    *out_of_range_value = 0.0;
    emit_data(&e);
    emit_functions(&e);
    emit_step(&e);
    if (p->m->policies.any) {
        emit_policies(&e);
    }
    emit_model(&e);
    if (names->is_program) {
        emit_plant(&e);
    }
    e.out = out;
    emit_beginning(&e, &rest);
    text_add(out, "%s", rest.bytes);
    return *out_of_range_value == 0.0;
}
