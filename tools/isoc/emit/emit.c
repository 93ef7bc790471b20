#include "tools/isoc/emit/emit.h"

#include "tools/isoc/emit/parts.h"

bool is_driven(const mechanism *m)
{
    bool any = m->clocks.count + m->change_count > 0;
    for (int i = 0; i < m->input_count; i++) {
        any = any || m->driven[i];
    }
    return any;
}

static void emit_beginning(const emission *e)
{
    const mechanism *m = e->p->m;
    text_add(e->out, "/* %s: equations of motion of a tree of %d joint%s. Made by isoc from %s.scene.\n *\n",
             e->names->prefix, m->link_count, m->link_count == 1 ? "" : "s", m->name);
    text_add(e->out, " * M(q) q'' + bias(q, q') = effort, solved for q''; all in SI units.\n */\n");
    text_add(e->out, "#include \"%s.h\"\n\n", e->names->prefix);
    /* The functions of adams gcc inlines otherwise where it sees no other kernel: as many instructions, more bytes. */
    if (!ISO_IS_VARYING(m->recipe)) {
        text_add(e->out, "#define ISO_ONLY_METHOD ISO_%s\n",
                 capitals_of(e->out->memory, method_names[ISO_METHOD_OF(m->recipe)]));
    }
    text_add(e->out, "#include \"core/methods/method.h\"\n");
    text_add(e->out, "%s%s#include \"core/numbers/sincos.h\"\n%s\n",
             m->strut_count > 0 ? "#include \"core/numbers/root.h\"\n" : "",
             uses_time(e->g, m->drives, (size_t)(m->input_count + m->clocks.count))
                 ? "#include \"core/numbers/signal.h\"\n"
                 : "",
             e->p->turn_count > 0 ? "#include \"core/numbers/turns.h\"\n" : "");
}

bool emit_source(const plant *p, graph *g, const naming *names, text *out, double *culprit)
{
    emission e = {.p = p, .g = g, .names = names, .out = out};
    emit_beginning(&e);
    emit_data(&e);
    emit_functions(&e);
    emit_step(&e);
    emit_model(&e);
    if (names->is_program) {
        emit_plant(&e);
    }
    *culprit = e.culprit;
    return e.culprit == 0.0;
}
