#include <math.h>

#include "tools/isoc/emit/emit.h"
#include "tools/isoc/emit/parts.h"

/* A quantity of an array: its place there, and what is known of it. */
typedef struct row {
    const char *place, *name, *unit, *quote;
    double least, most, start;
} row;

/* The quantities of one array. */
typedef struct table {
    const char *title; /* above its places */
    const char *what;  /* states */
    const row *rows;
    int count;
} table;

static const row *rows_of(arena *memory, const leaf_name *leaves, const variable *all, int count)
{
    row *rows = arena_take(memory, (size_t)count + 1, sizeof *rows);
    for (int i = 0; i < count; i++) {
        const variable *v = &all[i];
        rows[i] = (row){leaves[i].place, v->name, v->unit, v->quote, v->least, v->most, v->start};
    }
    return rows;
}

static const row *rows_of_states(const emission *e)
{
    const int count = state_count(e->p->m);
    variable *all = arena_take(e->out->memory, (size_t)count + 1, sizeof *all);
    for (int i = 0; i < count; i++) {
        all[i] = e->names->states[i].about;
    }
    return rows_of(e->out->memory, e->names->leaves.states, all, count);
}

static const row *rows_of_outputs(const emission *e)
{
    const plant *p = e->p;
    row *rows = arena_take(e->out->memory, (size_t)p->outputs.count + 1, sizeof *rows);
    for (int i = 0; i < p->outputs.count; i++) {
        rows[i] = (row){e->names->outputs[i],
                        p->outputs.names[i],
                        p->outputs.units[i],
                        e->names->output_quotes[i],
                        -HUGE_VAL,
                        HUGE_VAL,
                        0.0};
    }
    return rows;
}

/* The places in an array, each with its unit. */
static void emit_places(const emission *e, const table *t)
{
    text_add(e->out, "/* %s. */\nenum {\n", t->title);
    for (int i = 0; i < t->count; i++) {
        text_add(e->out, "    %s, /* %s */\n", t->rows[i].place, t->rows[i].unit);
    }
    text_add(e->out, "    %s_%s\n};\n\n", e->names->capitals, capitals_of(e->out->memory, t->what));
}

/* The memories of effects stand in u, behind the inputs. */
static void emit_memory_places(const emission *e)
{
    const mechanism *m = e->p->m;
    text_add(e->out, "/* Memories of effects, behind the inputs of u. */\nenum {\n");
    for (int i = 0; i < m->effects.memory_count; i++) {
        text_add(e->out, "    %s = %d, /* %s */\n", e->names->leaves.inputs[m->inputs.count + i].place,
                 m->inputs.count + i, m->effects.memories[i].about.unit);
    }
    text_add(e->out, "    %s = %d\n};\n\n", held_size(e), held_count(m));
}

/* A limit; none is the largest real. */
static const char *limit(const emission *e, double x)
{
    if (isinf(x)) {
        return x < 0.0 ? "-ISO_REAL_MAX" : "ISO_REAL_MAX";
    }
    return code_literal(e->out->memory, x, e->p->is_double);
}

/* Name, unit and limits of the quantities of an array, for programs that read them at run time. */
static void emit_table(const emission *e, const table *t)
{
    text_add(e->out, "static const iso_quantity %s_%s[%s_%s] = {\n", e->names->prefix, t->what, e->names->capitals,
             capitals_of(e->out->memory, t->what));
    FOR_ALL (const row, r, t->rows, t->count) {
        text_add(e->out, "    {\"%s\", \"%s\", %s, %s, %s},\n", r->name, r->unit, limit(e, r->least), limit(e, r->most),
                 code_literal(e->out->memory, r->start, e->p->is_double));
    }
    text_add(e->out, "};\n\n");
}

/* The function that joins model and memory to a plant. */
static void emit_instance(const emission *e)
{
    const mechanism *m = e->p->m;
    const char *prefix = e->names->prefix;
    const bool watched = ISO_IS_WATCHED(m->method.recipe);
    text_add(e->out, "extern const iso_model %s_model;\n\n", prefix);
    text_add(e->out, "/* A plant that keeps all in `memory`%s: iso_plant_start puts it to its start. */\n",
             watched ? ", and has room in `before` for a step that is made again" : "");
    text_add(e->out, "static inline iso_plant %s_plant(%s_memory *const memory%s%s%s)\n{\n", prefix, prefix,
             watched ? ", " : "", watched ? prefix : "", watched ? "_memory *const before" : "");
    text_add(e->out, "    const iso_plant plant = {\n        &%s_model,\n        memory,\n        memory->x,\n",
             prefix);
    text_add(e->out, "        %s,\n", held_count(m) > 0 ? "memory->u" : "NULL");
    text_add(e->out, "        %s,\n", m->parameters.count > 0 ? "memory->p" : "NULL");
    text_add(e->out, "        memory->y,\n        %s,\n", progress_of(m));
    text_add(e->out, "        %s,\n", e->p->after.pivot_count > 0 ? "&memory->nearness" : "NULL");
    text_add(e->out, "        %s,\n", ISO_IS_VARYING(m->method.recipe) ? "&memory->adams" : "NULL");
    text_add(e->out, "        %s,\n        memory->good,\n    };\n    return plant;\n}\n\n",
             watched ? "before" : "NULL");
}

/* The core's numbers must be the plant's. */
static void emit_check_of_real(const emission *e)
{
    const char *prefix = e->names->prefix;
    if (e->p->is_double) {
        text_add(e->out,
                 "#ifndef ISO_REAL_DOUBLE\n#error \"%s was made with --real double: compile all with "
                 "-DISO_REAL_DOUBLE\"\n#endif\n\n",
                 prefix);
    } else {
        text_add(e->out,
                 "#ifdef ISO_REAL_DOUBLE\n#error \"%s was made with --real float: compile all without "
                 "-DISO_REAL_DOUBLE\"\n#endif\n\n",
                 prefix);
    }
}

void emit_header(const plant *p, const naming *names, text *out)
{
    const mechanism *m = p->m;
    const emission e = {.p = p, .names = names, .out = out, .suffix = ""};
    const table tables[] = {
        {"States x", "states", rows_of_states(&e), state_count(m)},
        {"Inputs u", "inputs", rows_of(out->memory, names->leaves.inputs, m->inputs.all, m->inputs.count),
         m->inputs.count},
        {"Tunable parameters p", "parameters",
         rows_of(out->memory, names->leaves.parameters, m->parameters.all, m->parameters.count), m->parameters.count},
        {"Outputs y", "outputs", rows_of_outputs(&e), p->outputs.count},
    };
    const size_t count = sizeof tables / sizeof tables[0];
    text_add(
        out,
        "/* The plant of %s.scene, made by isoc: what stands where in its arrays, and its memory. In SI units. */\n",
        m->name);
    text_add(out, "#ifndef %s_H\n#define %s_H\n\n#include \"core/runtime/plant.h\"\n\n", names->capitals,
             names->capitals);
    emit_check_of_real(&e);
    text_add(out, "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
    for (size_t i = 0; i < count; i++) {
        if (tables[i].count > 0) {
            emit_places(&e, &tables[i]);
        }
    }
    if (m->effects.memory_count > 0) {
        emit_memory_places(&e);
    }
    text_add(out, "/* Name, unit, least, most and value at the start of each. */\n");
    for (size_t i = 0; i < count; i++) {
        if (tables[i].count > 0) {
            emit_table(&e, &tables[i]);
        }
    }
    emit_memory(&e);
    emit_instance(&e);
    text_add(out, "#ifdef __cplusplus\n}\n#endif\n\n#endif\n");
}
