#include "tools/isoc/emit/parts.h"

/* The quantities of one array. */
typedef struct array_rows {
    const char *title; /* above its places */
    const char *what;  /* states */
    const quantities *content;
} array_rows;

/* The places in an array, each with its unit, and their number; with numbers where they stand behind the inputs. */
static void emit_places(const emission *e, const array_rows *t, bool behind_inputs)
{
    const int inputs = e->p->m->inputs.count;
    if (t->content->count == 0) {
        return;
    }
    put(e, "/* %s. */\nenum {\n", t->title);
    for (int i = 0; i < t->content->count; i++) {
        put(e, "    %s%s, /* %s */\n", t->content->leaves[i].place, behind_inputs ? form(e, " = %d", inputs + i) : "",
            t->content->all[i].unit);
    }
    put(e, "    $C_%s%s\n};\n\n", capitals_of(e->out->memory, t->what),
        behind_inputs ? form(e, " = %d", inputs + t->content->count) : "");
}

/* Name, unit and limits of the quantities of an array, for programs that read them at run time. */
static void emit_table(const emission *e, const array_rows *t)
{
    if (t->content->count == 0) {
        return;
    }
    put(e, "static const iso_quantity $p_%s[$C_%s] = {\n", t->what, capitals_of(e->out->memory, t->what));
    FOR_ALL (const variable, v, t->content->all, t->content->count) {
        put(e, "    {\"%s\", \"%s\", %s, %s, %s},\n", v->name, v->unit, limit(e, v->least), limit(e, v->most),
            table_literal(e, v->start));
    }
    put(e, "};\n\n");
}

/* The function that joins model and memory to a plant. */
static void emit_instance(const emission *e)
{
    const mechanism *m = e->p->m;
    const bool watched = ISO_IS_WATCHED(m->method.recipe);
    put(e, "extern const iso_model $p_model;\n\n/* x' = f(x, u, p); only a program that asks for it has it. */\n");
    put(e, "extern iso_derivative *const $p_derivative;\n\n");
    put(e, "/* A plant that keeps all in `memory`%s: iso_plant_start puts it to its start. */\n",
        watched ? ", and has room in `before` for a step that is made again" : "");
    put(e, "static inline iso_plant $p_plant($p_memory *const memory%s%s)\n{\n", watched ? ", " : "",
        watched ? form(e, "$p_memory *const before") : "");
    put(e, "    const iso_plant plant = {\n        &$p_model,\n        memory,\n        memory->x,\n");
    put(e, "        %s,\n        %s,\n        memory->y,\n        %s,\n", held_count(m) > 0 ? "memory->u" : "NULL",
        m->parameters.count > 0 ? "memory->p" : "NULL", progress_of(m));
    put(e, "        %s,\n        %s,\n        %s,\n", e->p->after.pivot_count > 0 ? "&memory->nearness" : "NULL",
        has_events(m) ? "&memory->event_counts" : "NULL", ISO_IS_VARYING(m->method.recipe) ? "&memory->adams" : "NULL");
    put(e, "        %s,\n        memory->good,\n%s    };\n    return plant;\n}\n\n", watched ? "before" : "NULL",
        e->names->has_lanes ? form(e, "#ifdef ISO_LANES\n        NULL,\n        %s,\n#endif\n", lane_bytes(e)) : "");
}

/* The core's numbers must be the plant's. They are those of the first header of core in a file. */
static void emit_check_of_real(const emission *e)
{
    const bool is_double = e->p->is_double;
    put(e,
        "#if ISO_REAL_BITS != %d\n#error \"$p was made with --real %s: compile all %s -DISO_REAL_DOUBLE, and include "
        "no plant of %s in the same file\"\n#endif\n\n",
        is_double ? 64 : 32, is_double ? "double" : "float", is_double ? "with" : "without",
        is_double ? "float" : "double");
}

void emit_header(const plant *p, const naming *names, text *out)
{
    const mechanism *m = p->m;
    const emission emitted = {.p = p, .names = names, .out = out, .suffix = ""}, *e = &emitted;
    const array_rows tables[] = {
        {"States x", "states", &names->x},
        {"Inputs u", "inputs", &names->u},
        {"Tunable parameters p", "parameters", &names->p},
        {"Outputs y", "outputs", &names->y},
    };
    const array_rows memories = {"Memories of effects, behind the inputs of u", "held", &names->memories};
    put(e, "/* The plant of %s.scene, made by isoc: what stands where in its arrays, and its memory. In SI units. */\n",
        m->name);
    put(e, "#ifndef $C_H\n#define $C_H\n\n#include \"core/runtime/plant.h\"\n\n");
    emit_check_of_real(e);
    put(e, "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
    FOR_ALL (const array_rows, t, tables, COUNT_OF(tables)) {
        emit_places(e, t, false);
    }
    emit_places(e, &memories, true);
    put(e, "/* Name, unit, least, most and value at the start of each. */\n");
    FOR_ALL (const array_rows, t, tables, COUNT_OF(tables)) {
        emit_table(e, t);
    }
    emit_memory(e);
    emit_instance(e);
    put(e, "#ifdef __cplusplus\n}\n#endif\n\n#endif\n");
}
